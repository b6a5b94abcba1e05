"""Set-up as it is shown: scans against the map."""

"""Set-up of robots: commands, laser scans and planned paths."""

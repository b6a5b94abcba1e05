"""`fleet-tui status`: the fleet as a table or as JSON."""

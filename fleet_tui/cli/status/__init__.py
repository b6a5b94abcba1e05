"""The `status` command: the fleet as a table or as JSON."""

"""Output to the terminal: only changed cells, and none while it does not read."""

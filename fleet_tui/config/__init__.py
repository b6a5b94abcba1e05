"""The configuration: its structure, checks and search paths."""

"""The `graph` commands: lint, diff, convert and show graph files."""

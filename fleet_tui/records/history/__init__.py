"""The history of a fleet on disk: SQLite, one writer, many readers."""

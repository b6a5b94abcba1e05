"""What is kept on disk of what happened: the audit log, written, read back and exported."""

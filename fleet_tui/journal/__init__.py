"""What is kept on disk of what happened: the audit log and recordings, written, read back and exported."""

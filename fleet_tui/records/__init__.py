"""What consoles keep on disk: audit log, desk, history, recordings."""

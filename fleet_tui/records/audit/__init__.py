"""The audit log: written, searched, exported."""

"""Decisions about graphs as documents: edits, checks, differences. Checks need numpy: import them late."""

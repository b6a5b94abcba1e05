"""Decisions about graphs as documents: edits, checks, differences."""

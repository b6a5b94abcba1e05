"""Rows of the diagnostics pages."""

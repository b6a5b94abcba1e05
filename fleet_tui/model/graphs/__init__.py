"""Graphs as documents: to be edited, checked, and written to files."""

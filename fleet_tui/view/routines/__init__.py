"""Routines as lines and rows."""

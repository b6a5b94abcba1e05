"""Recordings: written while the fleet is watched, indexed, read back."""

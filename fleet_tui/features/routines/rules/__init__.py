"""Decisions about routines: reading them, checking them, the next step of each robot."""

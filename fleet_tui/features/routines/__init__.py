"""Routines: files of instructions for robots, checked, run, and owned by one process."""

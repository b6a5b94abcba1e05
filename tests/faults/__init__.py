"""Faults between a console and its robots, one test for each (docs/faults.md)."""

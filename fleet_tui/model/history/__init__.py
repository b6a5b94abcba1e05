"""The history of a fleet."""

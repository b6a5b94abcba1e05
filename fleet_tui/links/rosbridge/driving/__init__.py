"""Driving by hand over a connection of its own."""

"""Vehicles that a master control moves over nodes."""

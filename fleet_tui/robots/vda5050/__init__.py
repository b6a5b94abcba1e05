"""Vehicles of VDA 5050: versions 1.1 to 3.0 read and paused, 1.1 to 2.1 ordered."""

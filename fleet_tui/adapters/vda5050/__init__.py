"""Vehicles of VDA 5050: versions 1.1 to 3.0 read, 1.1 to 2.1 commanded."""

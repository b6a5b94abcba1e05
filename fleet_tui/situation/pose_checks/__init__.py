"""Localisation of robots: the match of a scan with the map, jumps of a pose."""

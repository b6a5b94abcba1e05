"""Screens: the main screen and the overlays over its map."""

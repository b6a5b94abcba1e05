"""Overlays about the selected robot."""

"""The occupancy map as the ground of the picture."""

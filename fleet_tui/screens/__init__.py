"""The rooms: the main screen and what opens over its map."""

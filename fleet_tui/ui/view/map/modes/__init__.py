"""Map modes: the effect of keys and mouse on the map, extra layers, and the caption."""

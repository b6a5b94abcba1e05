"""The style of the map's dots."""

from enum import Enum


class Drawing(Enum):
    """Dots per cell of the map: 2 x 4, 2 x 2 blocks folded to 1 x 2, or 1."""

    BRAILLE = "braille"
    HALF_BLOCK = "half-block"
    ASCII = "ascii"

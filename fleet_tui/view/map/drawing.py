"""The ways to draw the map."""

from enum import Enum


class Drawing(Enum):
    """The drawing mode of the map: dots per cell 2 x 4, 2 x 2 blocks folded to 1 x 2, or 1."""

    BRAILLE = "braille"
    HALF_BLOCK = "half-block"
    ASCII = "ascii"

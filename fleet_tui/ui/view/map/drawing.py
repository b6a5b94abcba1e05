"""The style of the map's dots."""

from enum import Enum

from fleet_tui.text.language import N_


class Drawing(Enum):
    """Dots per cell of the map: 2 x 4, 2 x 2 blocks folded to 1 x 2, or 1."""

    BRAILLE = N_("braille")
    HALF_BLOCK = N_("half-block")
    ASCII = N_("ascii")

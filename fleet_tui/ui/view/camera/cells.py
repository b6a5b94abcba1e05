"""Pictures as half blocks in 256 colours, or as a ramp of characters."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from fleet_tui.ui.view.map.cells import Codes

Pixels = NDArray[np.uint8]
"""Shape (height, width, 3); every cell shows two lines of them."""

RAMP = " .:-=+*#%@"
"""Characters from dark to bright."""
_LETTERS = np.array([ord(letter) for letter in RAMP], np.uint32)
_CUBE = np.array([0, 95, 135, 175, 215, 255])
_BETWEEN = (_CUBE[:-1] + _CUBE[1:]) / 2
_TINTED = 42  # difference of red, green and blue below which a colour is grey, as for the themes
_LUMA = np.array([0.299, 0.587, 0.114])


class PictureCells(NamedTuple):
    """Characters, and for each the numbers of its colours, of shape (height, width, 2): the upper half's and
    the lower half's. None: the terminal's own."""

    codes: Codes
    colours: NDArray[np.uint8] | None


def half_blocks(pixels: Pixels) -> PictureCells:
    """Return two pixels a cell, one above the other."""
    numbers = colour_numbers(_even(pixels))
    upper, lower = numbers[0::2], numbers[1::2]
    codes = np.where(upper == lower, ord(" "), ord("▀")).astype(np.uint32)
    return PictureCells(codes, np.stack((upper, lower), axis=-1))


def ramp(pixels: Pixels) -> PictureCells:
    """Return the brightness of two pixels a cell, stretched over the whole ramp."""
    even = _even(pixels) @ _LUMA
    bright = (even[0::2] + even[1::2]) / 2
    low, high = bright.min(), max(bright.max(), bright.min() + 1.0)
    steps = ((bright - low) / (high - low) * (len(RAMP) - 1)).round().astype(np.intp)
    return PictureCells(_LETTERS[steps], None)


def _even(pixels: Pixels) -> Pixels:
    """Return pixels with an even number of lines: the last one twice if need be."""
    return np.concatenate((pixels, pixels[-1:])) if len(pixels) % 2 else pixels


def colour_numbers(pixels: Pixels) -> NDArray[np.uint8]:
    """Return the nearest of the 240 fixed colours of a 256-colour terminal, as the themes' colours are
    reduced."""
    parts: NDArray[Any] = pixels.astype(np.int32)
    is_grey = np.ptp(parts, axis=-1) < _TINTED
    parts[is_grey] = np.rint(parts[is_grey].sum(axis=-1) / 3).astype(np.int32)[:, np.newaxis]
    cube = np.digitize(parts, _BETWEEN, right=True)
    grey = np.clip(np.rint((parts.sum(axis=-1) / 3 - 8) / 10), 0, 23).astype(np.int32)
    in_cube = ((_CUBE[cube] - parts) ** 2).sum(axis=-1)
    in_greys = ((8 + 10 * grey[..., np.newaxis] - parts) ** 2).sum(axis=-1)
    numbers = np.where(in_greys < in_cube, 232 + grey, 16 + cube @ np.array([36, 6, 1]))
    found: NDArray[np.uint8] = numbers.astype(np.uint8)
    return found

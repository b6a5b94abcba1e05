"""Pictures in cells: the same colours as the themes', and brightness where there are none."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from rich.color_triplet import ColorTriplet

from fleet_tui.ui.terminal.sgr import nearest
from fleet_tui.ui.view.camera.cells import RAMP, colour_numbers, half_blocks, ramp

PARTS = st.integers(0, 255)


@given(PARTS, PARTS, PARTS)
def test_a_colour_is_the_one_that_a_theme_would_get(red: int, green: int, blue: int) -> None:
    pixels = np.array([[[red, green, blue]]], np.uint8)
    assert int(colour_numbers(pixels)[0, 0]) == nearest(ColorTriplet(red, green, blue))


def test_a_cell_has_two_pixels_and_an_odd_line_is_doubled() -> None:
    pixels = np.zeros((3, 2, 3), np.uint8)
    pixels[0, 0] = 255
    found = half_blocks(pixels)
    assert found.colours is not None and found.colours.shape == (2, 2, 2)
    assert found.colours[0, 0].tolist() == [231, 16] and found.codes.tolist() == [
        [ord("▀"), ord(" ")],
        [ord(" "), ord(" ")],
    ]


def test_without_colours_brightness_is_a_character() -> None:
    pixels = np.zeros((2, 10, 3), np.uint8)
    pixels[:] = np.linspace(40, 200, 10, dtype=np.uint8)[:, np.newaxis]
    found = ramp(pixels)
    assert "".join(map(chr, found.codes[0])) == RAMP and found.colours is None
    assert {chr(code) for code in ramp(np.full((2, 3, 3), 9, np.uint8)).codes[0]} == {" "}

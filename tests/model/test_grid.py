"""Sizes and resolutions that no map can have are refused before any memory is taken."""

import math

import pytest

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import MAX_PIXELS, check_frame
from fleet_tui.text.errors import MapError

ORIGIN = Pose(0.0, 0.0)


def test_a_usual_one_is_fine() -> None:
    check_frame(MapFrame(0.05, 1, 1, ORIGIN))


@pytest.mark.parametrize(
    ("resolution", "width", "height", "words"),
    [
        (0.0, 9, 9, "must be above 0"),
        (-1.0, 9, 9, "must be above 0"),
        (math.nan, 9, 9, "must be above 0"),
        (0.05, 0, 9, "both must be at least 1"),
        (0.05, 9, -1, "both must be at least 1"),
        (0.05, MAX_PIXELS, 2, f"exceeds {MAX_PIXELS:,} px"),
    ],
)
def test_one_that_can_not_be_is_named(resolution: float, width: int, height: int, words: str) -> None:
    with pytest.raises(MapError, match=words):
        check_frame(MapFrame(resolution, width, height, ORIGIN))

"""A picture placed by two points a known distance apart."""

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from fleet_tui.maps.placing import COARSEST, FINEST, placed
from fleet_tui.model.geometry import MapFrame
from fleet_tui.text.errors import MapError

PICTURE = MapFrame(1.0, 800, 400)
columns, rows = st.floats(0.0, 800.0), st.floats(0.0, 400.0)
metres = st.floats(-1e4, 1e4)


@given(
    st.tuples(columns, rows),
    st.tuples(columns, rows),
    st.floats(0.01, 1e4),
    st.tuples(metres, metres),
    st.floats(-360.0, 360.0),
)
def test_the_points_are_where_they_were_said_to_be(
    one: tuple[float, float],
    other: tuple[float, float],
    distance: float,
    at: tuple[float, float],
    heading: float,
) -> None:
    if math.dist(one, other) < 1.0:
        with pytest.raises(MapError, match="at least a pixel apart"):
            placed(PICTURE, (one, other), distance, at, heading)
        return
    assume(FINEST <= distance / math.dist(one, other) <= COARSEST)
    frame = placed(PICTURE, (one, other), distance, at, heading)
    there, beyond = frame.to_world(*one), frame.to_world(*other)
    turn = math.radians(heading)
    wanted = at[0] + distance * math.cos(turn), at[1] + distance * math.sin(turn)
    near = 1e-6 * max(1.0, distance)
    assert math.dist(there, at) < near and math.dist(beyond, wanted) < near


def test_without_a_place_its_corner_is_the_origin_and_it_is_not_turned() -> None:
    frame = placed(PICTURE, ((50.0, 50.0), (750.0, 50.0)), 35.0)
    assert (frame.resolution, frame.to_world(0.0, 400.0)) == (0.05, (0.0, 0.0))
    assert frame.origin.yaw == 0.0


@pytest.mark.parametrize(
    ("points", "distance", "words"),
    [
        (((0.0, 0.0), (801.0, 0.0)), 1.0, "point 801, 0 is not in the picture of 800 x 400 px"),
        (((0.0, 0.0), (8.0, 0.0)), 0.0, "must be from 0.0008 to 800 m, not 0"),
        (((0.0, math.nan), (8.0, 0.0)), 1.0, "point 0, nan is not in the picture"),
        (((0.0, 0.0), (8.0, 0.0)), math.inf, "must be from 0.0008 to 800 m, not inf"),
    ],
)
def test_what_gives_no_scale_is_said(
    points: tuple[tuple[float, float], tuple[float, float]], distance: float, words: str
) -> None:
    with pytest.raises(MapError, match=words):
        placed(PICTURE, points, distance)

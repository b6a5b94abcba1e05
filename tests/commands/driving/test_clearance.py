"""The clearance ahead: from the footprint to the next cell that is not free, whichever way it moves."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from fleet_tui.commands.driving.clearance import FAR, clearance
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import FREE, OCCUPIED, UNKNOWN, OccupancyGrid
from fleet_tui.model.occupancy import build_grid
from fleet_tui.model.set_up.driving import Speeds

SIZE = (0.6, 0.4)
MIDDLE = 5.0


def hall(resolution: float = 0.05, wall_from: float = 8.0, kind: int = OCCUPIED) -> OccupancyGrid:
    """Return ten by ten metres of free floor with a wall across, from some metres of x on."""
    cells = round(10.0 / resolution)
    classes = np.full((cells, cells), FREE, np.uint8)
    classes[:, round(wall_from / resolution) :] = kind
    return build_grid(MapFrame(resolution, cells, cells), classes)


@pytest.mark.parametrize("resolution", [0.01, 0.05, 0.1])
@pytest.mark.parametrize("kind", [OCCUPIED, UNKNOWN])
@pytest.mark.parametrize(
    ("yaw", "speeds"),
    [
        (0.0, Speeds(0.1)),
        (math.pi, Speeds(-0.1)),
        (math.pi / 2, Speeds(0.0, -0.1)),
        (-math.pi / 2, Speeds(0.0, 0.1, 0.3)),
    ],
)
def test_a_wall_is_measured_from_the_side_that_moves(
    resolution: float, kind: int, yaw: float, speeds: Speeds
) -> None:
    half = (SIZE[0] if speeds.ahead else SIZE[1]) / 2
    found = clearance(hall(resolution, kind=kind), Pose(7.0, MIDDLE, yaw), SIZE, speeds)
    assert found == pytest.approx(1.0 - half, abs=1.1 * resolution)


def test_a_wall_beside_or_behind_is_not_ahead() -> None:
    for yaw in (math.pi / 2, math.pi):
        assert clearance(hall(), Pose(7.0, MIDDLE, yaw), SIZE, Speeds(0.1)) == FAR


def test_a_wall_is_met_slantwise_at_the_corner() -> None:
    found = clearance(hall(), Pose(7.0, MIDDLE), (0.4, 0.4), Speeds(0.1, 0.1))
    assert found == pytest.approx(0.8 * math.sqrt(2), abs=0.1)


def test_contact_is_no_clearance_and_beyond_the_map_is_unknown() -> None:
    assert clearance(hall(), Pose(7.8, MIDDLE), SIZE, Speeds(0.1)) == 0.0
    assert clearance(hall(), Pose(0.5, MIDDLE, math.pi), SIZE, Speeds(0.1)) == pytest.approx(0.2, abs=0.06)
    assert clearance(hall(), Pose(-50.0, -50.0), SIZE, Speeds(0.1)) == 0.0


def test_turning_alone_or_no_place_has_none() -> None:
    assert clearance(hall(), Pose(7.0, MIDDLE), SIZE, Speeds(turning=0.5)) is None
    assert clearance(hall(), Pose(math.nan, MIDDLE), SIZE, Speeds(0.1)) is None


@given(st.floats(-math.pi, math.pi), st.floats(0.3, 9.7), st.floats(-1, 1), st.floats(-1, 1), st.booleans())
def test_it_is_the_same_however_the_map_lies(
    yaw: float, x: float, ahead: float, sideways: float, added: bool
) -> None:
    grid, sign = hall(), -1.0 if added else 1.0
    turned = OccupancyGrid(MapFrame(0.05, 200, 200, Pose(sign * 3.0, sign * -2.0, 0.7), added), grid.levels)
    straight = clearance(grid, Pose(x, MIDDLE, yaw), SIZE, Speeds(ahead, sideways))
    # Along a wall half a cell decides between contact and free.
    sizes = [(SIZE[0] + more, SIZE[1] + more) for more in (-0.05, 0.05)]
    others = [clearance(grid, Pose(x, MIDDLE, yaw), size, Speeds(ahead, sideways)) for size in sizes]
    assume(straight is None or all(one is None or abs(straight - one) < 0.1 for one in others))
    place = Pose(3.0, -2.0, 0.7).after(Pose(x, MIDDLE, yaw))
    found = clearance(turned, place, SIZE, Speeds(ahead, sideways))
    assert found == (None if straight is None else pytest.approx(straight, abs=0.06))

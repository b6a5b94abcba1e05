"""Plans of floors as occupancy grids."""

import math

import numpy as np
import pytest

from fleet_tui.simulator.floorplan import FREE, HEIGHT, OCCUPIED, ORIGIN, RESOLUTION, UNKNOWN, WIDTH
from fleet_tui.simulator.warehouse import SimEdge, SimFloor, build_floor

CLEARANCE = 0.3  # metres


def around(floor: SimFloor, x: float, y: float) -> set[int]:
    """The values of all cells whose middle is nearer than CLEARANCE to a point."""
    column, row = (x - ORIGIN[0]) / RESOLUTION, (y - ORIGIN[1]) / RESOLUTION
    reach = CLEARANCE / RESOLUTION
    left, bottom = math.floor(column - reach), math.floor(row - reach)
    assert left >= 0 and bottom >= 0 and column + reach < WIDTH and row + reach < HEIGHT
    size = math.ceil(2 * reach) + 1
    return set(np.unique(floor.cells[bottom : bottom + size, left : left + size]).tolist())


def points_of(floor: SimFloor, edge: SimEdge) -> list[tuple[float, float]]:
    start, end = floor.graph.vertices[edge.start], floor.graph.vertices[edge.end]
    count = math.ceil(math.dist((start.x, start.y), (end.x, end.y)) / RESOLUTION)
    parts = [i / count for i in range(count + 1)]
    return [(start.x + part * (end.x - start.x), start.y + part * (end.y - start.y)) for part in parts]


@pytest.fixture(params=range(5))
def floor(request: pytest.FixtureRequest) -> SimFloor:
    return build_floor(request.param)


def test_every_edge_lies_on_free_cells(floor: SimFloor) -> None:
    for edge in floor.graph.edges:
        for x, y in points_of(floor, edge):
            assert around(floor, x, y) == {FREE}, (edge, x, y)


def test_a_floor_has_walls_free_ground_and_places_nobody_has_seen(floor: SimFloor) -> None:
    shares = {value: float(np.mean(floor.cells == value)) for value in (UNKNOWN, FREE, OCCUPIED)}
    assert sum(shares.values()) == pytest.approx(1.0)
    assert shares[FREE] > 0.5
    assert shares[OCCUPIED] > 0.05
    assert shares[UNKNOWN] > 0.05
    assert set(floor.cells[0].tolist()) == {UNKNOWN}

"""The warehouse must be drivable: what the graph promises, the map must allow."""

import math
from collections import Counter

import numpy as np
import pytest

from fleet_tui.simulator.floorplan import FREE, HEIGHT, OCCUPIED, ORIGIN, RESOLUTION, UNKNOWN, WIDTH
from fleet_tui.simulator.graph import SimEdge
from fleet_tui.simulator.warehouse import SimFloor, build_building, build_floor

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


def test_every_vertex_is_reached_from_the_first(floor: SimFloor) -> None:
    first = min(floor.graph.vertices)
    assert all(floor.graph.path(first, vertex) for vertex in floor.graph.vertices)


def test_a_floor_has_walls_free_ground_and_places_nobody_has_seen(floor: SimFloor) -> None:
    shares = {value: float(np.mean(floor.cells == value)) for value in (UNKNOWN, FREE, OCCUPIED)}
    assert sum(shares.values()) == pytest.approx(1.0)
    assert shares[FREE] > 0.5
    assert shares[OCCUPIED] > 0.05
    assert shares[UNKNOWN] > 0.05
    assert set(floor.cells[0].tolist()) == {UNKNOWN}


def test_a_floor_has_one_elevator_one_docking_station_and_eight_labels(floor: SimFloor) -> None:
    assert len(floor.graph.vertices) == 20
    assert len(floor.labels) == 8
    types = Counter(floor.types.values())
    assert types == {"way": 12, "label": 6, "elevator": 1, "charger": 1}
    assert {id_ for id_, type_ in floor.types.items() if type_ != "way"} == set(floor.labels)


def test_ids_and_labels_are_unique_in_the_building() -> None:
    floors = build_building(6).floors
    for number, floor in enumerate(floors):
        ids = [*floor.graph.vertices, *(edge.id for edge in floor.graph.edges)]
        assert all(number * 100 <= id_ < (number + 1) * 100 for id_ in ids)
    labels = Counter(label for floor in floors for label in floor.labels.values())
    assert set(labels.values()) == {1}


def test_the_ground_floor_has_the_places_of_the_handbook() -> None:
    assert {"Base", "Consumidores"} <= set(build_floor(0).labels.values())


def test_neighbouring_floors_differ_and_the_same_floor_does_not() -> None:
    floors = build_building(4).floors
    for i, floor in enumerate(floors):
        assert np.array_equal(floor.cells, build_floor(i).cells)
        for other in floors[:i]:
            assert not np.array_equal(floor.cells, other.cells)


def test_the_elevator_joins_all_floors_at_one_place() -> None:
    building = build_building(3)
    lifts = [building.graph.vertices[floor.vertex_of("elevator")] for floor in building.floors]
    assert len({(lift.x, lift.y) for lift in lifts}) == 1
    way = building.graph.path(0, 219)
    assert [building.floor_of(vertex).name for vertex in way].count("floor_1") == 0
    assert way[-1] == 219

"""The warehouse must be drivable: what the graph promises, the map must allow."""

from collections import Counter

import numpy as np
import pytest

from fleet_tui.simulator.warehouse import SimFloor, build_building, build_floor


@pytest.fixture(params=range(5))
def floor(request: pytest.FixtureRequest) -> SimFloor:
    return build_floor(request.param)


def test_every_vertex_is_reached_from_the_first(floor: SimFloor) -> None:
    first = min(floor.graph.vertices)
    assert all(floor.graph.path(first, vertex) for vertex in floor.graph.vertices)


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

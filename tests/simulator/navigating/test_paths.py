"""Ways to a pose: straight where the floor is free, else along the graph, with Nav2's codes for none."""

import pytest

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.floorplan import FREE, HEIGHT, OCCUPIED, ORIGIN, RESOLUTION, WIDTH
from fleet_tui.simulator.navigating.paths import NO_PATH, OFF_THE_MAP, NoPathError, length, plan
from fleet_tui.simulator.navigating.paths import OCCUPIED as TAKEN
from fleet_tui.simulator.warehouse import SimFloor
from tests.support.navigating import FLOOR

SPOTS = list(FLOOR.graph.vertices.values())


def at(vertex: int) -> Pose:
    return Pose(SPOTS[vertex].x, SPOTS[vertex].y)


def is_free(x: float, y: float) -> bool:
    column, row = (int((value - origin) / RESOLUTION) for value, origin in zip((x, y), ORIGIN, strict=True))
    return bool(FLOOR.cells[row, column] == FREE)


def test_neighbours_are_joined_by_a_straight_line() -> None:
    edge = FLOOR.graph.edges[0]
    start, end = (FLOOR.graph.vertices[id_] for id_ in (edge.start, edge.end))
    way = plan(FLOOR, Pose(start.x, start.y), Pose(end.x, end.y))
    assert way == [(start.x, start.y), (end.x, end.y)]
    assert length(way) == pytest.approx(((end.x - start.x) ** 2 + (end.y - start.y) ** 2) ** 0.5)
    assert length([]) == 0.0


def test_around_a_corner_the_way_leads_over_vertices_on_free_ground() -> None:
    way = plan(FLOOR, at(0), at(-1))
    assert len(way) > 2 and way[0] == (SPOTS[0].x, SPOTS[0].y) and way[-1] == (SPOTS[-1].x, SPOTS[-1].y)
    assert all(is_free(*spot) for spot in way)


def test_a_goal_that_can_not_be_reached_says_why() -> None:
    outside = ORIGIN[0] + WIDTH * RESOLUTION + 1.0
    row, column = next(zip(*(FLOOR.cells == OCCUPIED).nonzero(), strict=True))
    wall = Pose(ORIGIN[0] + (column + 0.5) * RESOLUTION, ORIGIN[1] + (row + 0.5) * RESOLUTION)
    alone = SimFloor("f", FLOOR.cells, type(FLOOR.graph)(FLOOR.graph.vertices, ()), {}, {})
    for floor, goal, code, words in (
        (FLOOR, Pose(outside, 0.0), OFF_THE_MAP, "outside bounds"),
        (FLOOR, Pose(0.0, ORIGIN[1] + HEIGHT * RESOLUTION + 1.0), OFF_THE_MAP, "outside bounds"),
        (FLOOR, Pose(float("nan"), 0.0), OFF_THE_MAP, "outside bounds"),
        (FLOOR, wall, TAKEN, "Goal occupied"),
        (alone, at(-1), NO_PATH, "no valid path found"),
    ):
        with pytest.raises(NoPathError, match=words) as raised:
            plan(floor, at(0), goal)
        assert raised.value.code == code

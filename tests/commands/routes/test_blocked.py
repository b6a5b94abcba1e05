"""Edges on which robots are held up, until others drive over them."""

import pytest

from fleet_tui.commands.routes.blocked import blocked_edge, edge_under
from fleet_tui.model.desk.desk import ends_of
from fleet_tui.model.events import Event, ObstacleReported, PoseReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from tests.support.fleets import F0, R0, T0, pose, queue, reduced, tick
from tests.support.street import fleet_with

MIDDLE = ends_of(F0, "2", "3")


def contact(at: float, seconds: float = 40.0) -> ObstacleReported:
    return ObstacleReported(R0, at, seconds)


def held_at(x: float, *facts: Event) -> FleetState:
    return fleet_with(pose(T0, x, 0.0), contact(T0), *facts)


def drives(state: FleetState, *metres: float, y: float = 0.0) -> FleetState:
    """Return the state after the other robot was seen at places of the street."""
    at = state.now
    for x in metres:
        at += 1.0
        here = state.robots[R0].pose
        assert here is not None
        state = reduced(
            state, pose(at, here.value.x, 0.0), contact(at), pose(at, x, y, robot="robot_1"), tick(at)
        )
    return state


def test_an_edge_is_the_one_between_the_vertices_beside_a_robot() -> None:
    assert edge_under(held_at(14.0).robots[R0]) == MIDDLE
    assert edge_under(fleet_with().robots[R0]) is None


@pytest.mark.parametrize(
    ("yaw", "ahead"), [(0.1, ("2", "3")), (3.1, ("1", "2")), (1.5, ("2", "4")), (-1.5, None)]
)
def test_at_a_vertex_it_is_the_edge_that_the_robot_faces(yaw: float, ahead: tuple[str, str] | None) -> None:
    robot = fleet_with(PoseReported(R0, T0, Pose(10.2, 0.0, yaw), F0, None), robots=1).robots[R0]
    assert edge_under(robot) == (ends_of(F0, *ahead) if ahead else None)


@pytest.mark.parametrize(("seconds", "blocks"), [(0.0, False), (5.0, False), (40.0, True)])
def test_a_robot_in_contact_may_block_its_edge(seconds: float, blocks: bool) -> None:
    state = fleet_with(pose(T0, 14.0, 0.0), contact(T0, seconds))
    assert blocked_edge(state, R0) == (MIDDLE if blocks else None)


def test_a_robot_that_stands_for_another_reason_blocks_no_edge() -> None:
    state = fleet_with(pose(T0, 14.0, 0.0), queue(T0, (1, 1, 3, "W"), current=1))
    for second in range(1, 90):
        at = T0 + second
        state = reduced(state, pose(at, 14.0, 0.0), queue(at, (1, 1, 3, "W"), current=1), tick(at))
    assert {alarm.condition.kind for alarm in state.alarms} >= {"stuck"}
    assert blocked_edge(state, R0) is None


def test_contact_that_ended_or_is_no_longer_reported_blocks_nothing() -> None:
    ended = reduced(held_at(14.0), contact(T0 + 2, 0.0), tick(T0 + 2))
    assert blocked_edge(ended, R0) is None
    assert blocked_edge(reduced(held_at(14.0), tick(T0 + 60)), R0) is None


def test_a_robot_whose_pose_has_just_jumped_blocks_no_edge() -> None:
    state = fleet_with(pose(T0 - 0.1, 0.0, 0.0), pose(T0, 14.0, 0.0), contact(T0))
    assert blocked_edge(state, R0) is None
    later = reduced(state, pose(T0 + 31, 14.0, 0.0), contact(T0 + 31, 71.0), tick(T0 + 31))
    assert blocked_edge(later, R0) == MIDDLE


@pytest.mark.parametrize("way", [(9.0, 11.0, 13.0, 15.0, 17.0, 19.0), (21.0, 18.0, 15.0, 12.0, 10.0)])
def test_an_edge_that_another_robot_drives_over_is_not_blocked_until_the_next_contact(
    way: tuple[float, ...],
) -> None:
    state = drives(held_at(14.0), *way)
    assert blocked_edge(state, R0) is None
    assert blocked_edge(drives(state, 25.0), R0) is None
    at = state.now
    again = reduced(state, contact(at + 1, 0.0), tick(at + 1), contact(at + 2), tick(at + 2))
    assert blocked_edge(again, R0) == MIDDLE


def test_a_robot_that_waits_behind_or_drives_elsewhere_frees_no_edge() -> None:
    assert blocked_edge(drives(held_at(18.9), 9.0, 12.0, 15.0, 17.0, 17.5), R0) == MIDDLE
    assert blocked_edge(drives(held_at(14.0), 9.0, 13.0, 17.0, 20.0, y=3.0), R0) == MIDDLE
    turned_back = drives(held_at(14.0), 9.0, 12.5, 9.0, 5.0)
    assert blocked_edge(drives(turned_back, 25.0, 19.0, 16.0), R0) == MIDDLE

"""Checks of poses and goals: what is refused, and what the operator is told to do."""

import math

import pytest
from msgspec.structs import replace

from fleet_tui.commands.checks import problems
from fleet_tui.commands.set_up.checks import map_of
from fleet_tui.model.commands import Command, PlaceOrder
from fleet_tui.model.events import Event, FloorMapLoaded, FrameReceived, GridReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.grid import FREE, OCCUPIED, UNKNOWN, OccupancyGrid
from fleet_tui.model.occupancy import grid_from_ros
from fleet_tui.model.order import Stop
from fleet_tui.model.problem import Permissions, Problem
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Reading
from fleet_tui.model.set_up.commands import CancelGoal, SendGoal, SendGraph, SetPose, StoreMap
from tests.support.fleets import F0, R0, T0, fleet, link_up, of_kinds, pose, queue, reduced, tick
from tests.support.kinds import FULL

KIND = replace(FULL, accepts=(*FULL.accepts, "pose", "goal", "goal cancel", "map save"))
FRAME = MapFrame(1.0, 3, 1, Pose(0.0, 0.0))
GRID = grid_from_ros(FRAME, bytes([0, 100, 255]))
"""Free, occupied and unknown ground, from left to right, one metre each."""
STILL = (pose(T0 - 5), pose(T0 - 0.1))


def ready(*facts: Event) -> FleetState:
    state = of_kinds(fleet(), KIND)
    return reduced(
        state, link_up(T0 - 100), *STILL, queue(T0 - 0.1), GridReceived(R0, F0, GRID), *facts, tick(T0)
    )


def found(state: FleetState, command: Command, alone: bool = False) -> dict[str, Problem]:
    request = Request((command,), alone=alone)
    return {one.check: one for one in problems(state, request, Permissions(False, True))}


def set_pose(x: float = 0.5, yaw: float = 0.0, floor: str = F0) -> SetPose:
    return SetPose(R0, floor, Pose(x, 0.5, yaw))


def goal(x: float) -> SendGoal:
    return SendGoal(R0, F0, Pose(x, 0.5))


def test_a_standing_robot_gets_its_pose() -> None:
    assert found(ready(), set_pose()) == {} and found(ready(), goal(0.5)) == {}


def test_a_driving_robot_must_be_paused_first() -> None:
    assert (
        found(ready(pose(T0 - 0.05, 1.0)), set_pose())["driving"].text == "robot_0 is driving: pause it first"
    )
    stuck = found(ready(queue(T0, (4, 1, 2, "W"), current=4)), set_pose())["driving"]
    assert stuck.blocks and stuck.text == "robot_0 has order 4 in process: pause it first"


@pytest.mark.parametrize("x", [math.nan, math.inf, -1e9])
def test_no_pose_at_all_is_refused(x: float) -> None:
    assert found(ready(), set_pose(x))["no place"].blocks
    assert found(ready(), PlaceOrder(R0, (Stop(pose=Pose(x, 0.0)),)))["no place"].blocks


def test_a_graph_of_a_floor_that_the_robot_does_not_have_is_refused() -> None:
    kind = replace(FULL, accepts=(*FULL.accepts, "graph"))
    assert found(of_kinds(ready(), kind), SendGraph(R0, "attic"))["no place"].blocks
    assert found(of_kinds(ready(), kind), SendGraph(R0, F0)) == {}
    assert found(ready(), SendGraph(R0, F0))["not accepted"].blocks


def test_a_floor_that_the_robot_does_not_have_is_named() -> None:
    assert "its floors are floor_0" in found(ready(), set_pose(floor="attic"))["no place"].text


def test_a_goal_needs_free_ground() -> None:
    assert found(ready(), goal(1.5))["blocked goal"].text == "(1.50, 0.50) is occupied on the map"
    for x in (2.5, 7.0, -0.1):
        assert found(ready(), goal(x))["blocked goal"].text.endswith("unknown ground on the map")
    assert not found(ready(), set_pose(1.5))["occupied"].blocks


def test_without_a_map_one_is_asked() -> None:
    state = reduced(of_kinds(fleet(), KIND), link_up(T0 - 100), *STILL, queue(T0), tick(T0))
    assert not found(state, goal(0.5))["no map"].blocks


def test_a_goal_meets_no_orders_and_no_pause() -> None:
    busy = ready(queue(T0, (4, 1, 2, "Q")))
    assert found(busy, goal(0.5))["busy"].text == "robot_0 has 1 order: cancel or clear first"
    order = PlaceOrder(R0, (Stop(pose=Pose(0.5, 0.5)),))
    assert "busy" in found(busy, order, alone=True) and "busy" not in found(busy, order)
    reached = found(busy, CancelGoal(R0))["busy"]
    assert reached.blocks and reached.text.startswith("robot_0 has 1 order, which it may drive by goals")
    assert "busy" not in found(ready(), CancelGoal(R0))
    paused = replace(busy, robots={R0: replace(ready().robots[R0], paused=Reading(True, T0))})
    assert not found(paused, goal(0.5))["paused"].blocks


def test_orders_ask_while_the_robot_maps() -> None:
    state = ready()
    state = replace(state, robots={R0: replace(state.robots[R0], mapping_by_us=True)})
    assert found(state, goal(0.5))["mapping"].text == "robot_0 is mapping (by us)"


def test_the_map_is_the_file_where_it_lies_else_the_live_one() -> None:
    state = ready()
    assert map_of(state, state.robots[R0], F0) is GRID and map_of(state, state.robots[R0], "attic") is None
    image = OccupancyGrid(FRAME, GRID.levels)
    tied = reduced(state, FloorMapLoaded(F0, image))
    assert map_of(tied, tied.robots[R0], F0) is image
    loose = reduced(state, FloorMapLoaded(F0, image, tied=False))
    assert map_of(loose, loose.robots[R0], F0) is None
    placed = reduced(loose, FrameReceived(R0, F0, replace(FRAME, origin=Pose(5.0, 0.0))))
    there = map_of(placed, placed.robots[R0], F0)
    assert there is not None and there.frame.origin.x == 5.0


def test_the_classes_are_told_apart() -> None:
    assert len({UNKNOWN, FREE, OCCUPIED}) == 3


def test_a_name_that_a_shell_could_read_is_refused() -> None:
    assert "no name" not in found(ready(), StoreMap(R0, "hall_2-b"))
    for name in ("hall 2", "$(reboot)", "-f", "", "x" * 65):
        assert found(ready(), StoreMap(R0, name))["no name"].blocks

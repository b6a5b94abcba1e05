"""Checks of poses and goals before they leave. A missing map proves nothing."""

import math
from collections.abc import Iterator

from fleet_tui.model.commands import Command, PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.grid import FREE, OCCUPIED, OccupancyGrid, class_at
from fleet_tui.model.order import BEGUN
from fleet_tui.model.problem import Problem
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.model.set_up.commands import (
    MAP_NAME,
    CancelGoal,
    Localise,
    SendGoal,
    SendGraph,
    SetPose,
    SetUpCommand,
    StoreMap,
)
from fleet_tui.orders.local_queue import waiting
from fleet_tui.orders.mode import mapping_text
from fleet_tui.situation.reported_motion import is_moving
from fleet_tui.text.language import Message, counted

FARTHEST = 1e6
"""Metres from the origin of a map beyond which a pose is a slip of the keyboard."""


def map_of(state: FleetState, robot: Robot, floor: str) -> OccupancyGrid | None:
    """Return the map of a floor in the coordinates of a robot, None without one."""
    known, robot_map = state.floors.get(floor), robot.maps.get(floor, RobotMap())
    if known is not None and known.grid is not None:
        frame = robot_map.frame
        if known.tied:
            return known.grid
        if frame and (frame.width, frame.height) == (known.grid.frame.width, known.grid.frame.height):
            return OccupancyGrid(frame, known.grid.levels)
        return None
    return robot_map.grid or (known.live if known else None)


def goal_of(command: Command) -> Pose | None:
    """Return the pose to which a command leads, None if it leads to none or to a vertex."""
    if isinstance(command, PlaceOrder):
        return command.stops[-1].pose if command.stops else None
    return command.pose if isinstance(command, SendGoal) else None


def no_place(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that a pose can be on a map: a bridge drops NaN without a word."""
    poses = [command.place] if isinstance(command, SetUpCommand) else []
    poses += [stop.pose for stop in command.stops] if isinstance(command, PlaceOrder) else []
    for pose in poses:
        if pose is None:
            continue
        finite = all(map(math.isfinite, (pose.x, pose.y, pose.yaw)))
        if not finite or max(abs(pose.x), abs(pose.y)) > FARTHEST:
            yield Problem(
                "no place",
                Message(
                    "({x}, {y}, {yaw}) is not a pose on a map",
                    x=f"{pose.x:g}",
                    y=f"{pose.y:g}",
                    yaw=f"{pose.yaw:g}",
                ),
            )
    floor = command.floor if isinstance(command, SetPose | SendGoal | SendGraph) else ""
    if floor and floor not in robot.maps:
        yield Problem(
            "no place",
            Message(
                "{name} has no floor {floor}: its floors are {maps}",
                name=robot.name,
                floor=floor,
                maps=", ".join(robot.maps),
            ),
        )


def driving(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that the robot stands: its pose must not change while it drives by it."""
    if not isinstance(command, SetPose | Localise):
        return
    current = robot.orders.current
    has_begun = current is not None and current.state in BEGUN and not state.is_paused(robot)
    if is_moving(robot, state.now) and state.is_fresh(robot, "pose"):
        yield Problem("driving", Message("{name} is driving: pause it first", name=robot.name))
    elif has_begun and current is not None:
        yield Problem(
            "driving",
            Message("{name} has order {id} in process: pause it first", name=robot.name, id=current.id),
        )


def blocked_goal(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that a goal is on free ground."""
    pose = goal_of(command)
    if pose is None:
        return
    floor = command.floor if isinstance(command, SendGoal) else robot.floor or ""
    grid = map_of(state, robot, floor)
    if grid is None:
        yield Problem(
            "no map",
            Message("no map of {floor}: the goal can't be checked", floor=floor or "its floor"),
            blocks=False,
        )
    elif (found := class_at(grid, pose.x, pose.y)) != FREE:
        what = Message("occupied") if found == OCCUPIED else Message("unknown ground")
        yield Problem(
            "blocked goal",
            Message("({x}, {y}) is {what} on the map", x=f"{pose.x:.2f}", y=f"{pose.y:.2f}", what=what),
        )


def occupied_pose(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that a robot is not placed into a wall."""
    if not isinstance(command, SetPose):
        return
    pose, grid = command.pose, map_of(state, robot, command.floor)
    if grid is not None and class_at(grid, pose.x, pose.y) == OCCUPIED:
        text = Message("({x}, {y}) is occupied on the map", x=f"{pose.x:.2f}", y=f"{pose.y:.2f}")
        yield Problem("occupied", text, blocks=False)


def busy(state: FleetState, robot: Robot) -> Iterator[Problem]:
    """Check that a robot has no orders: a goal would drive it away from them."""
    count = len(robot.orders.open) + len(waiting(state, robot))
    if count:
        yield Problem(
            "busy",
            counted(
                "{name} has {count} order: cancel or clear first",
                "{name} has {count} orders: cancel or clear first",
                count,
                name=robot.name,
            ),
        )


def mapped(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that an order does not drive a robot that maps."""
    if isinstance(command, PlaceOrder | SendGoal) and (text := mapping_text(robot)):
        yield Problem("mapping", Message("{name} is {text}", name=robot.name, text=text), blocks=False)


def goal_beside_orders(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that a goal beside the queue meets no order, and no pause."""
    if not isinstance(command, SendGoal):
        return
    yield from busy(state, robot)
    if state.is_paused(robot):
        yield Problem("paused", Message("{name} is paused", name=robot.name), blocks=False)


def no_name(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check the name of a map on a robot, which some programs put into a shell command."""
    if isinstance(command, StoreMap) and not MAP_NAME.fullmatch(command.name):
        yield Problem(
            "no name",
            Message("{name}: up to 64 letters, digits, _ and -, no - at the start", name=f"{command.name!r}"),
        )


def only_its_goal(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that a robot drives no order: the cancellation of all goals would reach the goals of that one."""
    if isinstance(command, CancelGoal) and (count := len(robot.orders.open)):
        text = counted(
            "{name} has {count} order, which it may drive by goals: cancel by id",
            "{name} has {count} orders, which it may drive by goals: cancel by id",
            count,
            name=robot.name,
        )
        yield Problem("busy", text)


CHECKS = (no_place, driving, blocked_goal, occupied_pose, mapped, goal_beside_orders, only_its_goal, no_name)
"""The checks of set-up commands, and of orders to poses."""

"""Set-up commands that are confirmed once: what a robot believes, or how it drives, changes."""

from collections.abc import Iterator
from typing import assert_never

from fleet_tui.commands.set_up.confirmation import believed, difference_text, present_graph
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import (
    CancelGoal,
    Localise,
    SendGoal,
    SendGraph,
    SetMapping,
    SetPose,
    Settle,
    SetUp,
    StartCharging,
    StoreMap,
)
from fleet_tui.text.language import EMPTY, Message, counted
from fleet_tui.text.sanitize import sanitize
from fleet_tui.text.units import age

OLD = 5.0
"""Seconds after which the age of a pose is said."""


def _differs(state: FleetState, robot: Robot, pose: Pose) -> Iterator[Message]:
    """Yield how far a pose is from what the robot reported itself."""
    if (now := believed(robot)) is None:
        return
    differs, is_old = difference_text(now.value, pose), state.now - now.at > OLD
    if is_old and now != robot.pose:
        # The pose that is shown is carried on by its wheels, and is newer.
        yield Message(
            "{differs} from the last pose of its localisation, {age} ago",
            differs=differs,
            age=age(state.now - now.at),
        )
        return
    since = Message(", reported {age} ago", age=age(state.now - now.at)) if is_old else EMPTY
    yield Message("{differs} from its present pose{since}", differs=differs, since=since)


def set_up_losses(state: FleetState, robot: Robot, command: SetUp) -> Iterator[Message]:
    """Return the question and the difference to now, one line each; empty for a harmless command."""
    match command:
        case SetPose(name, floor, pose):
            yield Message("{name}: {text} on {floor}?", name=name, text=command.text, floor=floor)
            yield from _differs(state, robot, pose)
        case Localise(name):
            yield Message("{name}: forget its pose and search on the whole map?", name=name)
        case CancelGoal(name):
            yield Message("{name}: cancel its goal?", name=name)
        case SetMapping(name, on):
            yield Message("{name}: {command}?", name=name, command=command.text)
            if on:
                yield Message("its live map replaces the known one until mapping is off")
        case StoreMap(name):
            yield Message("{name}: {command}?", name=name, command=command.text)
            yield Message("one of that name on the robot is replaced")
        case SendGraph(name, floor):
            yield Message("{name}: {command}?", name=name, command=command.text)
            present = present_graph(robot, floor)
            unknown = Message("its graph of {floor}, which is unknown here", floor=floor)
            yield Message("replaces {present}", present=present or unknown)
            yield from _file_lines(state, robot, command)
            count = len(robot.orders.open)
            too = counted(", {count} open order too", ", {count} open orders too", count) if count else ""
            yield Message("orders are driven on it from then on{too}", too=too)
        case Settle() | SendGoal() | StartCharging():
            return
        case _:
            assert_never(command)


def _file_lines(state: FleetState, robot: Robot, command: SendGraph) -> Iterator[Message]:
    """Return the file that is written for a robot which loads it, and the robots that do not load it now."""
    if not command.path:
        return
    kept = Message(", the old file is kept as .bak") if command.is_kept else EMPTY
    yield Message("writes {path}{kept}", path=sanitize(command.path), kept=kept)
    others = [
        one
        for one in state.robots.values()
        if one is not robot and command.floor in one.maps and one.kind.loads_graphs
    ]
    if others:
        yield counted(
            "{count} other robot of {floor}: send it to each, too",
            "{count} other robots of {floor}: send it to each, too",
            len(others),
            floor=command.floor,
        )

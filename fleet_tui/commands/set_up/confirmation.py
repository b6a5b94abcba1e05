"""Confirmation of set-up commands: the evidence in telemetry that they were carried out."""

import math
from typing import assert_never

from fleet_tui.model.commands import CommandRecord, Stage, Step
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Reading, Robot
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
    counts_text,
)
from fleet_tui.orders.mode import is_in_mode
from fleet_tui.situation.pauses import stopped
from fleet_tui.situation.reported_motion import STANDS_AFTER
from fleet_tui.text.language import EMPTY, Message

SET_WITHIN = 0.5
SET_TURN = math.radians(15.0)
"""Metres and radians within which a reported pose is the one that was set."""


def believed(robot: Robot) -> Reading[Pose] | None:
    """Return the newest pose that a robot reported by itself, not one carried on by its wheels here."""
    if robot.located is not None and robot.located_at is not None:
        return Reading(robot.located, robot.located_at)
    return robot.pose


def difference(one: Pose, other: Pose) -> tuple[float, float]:
    """Return metres and radians between two poses."""
    turn = abs(
        math.remainder(math.remainder(one.yaw, math.tau) - math.remainder(other.yaw, math.tau), math.tau)
    )
    return math.dist((one.x, one.y), (other.x, other.y)), turn


def difference_text(one: Pose, other: Pose) -> Message:
    """Return the difference of two poses in words."""
    metres, turn = difference(one, other)
    return Message("{metres} m and {degrees}°", metres=f"{metres:.2f}", degrees=f"{math.degrees(turn):.0f}")


def is_near(one: Pose, other: Pose) -> bool:
    """Tell whether a reported pose counts as the one that was set."""
    metres, turn = difference(one, other)
    return metres <= SET_WITHIN and turn <= SET_TURN


def _since(robot: Robot, record: CommandRecord, floor: str) -> Pose | None:
    """Return the pose on a floor that the robot reported after the command had been sent."""
    pose, sent = believed(robot), record.time_of(Stage.SENT)
    there = (floor,) if robot.kind.frames_are_floors else (floor, None)
    if pose is None or sent is None or pose.at <= sent or robot.floor not in there:
        return None
    return pose.value


def set_up_seen(state: FleetState, robot: Robot, record: CommandRecord, command: SetUp) -> Step | None:
    """Return the evidence for a set-up command."""
    unseen = Step(Stage.UNVERIFIABLE, state.now) if record.stage is Stage.ACCEPTED else None
    match command:
        case SetPose(_, floor, wanted):
            pose = _since(robot, record, floor)
            if pose is None or not is_near(pose, wanted):
                return None
            return Step(
                Stage.CONFIRMED,
                state.now,
                Message("reported within {difference_text}", difference_text=difference_text(pose, wanted)),
            )
        case SendGoal():
            return _goal_seen(state, robot, record, command)
        case CancelGoal() if record.before.moving:
            return (
                Step(Stage.CONFIRMED, state.now, Message("the robot stopped"))
                if stopped(state, robot, record)
                else None
            )
        case SetMapping() if "mode" in robot.kind.reports:
            since = record.time_of(Stage.SENT) if unseen is None else None
            return _by_robot(state, is_in_mode(robot, command.on, since))
        case StartCharging():
            return _by_robot(state, robot.vehicle is not None and robot.vehicle.value.charging is True)
        case SendGraph():
            return _graph_seen(state, robot, command, unseen)
        case Settle():
            return _settled(state, robot, record) if unseen else None
        case CancelGoal() | Localise() | SetMapping() | StoreMap():  # no report shows the effect
            return unseen
        case _:
            assert_never(command)


def _by_robot(state: FleetState, seen: bool) -> Step | None:
    return Step(Stage.CONFIRMED, state.now, Message("by the robot")) if seen else None


def _graph_seen(state: FleetState, robot: Robot, command: SendGraph, unseen: Step | None) -> Step | None:
    """Return the evidence for a graph: the robot's own, or its answer if it loads a file."""
    if command.path:
        return Step(Stage.CONFIRMED, state.now, Message("the robot has loaded the file")) if unseen else None
    if {"graph", "labels"} <= set(robot.kind.reports):
        return _by_robot(state, _has_graph(robot, command))
    return unseen


def _has_graph(robot: Robot, command: SendGraph) -> bool:
    now = robot.maps.get(command.floor)
    return now is not None and now.graph is not None and command.is_graph(now.graph, now.labels)


def _settled(state: FleetState, robot: Robot, record: CommandRecord) -> Step:
    """Return the end of a refinement: a pose that localisation publishes at rest is its effect; one that is
    published all the time proves nothing."""
    sent, at = record.time_of(Stage.SENT), robot.located_at
    seen = sent is not None and at is not None and at > sent
    return Step(Stage.CONFIRMED if seen else Stage.UNVERIFIABLE, state.now, record.detail)


def _goal_seen(state: FleetState, robot: Robot, record: CommandRecord, command: SendGoal) -> Step | None:
    """Return the evidence that a robot drives to a goal: no topic lists it."""
    pose, sent = _since(robot, record, command.floor), record.time_of(Stage.SENT)
    if pose is None or sent is None or robot.standing is None:
        return None
    if is_near(pose, command.pose):
        return Step(Stage.CONFIRMED, state.now, Message("the robot is there"))
    # One that had moved just before may still be braking.
    if robot.standing.at > sent + (STANDS_AFTER if record.before.moving else 0.0):
        return Step(Stage.CONFIRMED, state.now, Message("the robot moves"))
    return None


def present_graph(robot: Robot, floor: str) -> Message:
    """Return the size of the graph of a floor that a robot has, empty if none was received."""
    now = robot.maps.get(floor)
    if now is None or now.graph is None:
        return EMPTY
    return counts_text(len(now.graph.vertices), len(now.graph.edges), len(now.labels))


def instead_of_set_up(robot: Robot, record: CommandRecord, command: SetUp) -> Message:
    """Return the evidence of telemetry if a set-up command can't be seen to have been carried out."""
    match command:
        case SetPose(_, floor, wanted):
            pose = _since(robot, record, floor)
            if pose is None:
                return Message("no pose on {floor} received since", floor=floor)
            return Message(
                "the robot reported a pose {difference_text} from it",
                difference_text=difference_text(pose, wanted),
            )
        case SendGoal():
            return Message("the robot did not move")
        case CancelGoal():
            return Message("the robot was not seen to stop")
        case StartCharging():
            return Message("the robot does not report that it is charging")
        case SetMapping():
            return (
                Message("the robot reports {mode}", mode=Message(robot.mode.value))
                if robot.mode
                else Message("no mode received")
            )
        case SendGraph() if command.path:
            return Message("the robot may have loaded the file or not")
        case SendGraph(_, floor):
            present = present_graph(robot, floor)
            return (
                Message("the robot has {present}", present=present)
                if present
                else Message("no graph of {floor} received", floor=floor)
            )
        case Localise() | Settle() | StoreMap():
            return Message("no evidence in telemetry")
        case _:
            assert_never(command)

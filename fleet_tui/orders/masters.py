"""Vehicles of a master control: the protocol knows one, and they can't tell a second one apart."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PlaceOrder, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import vertices_of
from fleet_tui.model.problem import Problem
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.model.vehicles.vehicle import HIGH
from fleet_tui.orders.goals import active
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.limits import some
from fleet_tui.text.units import age

QUIET_FOR = 60.0
"""Seconds without a command of another master control after which this console may be one."""


Ways = set[frozenset[str]]


def shared_way(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that no other vehicle has an edge of the way of an order left: the console, a master control,
    does no traffic control."""
    if not isinstance(command, PlaceOrder) or robot.vehicle is None:
        return
    own = _way_of(robot, command)
    others = [
        other.name
        for other in state.robots.values()
        if other is not robot and other.floor == robot.floor and own & _ways_left(other)
    ]
    if others:
        text = Message(
            "the route of {name} shares an edge with {some}: no traffic control here",
            name=robot.name,
            some=some(others),
        )
        yield Problem("shared way", text, blocks=False)


def _way_of(robot: Robot, command: PlaceOrder) -> Ways:
    graph = robot.maps.get(robot.floor or "", RobotMap()).graph
    if graph is None or robot.vehicle is None:
        return set()
    stops = [robot.vehicle.value.last_node, *vertices_of(command.stops)]
    return {pair for start, end in pairwise(stops) for pair in _pairs(graph.path(start, end))}


def _ways_left(robot: Robot) -> Ways:
    if robot.vehicle is None or not robot.vehicle.value.nodes_left:
        return set()
    return _pairs((robot.vehicle.value.last_node, *robot.vehicle.value.nodes_left))


def _pairs(nodes: Sequence[str]) -> Ways:
    return {frozenset(pair) for pair in pairwise(nodes)}


def other_master(now: float, robot: Robot, command: Command) -> Message:
    """Return the reason that another master control forbids a command to a vehicle, empty if none does."""
    if robot.vehicle is None or not isinstance(command, PlaceOrder | CancelOrder | ClearOrders):
        return EMPTY
    if robot.master is not None and now - robot.master.at < QUIET_FOR:
        seen = Message("{name}, {age} ago", name=Message(robot.master.value), age=age(now - robot.master.at))
        return Message(
            "another master control commands {name} ({seen}): stop it, or wait {seconds} s",
            name=robot.name,
            seen=seen,
            seconds=f"{QUIET_FOR:.0f}",
        )
    foreign = next((goal.id for goal in active(robot.goals) if not goal.is_ours), "")
    return (
        Message("{name} drives order {foreign} of another master control", name=robot.name, foreign=foreign)
        if foreign
        else EMPTY
    )


def commanded_elsewhere(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that no other master control commands a vehicle."""
    if reason := other_master(state.now, robot, command):
        yield Problem("another master", reason)


def own_mode(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that the mode of a vehicle lets it take an order."""
    if isinstance(command, PlaceOrder) and robot.vehicle is not None and state.is_fresh(robot, "vehicle"):
        vehicle = robot.vehicle.value
        if not vehicle.takes_orders:
            yield Problem(
                "mode",
                Message(
                    "{name} is in mode {mode_text}: it takes no orders",
                    name=robot.name,
                    mode_text=vehicle.mode_text,
                ),
            )
        if vehicle.e_stop:
            yield Problem(
                "e-stop",
                Message("{name} is stopped: {e_stop_text}", name=robot.name, e_stop_text=vehicle.e_stop_text),
                blocks=False,
            )
        for grave in vehicle.errors:
            if grave.level in HIGH:
                text = Message(
                    "{name} reports {level} {type}",
                    name=robot.name,
                    level=grave.level.lower(),
                    type=grave.type,
                )
                yield Problem("fault", text, blocks=False)


def asked_about(state: FleetState, robot: Robot) -> tuple[str, ...]:
    """Return what an operator is asked about before an order to a vehicle, as it is now."""
    found = own_mode(state, robot, PlaceOrder(robot.name, ()))
    return tuple(problem.text for problem in found if not problem.blocks)


def foreign_pause(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that a pause that is lifted is our own: another one may be a person at the vehicle."""
    is_resumed = isinstance(command, ResumeRobot) and robot.vehicle is not None
    if is_resumed and state.is_paused(robot) and not robot.paused_by_us:
        text = Message(
            "{name} was not paused by this console: maybe by a person at the vehicle", name=robot.name
        )
        yield Problem("paused elsewhere", text, blocks=False)


def no_heading(_state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that a vehicle keeps the heading of a goal."""
    if robot.features is None or not robot.features.refuses_headings or not isinstance(command, PlaceOrder):
        return
    if any(stop.pose is not None and not stop.turns_freely for stop in command.stops):
        text = Message(
            "{name} accepts no heading (factsheet): it chooses its own at the goal", name=robot.name
        )
        yield Problem("no heading", text, blocks=False)


VEHICLE_CHECKS = (commanded_elsewhere, own_mode, foreign_pause, no_heading, shared_way)

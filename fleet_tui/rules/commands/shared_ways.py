"""The check of an order's way: it must share no edge with what another vehicle has left, for a master control
of this console does no traffic control."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from fleet_tui.model.commands import Command, PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import vertices_of
from fleet_tui.model.problem import Problem
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.text.limits import some

Ways = set[frozenset[str]]


def shared_way(state: FleetState, robot: Robot, command: Command) -> Iterator[Problem]:
    """Check that no other vehicle drives an edge of the way of an order."""
    if not isinstance(command, PlaceOrder) or robot.vehicle is None:
        return
    own = _way_of(robot, command)
    others = [
        other.name
        for other in state.robots.values()
        if other is not robot and other.floor == robot.floor and own & _ways_left(other)
    ]
    if others:
        text = f"the way of {robot.name} shares an edge with {some(others)}: no traffic control here"
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

"""Why an order may not be meant: it leads over a closed edge, or farther than a nearly flat battery lasts. A
person is asked; programs that give orders have rules of their own."""

from collections.abc import Iterator, Sequence

from fleet_tui.commands.language.edges import edge_text
from fleet_tui.commands.routes.impact import closed_on_way
from fleet_tui.commands.routes.order_draft import place_of, stop_at, way_between
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Role
from fleet_tui.model.order import vertices_of
from fleet_tui.model.problem import Problem
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import Message
from fleet_tui.text.limits import some

FAR = 20.0
"""Metres of an order that are far for a battery below the critical limit."""


def doubts(state: FleetState, request: Request) -> Iterator[Problem]:
    """Yield what a person is asked about the ways of the orders of a request."""
    orders: dict[str, list[str]] = {}
    for command in request.commands:
        if isinstance(command, PlaceOrder) and not command.to_any and command.robot in state.robots:
            orders.setdefault(command.robot, []).extend(vertices_of(command.stops))
    for name, vertices in orders.items():
        yield from _of_way(state, state.robots[name], vertices)


def _of_way(state: FleetState, robot: Robot, vertices: Sequence[str]) -> Iterator[Problem]:
    is_critical = (
        robot.battery is not None
        and robot.battery.value < state.limits.battery_critical
        and state.is_fresh(robot, "battery")
    )
    if not vertices or not (is_critical or state.desk.closed):
        return  # nearly always: the form asks ten times a second
    begin = [] if robot.orders.open else place_of(robot)
    lines, metres = way_between(robot, [*begin, *(stop for one in vertices for stop in stop_at(robot, one))])
    if closed := closed_on_way(state.desk.closed, robot, lines):
        edges = some([edge_text(robot, edge.ends) for edge in closed])
        text = Message("the way of {name} is closed: {edges}", name=robot.name, edges=edges)
        yield Problem("closed", text, blocks=False)
    if is_critical and metres is not None and metres >= FAR and not _is_charger(robot, vertices[-1]):
        assert robot.battery is not None
        text = Message(
            "battery of {name}: {percent} %, for {metres} m",
            name=robot.name,
            percent=int(robot.battery.value),
            metres=f"{metres:.0f}",
        )
        yield Problem("battery", text, blocks=False)


def _is_charger(robot: Robot, vertex: str) -> bool:
    graphs = (one.graph for one in robot.maps.values() if one.graph is not None)
    return any(graph.vertices[vertex].role is Role.DOCKING for graph in graphs if vertex in graph.vertices)

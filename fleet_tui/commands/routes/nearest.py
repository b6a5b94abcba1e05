"""The nearest idle robot for an order that anyone may drive, by the metres along its own graph."""

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import pairwise

from msgspec import Struct

from fleet_tui.commands.language.any_robot import own_place
from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.routes.ways import Routes, Spot
from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Role, RouteGraph
from fleet_tui.model.kind import ORDER
from fleet_tui.model.robot import Robot
from fleet_tui.orders.local_queue import all_orders
from fleet_tui.orders.mode import mapping_text
from fleet_tui.text.language import EMPTY, Message, joined

BATTERY_MARGIN = 10.0
"""Per cent above the limit of a low battery that a robot needs, so that an order does not end in an alarm."""


class Nearest(Struct, frozen=True):
    """The nearest idle robot: `places` of the order on its own graph, `metres` from it to the first one;
    `battery` in per cent, None for a kind that reports none."""

    robot: str
    places: tuple[Place, ...]
    metres: float
    battery: float | None

    @property
    def text(self) -> Message:
        """Return the robot with the reason for it."""
        charge = (
            Message("unknown") if self.battery is None else Message("{battery} %", battery=int(self.battery))
        )
        return Message(
            "{robot}: idle, {metres} m from {name}, battery {charge}",
            robot=self.robot,
            metres=f"{self.metres:.0f}",
            name=self.places[0].name,
            charge=charge,
        )


def nearest(state: FleetState, places: Sequence[Place]) -> Nearest | None:
    """Return the idle robot with the shortest way to the first place and a way from each to the next, None
    without one. Robots at the same distance come in the order of the configuration."""
    graphs = GraphDistances()
    found = (_candidate(state, robot, places, graphs) for robot in state.robots.values())
    return min(filter(None, found), key=lambda one: one.metres, default=None)


def why_none(state: FleetState, places: Sequence[Place]) -> Message:
    """Return why no idle robot can drive an order, in one line."""
    counted = Counter(why_not(state, robot) or Message("without a way") for robot in state.robots.values())
    others = joined(
        ", ",
        (Message("{count} {reason}", count=count, reason=reason) for reason, count in counted.most_common()),
    )
    asked = (
        Message("drive {name}", name=" -> ".join(place.name for place in places))
        if places[1:]
        else Message("reach {name}", name=places[0].name)
    )
    return Message("no idle robot can {asked}: {others}", asked=asked, others=others)


def why_not(state: FleetState, robot: Robot) -> Message:
    """Return why a robot can take no order at once, as `busy` or `offline`; empty if it can."""
    if ORDER not in robot.kind.accepts:
        return Message("of a kind without orders")
    if not state.is_online(robot):
        return Message("offline")
    if state.is_paused(robot) or (robot.paused is not None and robot.paused.value):
        return Message("paused")
    if _is_busy(state, robot):
        return Message("busy")
    if any(one.holds and robot.name in (one.condition.source, *one.condition.parts) for one in state.alarms):
        return Message("in trouble")
    if mapping_text(robot):
        return Message("mapping")
    if not state.is_fresh(robot, "pose") or robot.floor is None:
        return Message("without a pose")
    return _why_not_ready(state, robot)


def _is_busy(state: FleetState, robot: Robot) -> bool:
    """Tell whether an order is open, waits, or was sent and is not in the queue yet."""
    ours = (one for one in state.commands if one.command.robot == robot.name)
    given = any(isinstance(one.command, PlaceOrder) and not one.is_decided for one in ours)
    return given or any(not order.is_over for order in all_orders(state, robot))


def _why_not_ready(state: FleetState, robot: Robot) -> Message:
    if robot.kind.expects("queue") and not state.is_fresh(robot, "queue"):
        return Message("without a queue report")
    if robot.has_cargo:
        return Message("with cargo on board")
    if not _reports_battery(robot):
        return EMPTY
    if robot.battery is None or not state.is_fresh(robot, "battery"):
        return Message("without a battery report")
    enough = robot.battery.value >= state.limits.battery_low + BATTERY_MARGIN
    return EMPTY if enough else Message("low on battery")


def _reports_battery(robot: Robot) -> bool:
    return "battery" in robot.kind.reports and "battery" not in robot.unmeasured


class GraphDistances:
    """Distances along graphs, each searched once: robots share graphs."""

    def __init__(self) -> None:
        self._routes: dict[int, Routes] = {}
        self._metres: dict[tuple[int, tuple[str, ...]], Mapping[str, float]] = {}

    def near(self, robot: Robot, graph: RouteGraph) -> tuple[Spot, ...]:
        """Return the ends of the edge that a robot is on, with the metres to them."""
        if id(graph) not in self._routes:
            self._routes[id(graph)] = Routes(graph)
        return self._routes[id(graph)].near(robot.pose.value) if robot.pose is not None else ()

    def metres(self, graph: RouteGraph, starts: Sequence[Spot], *ends: str) -> float:
        """Return the metres to the nearest of the ends, infinite without a way."""
        key = id(graph), ends
        if key not in self._metres:
            self._metres[key] = graph.metres_to(ends)
        known = self._metres[key]
        return min((before + known.get(vertex, math.inf) for vertex, before in starts), default=math.inf)


def _candidate(
    state: FleetState, robot: Robot, places: Sequence[Place], graphs: GraphDistances
) -> Nearest | None:
    if why_not(state, robot) or robot.floor is None:
        return None
    own = [one for place in places if (one := own_place(state, robot, place)) is not None]
    here = robot.maps[robot.floor].graph if robot.floor in robot.maps else None
    if here is None or len(own) < len(places) or not own:
        return None
    metres = metres_to(robot, robot.floor, graphs.near(robot, here), own[0], graphs)
    legs = (metres_to(robot, one.floor, [(one.vertex, 0.0)], other, graphs) for one, other in pairwise(own))
    if not all(map(math.isfinite, (metres, *legs))):
        return None
    charge = robot.battery.value if robot.battery is not None and _reports_battery(robot) else None
    return Nearest(robot.name, tuple(own), metres, charge)


def metres_to(robot: Robot, floor: str, starts: Sequence[Spot], end: Place, graphs: GraphDistances) -> float:
    """Return the metres of the shortest way, over floors by lift, all of which are assumed to connect;
    infinite without one."""
    here, there = robot.maps[floor].graph, robot.maps[end.floor].graph
    if here is None or there is None:
        return math.inf
    if floor == end.floor:
        return graphs.metres(here, starts, end.vertex)
    if not robot.kind.changes_floors:
        return math.inf
    to_lift = graphs.metres(here, starts, *_lifts(here))
    return to_lift + graphs.metres(there, [(lift, 0.0) for lift in _lifts(there)], end.vertex)


def _lifts(graph: RouteGraph) -> list[str]:
    return [vertex.id for vertex in graph.vertices.values() if vertex.role is Role.ELEVATOR]

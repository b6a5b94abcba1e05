"""An order while it is typed: its way, its length, a guess of its time."""

import math
import statistics
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise

from msgspec import Struct

from fleet_tui.commands.language.lookup import Place
from fleet_tui.commands.routes.ways import Spot, routes_of
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Line
from fleet_tui.model.order import Order
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message, counted
from fleet_tui.text.units import age

SPEED = 0.5
"""Metres per second of the guess while no robot was seen to drive, a usual speed of indoor robots."""

GraphStop = tuple[str, tuple[Spot, ...]]
"""A floor, and the vertices of it that count as one place."""


class Draft(Struct, frozen=True):
    """The places that an order being typed would visit, the marked match included. `starts_here`: it starts
    where the robot is; `marked`: the place that Enter would take."""

    robot: str
    places: tuple[Place, ...] = ()
    starts_here: bool = False
    marked: Place | None = None


class DraftRoute(Struct, frozen=True):
    """The lines of a draft's way by floor, and its length in metres, None if some of it has no way;
    `approach`: the metres to its start from the robot, or from the end of its last open order, 0 if it starts
    there or that way is unknown, `to_start` the lines of that way by floor; `before`: its open orders, that
    are driven first; `pace`: the speed in m/s that was seen, None if none was."""

    lines: Mapping[str, tuple[Line, ...]]
    metres: float | None
    by_lift: bool = False
    approach: float = 0.0
    before: int = 0
    pace: float | None = None
    to_start: Mapping[str, tuple[Line, ...]] = {}

    @property
    def text(self) -> Message:
        """Return its length, and a guess of its time."""
        if self.metres is None:
            return Message("no path on the graph")
        lift = Message(", by lift") if self.by_lift else EMPTY
        to_start = (
            Message("{approach} m to the start, then ", approach=f"{self.approach:.0f}")
            if self.approach >= 1.0
            else EMPTY
        )
        after = (
            counted(", plus {count} order before", ", plus {count} orders before", self.before)
            if self.before
            else EMPTY
        )
        takes = _rounded_up((self.metres + self.approach) / (self.pace or SPEED))
        if self.pace is None:
            return Message(
                "{to_start}{metres} m{lift}, about {takes} at an assumed {pace} m/s{after}",
                to_start=to_start,
                metres=f"{self.metres:.0f}",
                lift=lift,
                takes=takes,
                pace=SPEED,
                after=after,
            )
        return Message(
            "{to_start}{metres} m{lift}, about {takes} at {pace} m/s{after}",
            to_start=to_start,
            metres=f"{self.metres:.0f}",
            lift=lift,
            takes=takes,
            pace=f"{self.pace:.1f}",
            after=after,
        )


def _rounded_up(seconds: float) -> str:
    """Return the text of a guess: 170 s are 3 min."""
    return age(seconds if seconds < 120.0 else math.ceil(seconds / 60.0) * 60.0)


def pace_of(state: FleetState, robot: Robot) -> float | None:
    """Return the speed in m/s at which a robot drives, else the fleet's median; None before any drove."""
    paces = [one.pace for one in state.robots.values() if one.pace is not None]
    return robot.pace or (statistics.median(paces) if paces else None)


Drafted = tuple[Draft, DraftRoute | None]
"""A draft, and its way if it has one."""


def draft_route(robot: Robot, draft: Draft, pace: float | None = None) -> DraftRoute | None:
    """Return the way along the graphs from place to place, None before there are two. `pace`: the robot's
    speed in m/s, None if none was seen."""
    here, places = place_of(robot), [(place.floor, ((place.vertex, 0.0),)) for place in draft.places]
    orders = () if draft.starts_here else robot.orders.open
    stops: list[GraphStop] = [*here, *places] if draft.starts_here else [*places]
    if len(stops) < 2:
        return None
    before = _end(robot, orders[-1]) if orders else here
    to_start, approach = way_between(robot, [] if draft.starts_here else [*before, stops[0]])
    lines, metres = way_between(robot, stops)
    by_lift = len({floor for floor, _ in stops}) > 1
    to_start = to_start if approach else {}
    return DraftRoute(lines, metres, by_lift, approach or 0.0, len(orders), pace, to_start)


def way_between(
    robot: Robot, stops: Sequence[GraphStop]
) -> tuple[Mapping[str, tuple[Line, ...]], float | None]:
    """Return the lines of a way by floor, and its metres, None if some of it has no way."""
    lines: dict[str, tuple[Line, ...]] = {}
    metres: float | None = 0.0
    for one, other in pairwise(stops):
        for floor, starts, ends in _on_each_floor(robot, one, other):
            routes = routes_of(robot.maps[floor]) if floor in robot.maps else None
            way = routes.shortest(starts, ends) if routes is not None else None
            if way is None or (way.start is None and starts != ends):
                metres = None
                continue
            lines[floor] = lines.get(floor, ()) + way.lines
            if metres is not None and way.lines:
                metres += way.length
    return lines, metres


def _end(robot: Robot, order: Order) -> list[GraphStop]:
    """Return the last place of an order, if it is on a graph."""
    return stop_at(robot, order.end.vertex if order.end is not None else "")


def stop_at(robot: Robot, vertex: str) -> list[GraphStop]:
    """Return a vertex with its floor, if it is on a graph; if ids repeat, on the robot's own."""
    known = [name for name, one in robot.maps.items() if one.graph and vertex in one.graph.vertices]
    floors = sorted(known, key=lambda name: name != robot.floor)
    return [(floors[0], ((vertex, 0.0),))] if floors else []


def place_of(robot: Robot) -> list[GraphStop]:
    """Return the place of the robot on the graph of its floor, if both are known."""
    floor = robot.floor
    routes = routes_of(robot.maps[floor]) if floor is not None and floor in robot.maps else None
    if routes is None or robot.pose is None or floor is None:
        return []
    return [(floor, routes.near(robot.pose.value))]


def _on_each_floor(
    robot: Robot, one: GraphStop, other: GraphStop
) -> Iterator[tuple[str, tuple[Spot, ...], tuple[Spot, ...]]]:
    """Yield the parts of a way on each floor: from one place to the other, or by the lifts."""
    (floor, starts), (to_floor, ends) = one, other
    if floor == to_floor:
        yield floor, starts, ends
        return
    for name, start, end in ((floor, starts, None), (to_floor, None, ends)):
        routes = routes_of(robot.maps[name]) if name in robot.maps else None
        lifts = routes.elevators if routes is not None else ()
        yield name, lifts if start is None else start, lifts if end is None else end

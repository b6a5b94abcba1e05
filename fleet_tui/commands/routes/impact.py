"""The orders whose way an edge is on, and how much longer their ways are without it."""

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.commands.routes.order_draft import GraphStop, place_of, stop_at, way_between
from fleet_tui.commands.routes.ways import AT_VERTEX
from fleet_tui.model.desk.desk import ClosedEdge, Ends, ends_of
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Line, metres_from
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.order import Order
from fleet_tui.model.robot import Robot, RobotMap
from fleet_tui.orders.local_queue import all_orders
from fleet_tui.situation.traffic import stops_left
from fleet_tui.text.language import Message

MOST_GRAPHS = 64
"""Graphs that are kept without an edge."""
IN_REACH = 1.0
"""Metres within which the map's cursor is on an edge."""


class CutOrder(Struct, frozen=True):
    """An order whose way an edge is on: `metres` of that way, and `around`: those of the shortest one without
    the edge, None if there is none."""

    robot: str
    order: Order
    metres: float
    around: float | None

    @property
    def further(self) -> float:
        """Return the metres of the detour, infinite without a way."""
        return math.inf if self.around is None else self.around - self.metres

    @property
    def text(self) -> Message:
        """Return the length of the detour in words."""
        if self.around is None:
            return Message("no way")
        more = round(self.further)
        return (
            Message("detour +{more} m ({around} m)", more=more, around=f"{self.around:.0f}")
            if more > 0
            else Message("another route, as long")
        )


def closed_edge_at(
    closed: Sequence[ClosedEdge], graph: RouteGraph, at: tuple[float, float]
) -> ClosedEdge | None:
    """Return the closed edge nearest to a place in metres, None without one within reach."""
    known = [edge for edge in closed if graph.vertices.keys() >= set(edge.ends[1:])]
    far = {edge: metres_from(at, _line(graph, edge.ends[1:])) for edge in known}
    nearest = min(far, key=lambda edge: far[edge], default=None)
    return nearest if nearest is not None and far[nearest] <= IN_REACH else None


def closed_on_way(
    closed: Sequence[ClosedEdge], robot: Robot, lines: Mapping[str, Sequence[Line]]
) -> list[ClosedEdge]:
    """Return the closed edges of a robot's graphs that a way is on, by its lines on each floor."""
    return [edge for edge in closed if _is_on(robot, edge.ends, lines)]


def _is_on(robot: Robot, ends: Ends, lines: Mapping[str, Sequence[Line]]) -> bool:
    floor, *vertices = ends
    graph = robot.maps[floor].graph if floor in robot.maps else None
    if graph is None or not graph.vertices.keys() >= set(vertices):
        return False
    return _has(lines.get(floor, ()), _line(graph, vertices))


def _has(lines: Sequence[Line], line: Line) -> bool:
    """Tell whether a line is among others, in any direction."""
    return line in lines or (*line[2:], *line[:2]) in lines


def cut_orders(state: FleetState, ends: Ends) -> list[CutOrder]:
    """Return the open orders whose way an edge is on, in the order of the robots and of their queues. Ways
    avoid all other closed edges."""
    closed = tuple(edge.ends for edge in state.desk.closed if edge.ends != ends)
    maps = _cut_maps(closed, (*closed, ends))
    return [cut for robot in state.robots.values() for cut in _cut(state, robot, ends, maps)]


class _CutMaps:
    """Maps of robots without the edges that are closed, before and after one more is; one for all robots with
    the same graph."""

    def __init__(self, before: Sequence[Ends], after: Sequence[Ends]) -> None:
        self._closed = before, after
        self._made: dict[tuple[str, int, bool], tuple[RouteGraph, RobotMap]] = {}

    def of(self, robot: Robot, after: bool) -> Robot:
        """Return a robot with such maps."""
        return replace(robot, maps={floor: self._cut(floor, one, after) for floor, one in robot.maps.items()})

    def _cut(self, floor: str, robot_map: RobotMap, after: bool) -> RobotMap:
        graph = robot_map.graph
        if graph is None:
            return robot_map
        key = floor, id(graph), after
        if key not in self._made:
            if len(self._made) >= MOST_GRAPHS:
                self._made.clear()
            self._made[key] = graph, RobotMap(graph=_without(graph, floor, self._closed[after]))
        return self._made[key][1]


@lru_cache(maxsize=2)
def _cut_maps(before: tuple[Ends, ...], after: tuple[Ends, ...]) -> _CutMaps:
    """Return the same maps, with the ways that were searched on them, for the same edges."""
    return _CutMaps(before, after)


def _without(graph: RouteGraph, floor: str, closed: Sequence[Ends]) -> RouteGraph:
    gone = {ends for ends in closed if ends[0] == floor}
    if not gone:
        return graph
    kept = tuple(edge for edge in graph.edges if ends_of(floor, edge.start, edge.end) not in gone)
    return replace(graph, edges=kept)


def _cut(state: FleetState, robot: Robot, ends: Ends, maps: _CutMaps) -> Iterator[CutOrder]:
    """Yield the orders of a robot whose way the edge is on."""
    floor, *vertices = ends
    graph = robot.maps[floor].graph if floor in robot.maps else None
    if graph is None or not all(vertex in graph.vertices for vertex in vertices):
        return
    line = _line(graph, vertices)
    here = place_of(robot)
    for order in all_orders(state, robot):
        if order.is_over:
            continue
        found = [stop_at(robot, stop.vertex) for stop in stops_left(robot, order)]
        stops = [place for places in found for place in places]
        if not here or not stops or not all(found):
            here = stops[-1:]  # a way that is not known is not told
            continue
        if (cut := _way_cut(robot, [*here, *stops], line, ends, maps)) is not None:
            yield CutOrder(robot.name, order, *cut)
        here = stops[-1:]


def _line(graph: RouteGraph, vertices: Sequence[str]) -> Line:
    one, other = (graph.vertices[vertex] for vertex in vertices)
    return one.x, one.y, other.x, other.y


def _way_cut(
    robot: Robot, stops: Sequence[GraphStop], line: Line, ends: Ends, maps: _CutMaps
) -> tuple[float, float | None] | None:
    """Return the metres of a way now, and without an edge; None if the edge is not on it."""
    lines, metres = way_between(maps.of(robot, after=False), stops)
    if metres is None:
        return None
    floor, spots = stops[0]
    towards = _first_vertex(robot, stops, lines)
    # A robot on the edge itself, between its ends, has to turn back.
    is_on_it = floor == ends[0] and {id_ for id_, _ in spots} == set(ends[1:])
    is_on_it &= any(id_ == towards and before > AT_VERTEX for id_, before in spots)
    if not is_on_it and not _has(lines.get(ends[0], ()), line):
        return None
    left = tuple(spot for spot in spots if not is_on_it or spot[0] != towards)
    left = tuple(spot for spot in left if math.isfinite(spot[1]))
    around_lines, around = way_between(maps.of(robot, after=True), [(floor, left), *stops[1:]])
    if around is not None:
        around += _before(spots, _first_vertex(robot, [(floor, left), *stops[1:]], around_lines))
    return metres + _before(spots, towards), around


def _before(spots: Sequence[tuple[str, float]], vertex: str) -> float:
    """Return the metres to the first vertex of a way."""
    metres = dict(spots).get(vertex, 0.0)
    return metres if math.isfinite(metres) else 0.0


def _first_vertex(robot: Robot, stops: Sequence[GraphStop], lines: Mapping[str, Sequence[Line]]) -> str:
    """Return the vertex at which a way begins."""
    floor, spots = stops[0]
    graph, on_floor = robot.maps[floor].graph, lines.get(floor, ())
    if graph is None or not spots:
        return ""
    if not on_floor:  # it is there, or the next stop is the vertex ahead
        goals = {id_ for id_, _ in stops[1][1]}
        return next((id_ for id_, _ in spots if id_ in goals), spots[0][0])
    begins = on_floor[0][:2]
    return next(
        (id_ for id_, _ in spots if (graph.vertices[id_].x, graph.vertices[id_].y) == begins), spots[0][0]
    )

"""Finding a vertex by typed text: part of a label, or an id."""

import re
from collections.abc import Sequence

from msgspec import Struct

from fleet_tui.model.commands import PlaceOrder
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import ORDER, ORDER_TO
from fleet_tui.model.order import vertices_of
from fleet_tui.model.request import Request, chain
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message

NUMBER = re.compile(r"-?[0-9]{1,10}", re.ASCII)


class Place(Struct, frozen=True):
    """A vertex that an order can name."""

    vertex: str
    name: str
    floor: str


HERE = Place("", "here", "")
"""The start of an order that begins where the robot is."""


def places(robot: Robot) -> list[Place]:
    """Return every labelled vertex of a robot's graphs, the floor it is on first, by label."""
    found = [
        Place(vertex, label, floor)
        for floor, robot_map in robot.maps.items()
        for vertex, label in robot_map.labels.items()
        if robot_map.graph is None or vertex in robot_map.graph.vertices
    ]
    return sorted(found, key=lambda place: (place.floor != robot.floor, place.name.casefold()))


def no_graphs(robot: Robot) -> str:
    """Return the floors of which a robot has no graph, as the rest of a sentence; empty if it has all, or
    that of the floor it is on."""
    missing = [floor for floor, robot_map in robot.maps.items() if robot_map.graph is None]
    if not missing or (robot.floor in robot.maps and robot.floor not in missing):
        return ""
    publishes = "graph" in robot.kind.reports or not robot.kind.name
    remedy = EMPTY if publishes else Message(": set [[floors]] graph = FILE in the configuration")
    return Message(": no graph of {missing}{remedy}", missing=", ".join(missing), remedy=remedy)


def recent_ends(state: FleetState, robot: Robot) -> list[str]:
    """Return the vertices to which the robot was last sent, newest first: by this console, and by its
    queue."""
    given = [
        record.command.stops[-1:]
        for record in reversed(state.commands)
        if isinstance(record.command, PlaceOrder) and record.command.robot == robot.name
    ]
    listed = [order.stops[-1:] for order in reversed(robot.orders.orders)]
    return list(dict.fromkeys(vertex for stops in given + listed for vertex in vertices_of(stops)))


def matches(robot: Robot, typed: str, recent: Sequence[str] = ()) -> list[Place]:
    """Return the places that typed text can mean, best first: whole label, id, start, part; among equals the
    `recent` ones."""
    wanted = typed.strip().casefold()
    rank = {vertex: place for place, vertex in enumerate(recent)}
    everything = sorted(places(robot), key=lambda place: rank.get(place.vertex, len(rank)))
    if not wanted:
        return everything
    whole = [place for place in everything if place.name.casefold() == wanted]
    starts = [place for place in everything if place.name.casefold().startswith(wanted)]
    parts = [place for place in everything if wanted in place.name.casefold()]
    return list(dict.fromkeys([*whole, *_by_id(robot, typed.strip()), *starts, *parts]))


def plain_id(word: str) -> str:
    """Return an id as a robot writes it: a number without leading zeros, any other text unchanged."""
    return str(int(word)) if NUMBER.fullmatch(word) else word


def _by_id(robot: Robot, typed: str) -> list[Place]:
    return [
        Place(vertex, robot_map.labels.get(vertex, vertex), floor)
        for floor, robot_map in robot.maps.items()
        for vertex in dict.fromkeys((typed, plain_id(typed)))
        if robot_map.graph is not None and vertex in robot_map.graph.vertices
    ]


def called(robot: Robot, word: str) -> list[Place]:
    """Return the places with exactly this label; only if there are none, those that differ in case."""
    everything = places(robot)
    same = [place for place in everything if place.name == word]
    return same or [place for place in everything if place.name.casefold() == word.casefold()]


def starts_here(robot: Robot) -> bool:
    """Tell whether an order may begin where the robot is: with cargo on board and no order, for a kind that
    reports no cargo, or one that takes no start."""
    accepts = robot.kind.accepts
    idle_with_cargo = robot.has_cargo and not robot.orders.orders
    return ORDER_TO in accepts and (ORDER not in accepts or idle_with_cargo or not robot.kind.brings_cargo)


def is_still(robot: Robot, place: Place) -> bool:
    """Tell whether a robot's graph and labels still have a place as it was listed."""
    known = robot.maps.get(place.floor)
    if known is None or (known.graph is not None and place.vertex not in known.graph.vertices):
        return False
    return known.labels.get(place.vertex, place.vertex) == place.name


def order_of(robot: Robot, visited: Sequence[Place]) -> Request:
    """Return orders that visit the places in sequence, the first of which may be HERE."""
    is_here = visited[0] == HERE
    named = visited[is_here:]
    floors = tuple((place.vertex, place.floor) for place in named)
    vertices = [place.vertex for place in named]
    return Request(chain(robot.name, vertices, is_here, robot.kind.takes_stops), floors)

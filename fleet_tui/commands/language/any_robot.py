"""Places of an order that anyone may drive: labels of all robots, each meant in a robot's own graph."""

from fleet_tui.commands.language.grammar import place_words
from fleet_tui.commands.language.lookup import Place, matches
from fleet_tui.commands.language.words import said, tokens
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.kind import ORDER
from fleet_tui.model.robot import Robot
from fleet_tui.text.errors import CommandError, did_you_mean
from fleet_tui.text.language import Message

ANYONE = "anyone"


def is_anyone(word: str, state: FleetState) -> bool:
    """Tell whether a word in the place of a robot means any: none at all, or `anyone`."""
    word = word.strip()
    return word not in state.robots and word.casefold() in ("", ANYONE)


def own_place(state: FleetState, robot: Robot, place: Place) -> Place | None:
    """Return a place of any robot on a robot's own graph: by its label, which must be unambiguous there; a
    vertex without one by its id, on the same graph only. None if it has no such place."""
    known = robot.maps.get(place.floor)
    if known is None or known.graph is None:
        return None
    named = [
        id_ for id_, label in known.labels.items() if label == place.name and id_ in known.graph.vertices
    ]
    if place.vertex in named or len(named) == 1:
        return place if place.vertex in named else Place(named[0], place.name, place.floor)
    is_same = not named and place.name == place.vertex and known.graph is _graph_of(state, place)
    return place if is_same else None


def _graph_of(state: FleetState, place: Place) -> RouteGraph | None:
    """Return the first graph with a vertex of this id."""
    maps = (robot.maps.get(place.floor) for robot in state.robots.values())
    graphs = (one.graph for one in maps if one is not None and one.graph is not None)
    return next((graph for graph in graphs if place.vertex in graph.vertices), None)


def any_matches(state: FleetState, typed: str) -> list[Place]:
    """Return the places of all robots that take orders that typed text can mean, the best of each first; a
    place of several robots once."""
    found: dict[tuple[str, str], Place] = {}
    for robot in _different(state):
        for place in matches(robot, typed):
            found.setdefault((place.name, place.floor), place)
    return sorted(found.values(), key=lambda place: place.name.casefold() != typed.strip().casefold())


def _different(state: FleetState) -> list[Robot]:
    """Return one robot for each set of graphs and labels: fleets often share them."""
    found = dict[object, Robot]()
    for robot in state.robots.values():
        if ORDER in robot.kind.accepts:
            known = ((name, id(one.graph), tuple(one.labels.items())) for name, one in robot.maps.items())
            found.setdefault(tuple(known), robot)
    return list(found.values())


def parse_anyone(line: str, state: FleetState) -> list[Place] | None:
    """Return the places of `anyone FROM TO`, None for any other line. CommandError names the wrong word."""
    found = tokens(line)
    if found[:1] and found[0].text.casefold() == "order":
        found = found[1:]
    if not found or not found[0].text or found[0].separates or not is_anyone(found[0].text, state):
        return None
    words = place_words(line, found[1:])
    if len(words) < 2 or not all(words):
        raise CommandError(Message("usage: {anyone} FROM TO, or {anyone} FROM > TO", anyone=ANYONE))
    return [_place(state, word) for word in words]


def _place(state: FleetState, word: str) -> Place:
    """Return the place of a word; CommandError if none or several have it."""
    found = any_matches(state, word)
    same = [place for place in found if word.casefold() == place.name.casefold()]
    meant = [place for place in same if place.name == word] or same
    meant = meant or [place for place in found if place.vertex == word]
    if not meant:
        near = did_you_mean(word, [place.name for place in any_matches(state, "")])
        raise CommandError(Message("no robot has a place {said}{near}", said=said(word), near=near))
    if len(meant) > 1:
        where = " and ".join(place.floor for place in meant)
        raise CommandError(
            Message("{said} is ambiguous: it is on {where}; name the robot", said=said(word), where=where)
        )
    return meant[0]

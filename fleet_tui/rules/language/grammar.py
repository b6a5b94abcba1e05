"""The command language: typed in the palette, in a file or after `fleet-tui`.

    robot_0 Base > Consumidores          robot_0 Base > A > B: Base -> A, then A -> B
    robot_0 > B                          the cargo on board to B; it alone if it reports no cargo
    order robot_0 Base Consumidores      the same without `>`; labels with spaces in quotes
    cancel 12, cancel robot_0 12         clear robot_0
    pause robot_0, pause all             resume robot_0, resume all

A robot is its name or its number, a place its label or its vertex id; `id=7` is always the id.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import assert_never

from msgspec import Struct

from fleet_tui.errors import CommandError, did_you_mean
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import natural, vertices_of
from fleet_tui.model.request import Request, chain
from fleet_tui.model.robot import Robot
from fleet_tui.rules.commands.local_queue import all_orders
from fleet_tui.rules.language.lookup import NUMBER, called, no_graphs, places, plain_id
from fleet_tui.rules.marks import numbered_robots

USAGE = {
    "order": "order ROBOT FROM TO, or ROBOT FROM > TO",
    "cancel": "cancel ROBOT ID",
    "clear": "clear ROBOT",
    "pause": "pause ROBOT, or pause all",
    "resume": "resume ROBOT, or resume all",
}
ALL = "all"

# A `-` belongs to the `>` after it only if it is separate: labels may end with one.
_TOKEN = re.compile(
    r"""(?P<to>(?<![^\s>])->|>)|"(?P<two>[^"]*)"(?=[\s>]|$)|'(?P<one>[^']*)'(?=[\s>]|$)|[^\s>]+"""
)


class Token(Struct, frozen=True):
    """A word of a line, without its quotes, from `start` to `end`; `>` separates places."""

    text: str
    start: int
    end: int
    separates: bool = False


def tokens(line: str) -> list[Token]:
    """Return the words of a line. A quote that is never closed is an ordinary letter."""
    found = []
    for match in _TOKEN.finditer(line):
        quoted = match["two"] if match["two"] is not None else match["one"]
        text = match[0] if quoted is None else quoted
        found.append(Token(text, match.start(), match.end(), match["to"] is not None))
    return found


def parse(line: str, state: FleetState, selected: str = "") -> Request:
    """Return the request of a line; `selected` is the robot if `cancel` names none. CommandError names the
    wrong word, and the nearest right one."""
    found = tokens(line)
    if any(token.separates for token in found):
        return _route(line, found, state)
    return parse_words([token.text for token in found], state, selected)


def parse_words(words: Sequence[str], state: FleetState, selected: str = "") -> Request:
    """Return the request of separate words, as a shell passes them."""
    if not words:
        raise CommandError("missing command: " + "; ".join(USAGE.values()))
    verb, *rest = words[0].casefold(), *words[1:]
    match verb, rest:
        case "order", [name, *named] if named:
            return _order(find_robot(name, state), named)
        case "cancel", [number] if selected in state.robots:
            return Request((CancelOrder(selected, _order_id(state, state.robots[selected], number)),))
        case "cancel", [name, number]:
            robot = find_robot(name, state)
            return Request((CancelOrder(robot.name, _order_id(state, robot, number)),))
        case "clear", [name]:
            return Request((ClearOrders(find_robot(name, state).name),))
        case "pause", [name]:
            return Request(tuple(map(PauseRobot, _robots(name, state))))
        case "resume", [name]:
            return Request(tuple(map(ResumeRobot, _robots(name, state))))
    if verb in USAGE:
        raise CommandError(f"usage: {USAGE[verb]}")
    name = find_robot(words[0], state, [*state.robots, *USAGE]).name
    raise CommandError(f"usage: {name} FROM > TO")


def find_robot(word: str, state: FleetState, known: Iterable[str] = ()) -> Robot:
    """Return a robot by its name, in any case if unambiguous, or by its number: of its key, or on the map."""
    same = [name for name in state.robots if name.casefold() == word.casefold()]
    for name in [word] if word in state.robots else same if len(same) == 1 else []:
        return state.robots[name]
    numbered = numbered_robots(word, state)
    if len(numbered) > 1:
        names = " or ".join(robot.name for robot in numbered)
        raise CommandError(f"{_said(word)} is ambiguous: {names}; type the name")
    if numbered:
        return numbered[0]
    near = did_you_mean(word, known or state.robots)
    raise CommandError(f"unknown robot{' or command' if known else ''} {_said(word)}{near}")


def _robots(word: str, state: FleetState) -> list[str]:
    if word.casefold() == ALL:
        return list(state.robots)
    return [find_robot(word, state).name]


def _order_id(state: FleetState, robot: Robot, word: str) -> str:
    """Return the id of a word: one of the queue, or any number, since the queue may be old."""
    if any(order.id == word for order in all_orders(state, robot)):
        return word
    if not NUMBER.fullmatch(word):
        raise CommandError(f"{_said(word)} is not an order id: copy it from the queue")
    return plain_id(word)


def _said(word: str) -> str:
    return repr(word if len(word) <= 40 else word[:39] + "…")


def _vertex_id(robot: Robot, word: str) -> str:
    """Return the vertex id of a word, empty for none: one of the robot's graphs, or any number."""
    if robot.name_of(word) is not None:
        return word
    return plain_id(word) if NUMBER.fullmatch(word) else ""


def _vertex(robot: Robot, word: str) -> tuple[str, str]:
    """Return the vertex of a word, and its floor if it was named by its label."""
    id_ = _vertex_id(robot, word.removeprefix("id="))
    if word.startswith("id=") and id_:
        return id_, ""
    if NUMBER.fullmatch(word) and word.startswith("-"):
        id_ = ""  # a negative number is an id only if marked as one
    found = {place.vertex: place for place in called(robot, word)}
    if not found and id_:
        return id_, ""
    if id_ and robot.name_of(id_) is not None:
        found.setdefault(id_, next(iter(found.values())))
    if not found:
        near = did_you_mean(word, [place.name for place in places(robot)]) or no_graphs(robot)
        raise CommandError(f"{robot.name} has no place {_said(word)}{near}")
    if len(found) > 1:
        ids = " or ".join(_id_word(vertex) for vertex in sorted(found, key=natural))
        raise CommandError(f"{_said(word)} is ambiguous for {robot.name}: use {ids}")
    ((vertex, place),) = found.items()
    return vertex, place.floor


def _order(robot: Robot, named: Sequence[str], only_to: bool = False) -> Request:
    """Return an order. A single place is the destination of the cargo on board."""
    found = [_vertex(robot, word) for word in named]
    vertices = [vertex for vertex, _ in found]
    floors = {vertex: floor for vertex, floor in found if floor}
    return Request(chain(robot.name, vertices, only_to or len(named) == 1, robot.kind.takes_stops), floors)


def _route(line: str, found: list[Token], state: FleetState) -> Request:
    """Parse `ROBOT FROM > TO > ...`, with or without `order` before it."""
    if found[0].text.casefold() == "order" and not found[0].separates:
        found = found[1:]
    if not found or found[0].separates:
        raise CommandError(f"missing robot before >: {USAGE['order']}")
    robot = find_robot(found[0].text, state)
    legs = [_label(line, leg) for leg in _legs(found[1:])]
    only_to = not legs[0]
    if only_to:
        legs = legs[1:]
    if not all(legs):
        raise CommandError(f"missing place beside >: {USAGE['order']}")
    return _order(robot, legs, only_to)


def _legs(found: Iterable[Token]) -> list[list[Token]]:
    legs: list[list[Token]] = [[]]
    for token in found:
        if token.separates:
            legs.append([])
        else:
            legs[-1].append(token)
    return legs


def _label(line: str, leg: list[Token]) -> str:
    """Return a label. Between two `>` its spaces belong to it."""
    if len(leg) == 1:
        return leg[0].text
    return line[leg[0].start : leg[-1].end] if leg else ""


def written(command: Command, state: FleetState) -> str:
    """Return a command as a line that `parse` accepts."""
    match command:
        case PlaceOrder(name, stops):
            robot = state.robots[name]
            return " ".join(["order", name, *(_word(robot, vertex) for vertex in vertices_of(stops))])
        case CancelOrder(name, order_id):
            return f"cancel {name} {_quoted(order_id)}"
        case ClearOrders(name):
            return f"clear {name}"
        case PauseRobot(name):
            return f"pause {name}"
        case ResumeRobot(name):
            return f"resume {name}"
        case _:
            assert_never(command)


def _word(robot: Robot, vertex: str) -> str:
    """Return the label, in quotes if needed, else the id."""
    name = robot.name_of(vertex)
    if name is None or not (word := next(_spellings(name), "")):
        return _id_word(vertex)
    try:
        return word if _vertex(robot, name)[0] == vertex else _id_word(vertex)
    except CommandError:
        return _id_word(vertex)


def _id_word(vertex: str) -> str:
    return _quoted(f"id={vertex}")


def _quoted(text: str) -> str:
    """Return a text as one word of a line, as far as possible."""
    return next(_spellings(text), text)


def _spellings(text: str) -> Iterator[str]:
    """Return the words of a line that parse to this text."""
    # One that begins with a quote might end at a quote in the next word.
    plain = [] if text.startswith(("'", '"')) else [text]
    for word in [*plain, f'"{text}"', f"'{text}'"]:
        found = tokens(word)
        if len(found) == 1 and found[0].text == text and not found[0].separates and found[0].end == len(word):
            yield word

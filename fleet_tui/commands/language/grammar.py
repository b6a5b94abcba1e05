"""The command language: typed in the palette, in a file or after `fleet-tui`.

    robot_0 Base > Consumidores          robot_0 Base > A > B: Base -> A, then A -> B
    robot_0 Base to Consumidores         the same, in words
    robot_0 > B                          the cargo on board to B; it alone if it reports no cargo
    order robot_0 Base Consumidores      the same without `>`; labels with spaces in quotes
    anyone Base Consumidores             for the nearest idle robot (`rules/language/anyone.py`)
    cancel 12, cancel robot_0 12         clear robot_0; cancel robot_0 goal
    pause robot_0, pause all             resume robot_0, resume all
    goto robot_0 Base, goto robot_0 3.5 2 90   to a place, or metres and degrees counter-clockwise
    set-pose robot_0 3.5 2 90            mapping robot_0 on; localise robot_0; settle robot_0 3

A robot is its name or its number, a place its label or its vertex id; `id=7` is always the id.
"""

from collections.abc import Iterable, Sequence
from typing import assert_never

from msgspec.structs import replace

from fleet_tui.commands.language import set_up
from fleet_tui.commands.language.lookup import NUMBER, plain_id
from fleet_tui.commands.language.words import Token, find_robot, quoted, said, tokens, vertex_of, word_of
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, PlaceOrder, ResumeRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import vertices_of
from fleet_tui.model.request import Request, chain
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import CancelGoal, SetUpCommand
from fleet_tui.orders.local_queue import all_orders
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message

USAGE = {
    "order": "order ROBOT FROM TO, or ROBOT FROM > TO",
    "cancel": "cancel ROBOT ID, or cancel ROBOT goal",
    "clear": "clear ROBOT",
    "pause": "pause ROBOT, or pause all",
    "resume": "resume ROBOT, or resume all",
    **set_up.USAGE,
}
ALL = "all"
GOAL = "goal"
TO = "to", "TO", "To"
"""Words that mean `>` in a line without one that begins with a robot."""


def parse(line: str, state: FleetState, selected: str = "") -> Request:
    """Return the request of a line; `selected` is the robot if `cancel` names none. CommandError names the
    wrong word, and the nearest right one."""
    found = tokens(line)
    if found and found[0].text.casefold() not in USAGE:
        found = _with_words(line, found)
    if any(token.separates for token in found):
        return _route(line, found, state)
    return parse_words([token.text for token in found], state, selected)


def _with_words(line: str, found: list[Token]) -> list[Token]:
    """Return the words of a line, `to` as `>` in one without that sign."""
    if any(token.separates for token in found):
        return found
    return [replace(token, separates=line[token.start : token.end] in TO) for token in found]


def place_words(line: str, found: list[Token]) -> list[str]:
    """Return the labels after a robot: between two `>` with their spaces, without it word by word."""
    found = _with_words(line, found)
    if any(token.separates for token in found):
        return [_label(line, leg) for leg in _legs(found)]
    return [token.text for token in found]


def parse_words(words: Sequence[str], state: FleetState, selected: str = "") -> Request:
    """Return the request of separate words, as a shell passes them."""
    if not words:
        raise CommandError(Message("missing command: {usage}", usage="; ".join(USAGE.values())))
    verb, *rest = words[0].casefold(), *words[1:]
    match verb, rest:
        case "order", [name, *named] if named:
            return _order(find_robot(name, state), named)
        case "cancel", [word] if selected in state.robots:
            return _cancel(state, state.robots[selected], word)
        case "cancel", [name, word]:
            return _cancel(state, find_robot(name, state), word)
        case "clear", [name]:
            return Request((ClearOrders(find_robot(name, state).name),))
        case "pause" | "resume", [name]:
            kind = PauseRobot if verb == "pause" else ResumeRobot
            return Request(tuple(map(kind, _robots(name, state))))
        case _, [name, *values] if verb in set_up.USAGE:
            if request := set_up.parse_set_up(verb, find_robot(name, state), values):
                return request
    if verb in USAGE:
        raise CommandError(Message("usage: {usage}", usage=USAGE[verb]))
    name = find_robot(words[0], state, [*state.robots, *USAGE]).name
    raise CommandError(Message("usage: {name} FROM > TO, or {name} > TO", name=name))


def _cancel(state: FleetState, robot: Robot, word: str) -> Request:
    """Return the cancellation of an order, or of a goal beside the queue."""
    if word.casefold() == GOAL and not robot.kind.keeps_goals:
        return Request((CancelGoal(robot.name),))
    return Request((CancelOrder(robot.name, _order_id(state, robot, word)),))


def _robots(word: str, state: FleetState) -> list[str]:
    if word.casefold() == ALL:
        return list(state.robots)
    return [find_robot(word, state).name]


def _order_id(state: FleetState, robot: Robot, word: str) -> str:
    """Return the id of a word: one of the queue, or any number, since the queue may be old."""
    if any(order.id == word for order in all_orders(state, robot)):
        return word
    if not NUMBER.fullmatch(word):
        raise CommandError(Message("{said} is not an order id: copy it from the queue", said=said(word)))
    return plain_id(word)


def _order(robot: Robot, named: Sequence[str], only_to: bool = False) -> Request:
    """Return an order. A single place is the destination of the cargo on board."""
    found = [vertex_of(robot, word) for word in named]
    vertices = [vertex for vertex, _ in found]
    floors = tuple((vertex, floor) for vertex, floor in found if floor)
    return Request(chain(robot.name, vertices, only_to or len(named) == 1, robot.kind.takes_stops), floors)


def _route(line: str, found: list[Token], state: FleetState) -> Request:
    """Parse `ROBOT FROM > TO > ...`, with or without `order` before it."""
    if found[0].text.casefold() == "order" and not found[0].separates:
        found = found[1:]
    if not found or found[0].separates:
        raise CommandError(Message("missing robot before >: {usage}", usage=USAGE["order"]))
    robot = find_robot(found[0].text, state)
    legs = place_words(line, found[1:])
    only_to = not legs[0]
    if only_to:
        legs = legs[1:]
    if not all(legs):
        raise CommandError(Message("missing place beside >: {usage}", usage=USAGE["order"]))
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
    """Return a command as a line that `parse` accepts, empty for one that can't be typed."""
    match command:
        case PlaceOrder(name, stops):
            robot = state.robots[name]
            if (goal := stops[-1].pose) is not None:
                return f"goto {name} {set_up.written_pose(goal, stops[-1].turns_freely)}"
            return " ".join(["order", name, *(word_of(robot, vertex) for vertex in vertices_of(stops))])
        case CancelOrder(name, order_id):
            return f"cancel {name} {quoted(order_id)}"
        case ClearOrders(name):
            return f"clear {name}"
        case PauseRobot(name):
            return f"pause {name}"
        case ResumeRobot(name):
            return f"resume {name}"
        case SetUpCommand():
            return set_up.written_set_up(command)
        case _:
            assert_never(command)

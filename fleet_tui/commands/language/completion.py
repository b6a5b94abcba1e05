"""Completion of a typed command."""

from collections.abc import Iterable, Sequence

from fleet_tui.commands.language.any_robot import ANYONE, any_matches, is_anyone
from fleet_tui.commands.language.grammar import ALL, GOAL, USAGE
from fleet_tui.commands.language.lookup import places, recent_ends
from fleet_tui.commands.language.set_up import USAGE as SET_UP
from fleet_tui.commands.language.set_up import ability_of
from fleet_tui.commands.language.words import Token, find_robot, tokens
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import GOAL_CANCEL
from fleet_tui.model.robot import Robot
from fleet_tui.model.robot_numbers import typed_number
from fleet_tui.orders.local_queue import all_orders
from fleet_tui.text.errors import CommandError


def is_command(line: str, state: FleetState) -> bool:
    """Tell whether a line begins as a command: with a verb or a robot, and more after it."""
    found = tokens(line)
    if not found or (len(found) == 1 and not line[-1:].isspace()):
        return False
    word = found[0].text
    return (
        word.casefold() in USAGE
        or typed_number(word, state) is not None
        or _robot(found[0], state) is not None
    )


def complete(line: str, state: FleetState, selected: str = "") -> list[str]:
    """Return the completions of the last word of a line, best first."""
    done = tokens(line)
    start = len(line)
    if done and not done[-1].separates and not line[-1].isspace():
        start = done.pop().start
    if not done:
        verbs = [verb for verb in USAGE if _able(state, verb)]
        everybody = [f"{verb} {ALL}" for verb in ("pause", "resume") if verb in verbs]
        anyone = [ANYONE] if "order" in verbs else []
        return _lines(line, start, [*verbs, *everybody, *anyone, *state.robots]) if line else []
    verb = done[0].text.casefold() if done[0].text.casefold() in USAGE else ""
    named = done[1:] if verb else done
    if named and is_anyone(named[0].text, state) and verb in ("", "order"):
        names = dict.fromkeys(place.name for place in any_matches(state, ""))
        return _lines(line, start, [_quoted(name) if " " in name else name for name in names])
    if verb in ("", "order"):
        return _order(line, named, start, verb, state)
    if verb == "cancel":
        return _cancel(line, named, start, state, selected)
    if verb in SET_UP:
        return _set_up(line, named, start, verb, state)
    if named:
        return []
    robots = _able(state, verb)
    return _lines(line, start, robots if verb == "clear" or not robots else [ALL, *robots], last=True)


def _able(state: FleetState, verb: str) -> list[str]:
    """Return the robots that accept the request of a verb."""
    return [name for name, robot in state.robots.items() if _can(robot, verb)]


def _can(robot: Robot, verb: str) -> bool:
    return robot.kind.can(ability_of(verb, robot.kind) if verb in SET_UP else verb)


def _robot(token: Token, state: FleetState) -> Robot | None:
    try:
        return find_robot(token.text, state)
    except CommandError:
        return None


def _lines(line: str, start: int, words: Iterable[str], last: bool = False) -> list[str]:
    """Return the line with its last part, from `start`, replaced by each of the words that begin with it,
    else contain it."""
    typed = line[start:].strip("\"' ").casefold()
    words = list(words)
    found = [word for word in words if word.strip("\"'").casefold().startswith(typed)]
    found = found or [word for word in words if typed in word.casefold()]
    return [line[:start] + word + ("" if last else " ") for word in found]


def _cancel(line: str, named: Sequence[Token], start: int, state: FleetState, selected: str) -> list[str]:
    robot = _robot(named[0], state) if named else state.robots.get(selected)
    if len(named) > 1:
        return []
    ids = [order.id for order in all_orders(state, robot)] if robot and robot.kind.can("cancel") else []
    ids += [GOAL] if robot and robot.kind.can(GOAL_CANCEL) else []
    found = _lines(line, start, ids, last=True)
    return found if named else [*found, *_lines(line, start, _able(state, "cancel"))]


def _set_up(line: str, named: Sequence[Token], start: int, verb: str, state: FleetState) -> list[str]:
    if not named:
        return _lines(line, start, _able(state, verb), last=verb in ("localise", "settle"))
    robot = _robot(named[0], state)
    if robot is None or len(named) > 1 or not _can(robot, verb):
        return []
    if verb == "mapping":
        return _lines(line, start, ["on", "off"], last=True)
    if verb in ("store-map", "store-pose-graph"):
        return _lines(line, start, [robot.floor] if robot.floor else [], last=True)
    labels = [place.name for place in places(robot)] if verb == "goto" else []
    return _lines(line, start, [_quoted(name) if " " in name else name for name in labels], last=True)


def _order(line: str, named: Sequence[Token], start: int, verb: str, state: FleetState) -> list[str]:
    robot = _robot(named[0], state) if named else None
    if robot is None:
        return [] if named else _lines(line, start, _able(state, "order"))
    if not robot.kind.can("order"):
        return []
    known = places(robot)
    rank = {vertex: place for place, vertex in enumerate(recent_ends(state, robot))}
    known.sort(key=lambda place: rank.get(place.vertex, len(rank)))
    names = list(dict.fromkeys(place.name for place in known))
    # Between two `>` spaces belong to the label; with `order` and no `>` a word ends at one.
    separators = [token.end for token in named if token.separates]
    if verb and not separators:
        return _lines(line, start, [_quoted(name) if " " in name else name for name in names])
    begin = separators[-1] if separators else named[0].end
    typed = line[begin:].strip("\"' ")
    if typed and line[-1].isspace() and typed.casefold() in {name.casefold() for name in names}:
        return [line + "> "]
    begin += len(line[begin:]) - len(line[begin:].lstrip())
    lead = line[:begin] if line[:begin][-1:].isspace() else line[:begin] + " "
    return _lines(lead + line[begin:], len(lead), [_quoted(name) if ">" in name else name for name in names])


def _quoted(name: str) -> str:
    return f"'{name}'" if '"' in name else f'"{name}"'

"""Words of a line, and the robots and vertices that they mean."""

import re
from collections.abc import Iterable, Iterator

from msgspec import Struct

from fleet_tui.commands.language.lookup import NUMBER, called, no_graphs, places, plain_id
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import natural
from fleet_tui.model.robot import Robot
from fleet_tui.model.robot_numbers import typed_number
from fleet_tui.text.errors import CommandError, did_you_mean
from fleet_tui.text.language import Message

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


def find_robot(word: str, state: FleetState, known: Iterable[str] = ()) -> Robot:
    """Return a robot by its name, in any case if unambiguous, or by its number."""
    same = [name for name in state.robots if name.casefold() == word.casefold()]
    for name in [word] if word in state.robots else same if len(same) == 1 else []:
        return state.robots[name]
    if (numbered := typed_number(word, state)) is not None:
        return numbered
    near = did_you_mean(word, known or state.robots)
    raise CommandError(
        Message(
            "unknown robot{or_command} {said}{near}",
            or_command=Message(" or command") if known else "",
            said=said(word),
            near=near,
        )
    )


def said(word: str) -> str:
    """Return a word as it is quoted in a message."""
    return repr(word if len(word) <= 40 else word[:39] + "…")


def _vertex_id(robot: Robot, word: str) -> str:
    """Return the vertex id of a word, empty for none: one of the robot's graphs, or any number."""
    if robot.name_of(word) is not None:
        return word
    return plain_id(word) if NUMBER.fullmatch(word) else ""


def vertex_of(robot: Robot, word: str) -> tuple[str, str]:
    """Return the vertex of a word, and its floor if it was named by its label."""
    id_ = _vertex_id(robot, word.removeprefix("id="))
    if word.startswith("id=") and id_:
        return id_, ""
    if NUMBER.fullmatch(word) and word.startswith("-"):
        id_ = ""  # a negative number is an id only if marked as one
    # Where floors share the id, the robot's own floor, which is listed first, is meant.
    found = {place.vertex: place for place in reversed(called(robot, word))}
    if not found and id_:
        return id_, ""
    if id_ and robot.name_of(id_) is not None:
        found.setdefault(id_, next(iter(found.values())))
    if not found:
        near = did_you_mean(word, [place.name for place in places(robot)]) or no_graphs(robot)
        raise CommandError(
            Message("{name} has no place {said}{near}", name=robot.name, said=said(word), near=near)
        )
    if len(found) > 1:
        ids = " or ".join(id_word(vertex) for vertex in sorted(found, key=natural))
        raise CommandError(
            Message("{said} is ambiguous for {name}: use {ids}", said=said(word), name=robot.name, ids=ids)
        )
    ((vertex, place),) = found.items()
    return vertex, place.floor


def id_word(vertex: str) -> str:
    """Return the word that always means the vertex of an id."""
    return quoted(f"id={vertex}")


def word_of(robot: Robot, vertex: str) -> str:
    """Return the label, in quotes if needed, else the id."""
    name = robot.name_of(vertex)
    if name is None or not (word := next(_spellings(name), "")):
        return id_word(vertex)
    try:
        return word if vertex_of(robot, name)[0] == vertex else id_word(vertex)
    except CommandError:
        return id_word(vertex)


def quoted(text: str) -> str:
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

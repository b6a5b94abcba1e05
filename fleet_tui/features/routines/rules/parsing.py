"""Reading a routine: its lines as nested blocks, and every problem with its line.

every weekday 06:30          # used by `fleet-tui routine install`
for robot_0 robot_1          # the blocks of each, at the same time
  go Base
  repeat 3
    carry Base Consumidores
    if battery < 30
      wait until battery > 80
    else
      run check.py
    end
  end
  on failure
    go Base
  end
end
"""

import re
import shlex
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import pairwise
from typing import TypeVar

from msgspec.structs import replace

from fleet_tui.commands.language.words import said
from fleet_tui.features.routines.blocks import (
    DAYS,
    BatteryCondition,
    Block,
    CarryBlock,
    Condition,
    DayTime,
    GoBlock,
    IdleCondition,
    IfBlock,
    LanePlan,
    Leaf,
    ParsedRoutine,
    PlaceCondition,
    RepeatBlock,
    Routine,
    RoutineProblem,
    RunBlock,
    Schedule,
    TimeSpan,
    WaitBlock,
)
from fleet_tui.text.errors import CommandError, did_you_mean
from fleet_tui.text.language import Message, joined, message_of, verbatim
from fleet_tui.text.limits import LONGEST_NAME, truncate

USAGE = {
    "go": "go PLACE",
    "carry": "carry FROM TO [TO ...]",
    "wait": "wait 30 s, wait until 06:45, wait until idle, at PLACE or battery > 80",
    "run": "run PROGRAM [ARG ...], or run within 5 min PROGRAM [ARG ...]",
}
CONDITIONS = "use battery < 30, battery > 80, idle or at PLACE"
RUN_WITHIN = 600.0
"""Seconds after which a program is ended, unless the routine says otherwise."""
LONGEST_WAIT = 7 * 86400.0
"""Seconds of the longest wait."""
_UNITS = {"s": 1.0, "min": 60.0, "h": 3600.0}
_DURATION = re.compile(r"([0-9]{1,6}(?:\.[0-9]{1,3})?) ?(s|min|h)", re.ASCII)
_TIME = re.compile(r"([01]?[0-9]|2[0-3]):([0-5][0-9])", re.ASCII)
_BATTERY = re.compile(r"battery ?([<>]) ?([0-9]{1,3}(?:\.[0-9]{1,3})?) ?%?", re.ASCII)


MOST_LINES = 2000
DEEPEST = 20
MOST_TIMES = 10_000
MOST_LANES = 100
"""Lines of a file, blocks within each other, rounds of a `repeat`, robots."""
_KEYWORDS = (*USAGE, "every", "for", "repeat", "if", "else", "on failure", "end")
_FAILURE = ["on", "failure"]
T = TypeVar("T")


def instruction(line: int, words: Sequence[str]) -> tuple[Leaf, ...]:
    """Return the instructions of a line: one for each leg of a carry. Raises CommandError."""
    text = verbatim(truncate(" ".join(words), LONGEST_NAME))
    match list(words):
        case ["go", place]:
            return (GoBlock(line, text, place),)
        case ["carry", *places] if len(places) > 1:
            return tuple(
                CarryBlock(line, f"carry {one} {other}", one, other) for one, other in pairwise(places)
            )
        case ["wait", "until", *rest] if rest:
            return (WaitBlock(line, text, _until(rest)),)
        case ["wait", *rest] if rest:
            return (WaitBlock(line, text, TimeSpan(_seconds(rest))),)
        case ["run", "within", number, *program] if _is_duration(number) and program:
            return (RunBlock(line, text, tuple(program), _seconds([number])),)
        case ["run", "within", number, unit, *program] if _is_duration(number + unit) and program:
            return (RunBlock(line, text, tuple(program), _seconds([number, unit])),)
        case ["run", *program] if program and program[0] != "within":
            return (RunBlock(line, text, tuple(program), RUN_WITHIN),)
    raise CommandError(Message("usage: {usage}", usage=USAGE[words[0]]))


def condition(words: Sequence[str]) -> Condition:
    """Return the condition of a wait or an `if`. Raises CommandError."""
    match list(words):
        case ["idle"]:
            return IdleCondition()
        case ["at", place]:
            return PlaceCondition(place)
    found = _BATTERY.fullmatch(" ".join(words))
    if found is None:
        raise CommandError(
            Message(
                "unknown condition {said}: {conditions}", said=said(" ".join(words)), conditions=CONDITIONS
            )
        )
    if float(found[2]) > 100.0:
        raise CommandError(Message("battery {said} is above 100 per cent: use 0 to 100", said=said(found[2])))
    return BatteryCondition(found[1] == ">", float(found[2]))


def schedule(words: Sequence[str]) -> Schedule:
    """Return the schedule after `every`. Raises CommandError."""
    if len(words) != 2:
        raise CommandError(Message("usage: every weekday 06:30; day, weekday, or monday to sunday"))
    day = words[0].casefold()
    days = {"day": tuple(range(7)), "weekday": tuple(range(5)), **{name: (n,) for n, name in enumerate(DAYS)}}
    if day not in days:
        raise CommandError(
            Message(
                "unknown day {said}{did_you_mean}", said=said(words[0]), did_you_mean=did_you_mean(day, days)
            )
        )
    return Schedule(days[day], _day_time(words[1]))


def _until(words: Sequence[str]) -> DayTime | Condition:
    return _day_time(words[0]) if len(words) == 1 and words[0][:1].isdigit() else condition(words)


def _day_time(word: str) -> DayTime:
    found = _TIME.fullmatch(word)
    if found is None:
        raise CommandError(
            Message("{said} is not a time: write it as 06:30, from 00:00 to 23:59", said=said(word))
        )
    return DayTime(60 * int(found[1]) + int(found[2]))


def _is_duration(text: str) -> bool:
    return _DURATION.fullmatch(text) is not None


def _seconds(words: Sequence[str]) -> float:
    found = _DURATION.fullmatch(" ".join(words))
    if found is None:
        raise CommandError(
            Message("{said} is not a duration: write it as 30 s, 5 min or 1 h", said=said(" ".join(words)))
        )
    seconds = float(found[1]) * _UNITS[found[2]]
    if seconds > LONGEST_WAIT:
        raise CommandError(
            Message("{said} is over 7 days: use a schedule (every weekday 06:30)", said=said(" ".join(words)))
        )
    return seconds


class _TooDeepError(CommandError):
    """Blocks within each other beyond the limit: the rest of the file is not read."""


def parse_routine(text: str) -> ParsedRoutine:
    """Return the routine of a file, and all its problems in the order of their lines."""
    # As editors count them: what else splits a line would begin an instruction within a comment.
    lines = text.removesuffix("\n").split("\n")
    reader = _Reader()
    if len(lines) > MOST_LINES:
        reader.wrong(
            MOST_LINES + 1,
            Message("over {limit} lines: divide the routine into several files", limit=MOST_LINES),
        )
    reader.lines = deque(reader.split(lines[:MOST_LINES]))
    routine = reader.routine()
    return ParsedRoutine(routine, tuple(sorted(reader.problems, key=lambda problem: problem.line)))


class _Reader:
    """Takes lines from the start of `lines`, as far as they belong to a block."""

    def __init__(self) -> None:
        self.lines: deque[tuple[int, list[str]]] = deque()
        self.problems: list[RoutineProblem] = []

    def wrong(self, line: int, text: Message) -> None:
        """Keep a problem."""
        self.problems.append(RoutineProblem(line, text))

    def split(self, lines: Sequence[str]) -> Iterator[tuple[int, list[str]]]:
        """Yield the words of each line that has any."""
        for number, text in enumerate(lines, 1):
            try:
                words = shlex.split(text, comments=True)
            except ValueError:
                self.wrong(
                    number, Message("a quotation mark is not closed: close it, or write it as \\' or \\\"")
                )
                continue
            if words:
                yield number, [words[0].casefold(), *words[1:]]

    def routine(self) -> Routine:
        """Read the whole file."""
        schedules, lanes, failure = list[Schedule](), list[LanePlan](), list[Block]()
        while self.lines:
            number, words = self.lines.popleft()
            try:
                match words:
                    case ["every", *rest] if not lanes:
                        schedules.append(schedule(rest))
                    case ["for", *robots]:
                        lanes += self._lanes(number, robots, lanes)
                    case ["on", "failure"] if not failure:
                        failure = self._closed("on failure", number, 1)
                    case _:
                        raise CommandError(_misplaced(words))
            except _TooDeepError as problem:
                self.wrong(number, message_of(problem))
                break
            except CommandError as problem:
                self.wrong(number, message_of(problem))
        if not lanes and not self.problems:
            self.wrong(1, Message("no lane: begin one with for ROBOT, and close it with end"))
        return Routine(
            tuple(lane if lane.on_failure else replace(lane, on_failure=tuple(failure)) for lane in lanes),
            tuple(schedules),
        )

    def _lanes(self, number: int, robots: Sequence[str], others: Sequence[LanePlan]) -> list[LanePlan]:
        body, failure = self._blocks(2), list[Block]()
        if self.lines and self.lines[0][1] == _FAILURE:
            failure = self._closed("on failure", self.lines.popleft()[0], 2)
        self._end("for", number, 2)
        if not robots:
            raise CommandError(Message("usage: for ROBOT [ROBOT ...]"))
        if len(robots) + len(others) > MOST_LANES:
            raise CommandError(
                Message(
                    "over {most_lanes} robots: divide the routine into several files", most_lanes=MOST_LANES
                )
            )
        return [LanePlan(robot, number, tuple(body), tuple(failure)) for robot in robots]

    def _closed(self, word: str, number: int, depth: int) -> list[Block]:
        """Read the blocks up to `end`."""
        body = self._blocks(depth + 1)
        self._end(word, number, depth)
        return body

    def _end(self, word: str, number: int, depth: int) -> None:
        """Take the `end` of a block; anything before it is misplaced."""
        while self.lines:
            at, words = self.lines[0]
            if words == ["end"]:
                self.lines.popleft()
                return
            if words[0] == "else" or words == _FAILURE:
                self.lines.popleft()
                self.wrong(at, _misplaced(words))
            else:
                self.wrong(at, Message("put it before on failure, which is the last part of its lane"))
            self._blocks(depth + 1)
        self.wrong(number, Message("{word} is not closed: add end", word=word))

    def _blocks(self, depth: int) -> list[Block]:
        """Read blocks up to the line that ends them."""
        if depth > DEEPEST + 1:
            raise _TooDeepError(
                Message("over {deepest} blocks within each other: use fewer", deepest=DEEPEST)
            )
        found = list[Block]()
        while self.lines and self.lines[0][1] not in (["end"], ["else"], _FAILURE):
            number, words = self.lines.popleft()
            match words[0]:
                case "repeat":
                    times = self._tried(number, partial(_times, words[1:]))
                    body = tuple(self._closed("repeat", number, depth))
                    found.append(RepeatBlock(number, joined(" ", words), times, body))
                case "if":
                    found += self._if(number, words, depth)
                case _:
                    found += self._tried(number, partial(_instruction, number, words)) or ()
        return found

    def _if(self, number: int, words: list[str], depth: int) -> list[Block]:
        asked: Condition | None = self._tried(number, partial(condition, words[1:]))
        body, otherwise = self._blocks(depth + 1), list[Block]()
        if self.lines and self.lines[0][1] == ["else"]:
            self.lines.popleft()
            otherwise = self._blocks(depth + 1)
        self._end("if", number, depth)
        if asked is None:
            return []
        return [IfBlock(number, joined(" ", words), asked, tuple(body), tuple(otherwise))]

    def _tried(self, number: int, read: Callable[[], T]) -> T | None:
        """Return what is read, or keep the problem."""
        try:
            return read()
        except CommandError as problem:
            self.wrong(number, message_of(problem))
            return None


def _times(words: Sequence[str]) -> int | None:
    if not words:
        return None
    count = int(words[0]) if len(words) == 1 and words[0].isascii() and words[0].isdigit() else 0
    if not 1 <= count <= MOST_TIMES:
        raise CommandError(
            Message("usage: repeat, or repeat N with N from 1 to {most_times}", most_times=MOST_TIMES)
        )
    return count


def _instruction(number: int, words: Sequence[str]) -> tuple[Block, ...]:
    if words[0] not in USAGE:
        raise CommandError(_misplaced(words))
    return instruction(number, words)


def _misplaced(words: Sequence[str]) -> Message:
    """Return the problem of a line that is known, but not here, or that is unknown."""
    places = {
        "every": Message("every: put it at the start of the file"),
        "for": Message("for inside a block: close that block with end first"),
        "end": Message("end without a block: remove it"),
        "else": Message("else without if before it: write else alone in its line, after if"),
        "on": Message("on failure: put it alone in its line, once, at the end of a lane or of the file"),
    }
    if words[0] in places:
        return places[words[0]]
    if words[0] in _KEYWORDS:
        return Message("{words} outside a lane: put it between for ROBOT and end", words=words[0])
    return Message(
        "unknown instruction {said}{did_you_mean}",
        said=said(words[0]),
        did_you_mean=did_you_mean(words[0], _KEYWORDS),
    )

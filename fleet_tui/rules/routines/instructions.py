"""The instructions of one line of a routine, apart from the blocks around it."""

import re
from collections.abc import Sequence
from itertools import pairwise

from fleet_tui.errors import CommandError, did_you_mean
from fleet_tui.model.routines.blocks import (
    DAYS,
    BatteryCondition,
    CarryBlock,
    Condition,
    DayTime,
    GoBlock,
    IdleCondition,
    Leaf,
    PlaceCondition,
    RunBlock,
    Schedule,
    TimeSpan,
    WaitBlock,
)
from fleet_tui.rules.language.words import said
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


def instruction(line: int, words: Sequence[str]) -> tuple[Leaf, ...]:
    """Return the instructions of a line: one for each leg of a carry. Raises CommandError."""
    text = truncate(" ".join(words), LONGEST_NAME)
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
    raise CommandError(f"usage: {USAGE[words[0]]}")


def condition(words: Sequence[str]) -> Condition:
    """Return the condition of a wait or an `if`. Raises CommandError."""
    match list(words):
        case ["idle"]:
            return IdleCondition()
        case ["at", place]:
            return PlaceCondition(place)
    found = _BATTERY.fullmatch(" ".join(words))
    if found is None:
        raise CommandError(f"unknown condition {said(' '.join(words))}: {CONDITIONS}")
    if float(found[2]) > 100.0:
        raise CommandError(f"battery {said(found[2])} is above 100 per cent: use 0 to 100")
    return BatteryCondition(found[1] == ">", float(found[2]))


def schedule(words: Sequence[str]) -> Schedule:
    """Return the schedule after `every`. Raises CommandError."""
    if len(words) != 2:
        raise CommandError("usage: every weekday 06:30; day, weekday, or monday to sunday")
    day = words[0].casefold()
    days = {"day": tuple(range(7)), "weekday": tuple(range(5)), **{name: (n,) for n, name in enumerate(DAYS)}}
    if day not in days:
        raise CommandError(f"unknown day {said(words[0])}{did_you_mean(day, days)}")
    return Schedule(days[day], _day_time(words[1]))


def _until(words: Sequence[str]) -> DayTime | Condition:
    return _day_time(words[0]) if len(words) == 1 and words[0][:1].isdigit() else condition(words)


def _day_time(word: str) -> DayTime:
    found = _TIME.fullmatch(word)
    if found is None:
        raise CommandError(f"{said(word)} is not a time: write it as 06:30, from 00:00 to 23:59")
    return DayTime(60 * int(found[1]) + int(found[2]))


def _is_duration(text: str) -> bool:
    return _DURATION.fullmatch(text) is not None


def _seconds(words: Sequence[str]) -> float:
    found = _DURATION.fullmatch(" ".join(words))
    if found is None:
        raise CommandError(f"{said(' '.join(words))} is not a duration: write it as 30 s, 5 min or 1 h")
    seconds = float(found[1]) * _UNITS[found[2]]
    if seconds > LONGEST_WAIT:
        raise CommandError(f"{said(' '.join(words))} is over 7 days: use a schedule (every weekday 06:30)")
    return seconds

"""Marks of robots: the numbers by which keys, the map, and people tell them apart."""

import re
from functools import lru_cache

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot

LONGEST = 4
"""Digits of a mark."""
LAST_KEY = 9
"""The last number that is a key."""


@lru_cache(maxsize=4)
def marks_of(names: tuple[str, ...]) -> tuple[str, ...]:
    """Return the numbers at the ends of the names if these tell all robots apart, else their places in the
    configuration, from 1."""
    found = [re.search(r"[0-9]+$", name) for name in names]
    marks = tuple(number[0] for number in found if number and len(number[0]) <= LONGEST)
    if len(names) == len(marks) == len({int(mark) for mark in marks}):
        return marks
    return tuple(str(place + 1) for place in range(len(names)))


def numbered(state: FleetState, number: int) -> Robot | None:
    """Return the robot with this number as its mark, which is its key, too, from 1 to LAST_KEY."""
    marks = marks_of(tuple(state.robots))
    return next(
        (robot for robot, mark in zip(state.robots.values(), marks, strict=True) if int(mark) == number), None
    )


def typed_number(word: str, state: FleetState) -> Robot | None:
    """Return the robot that a typed number means, None for any other word."""
    return numbered(state, int(word)) if re.fullmatch(r"[0-9]{1,10}", word) else None


def mark_of(state: FleetState, robot: Robot) -> str:
    return marks_of(tuple(state.robots))[list(state.robots).index(robot.name)]

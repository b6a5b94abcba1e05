"""Marks of robots: the numbers by which the map, and people, tell them apart."""

import re
from functools import lru_cache

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot

LONGEST = 4
"""Digits of a mark."""


@lru_cache(maxsize=4)
def marks_of(names: tuple[str, ...]) -> tuple[str, ...]:
    """Return the last digits of the names if these tell all robots apart, else their places in the
    configuration, from 1."""
    found = [re.findall(r"[0-9]+", name)[-1:] for name in names]
    marks = tuple(digits[0] for digits in found if digits and len(digits[0]) <= LONGEST)
    if len(names) == len(marks) == len({int(mark) for mark in marks}):
        return marks
    return tuple(str(place + 1) for place in range(len(names)))


def numbered_robots(word: str, state: FleetState) -> list[Robot]:
    """Return the robots that a typed number can mean: by its key, or by its number on the map."""
    if not re.fullmatch(r"[0-9]{1,10}", word):
        return []
    robots, wanted = state.robots.values(), int(word)
    marks = marks_of(tuple(state.robots))
    return [robot for robot, mark in zip(robots, marks, strict=True) if wanted in (robot.number, int(mark))]

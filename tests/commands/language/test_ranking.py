"""Typed text finds lines by words: whole ones before beginnings, beginnings before anything within."""

import pytest

from fleet_tui.commands.language.ranking import rank

LINES = {
    "Toggle the zoom centre: robot or view": "",
    "Centre on the selected robot, once": "",
    "Open the recent events": "",
    "Go to robot robot_10": "robot_10",
    "Go to robot robot_1": "robot_1",
    "Store the map": "",
    "Go to vertex Store": "Store",
}


@pytest.mark.parametrize(
    ("typed", "found"),
    [
        ("cen", ["Centre on", "Toggle the zoom", "Open the recent"]),
        ("robot_1", ["Go to robot robot_1", "Go to robot robot_10"]),
        ("store", ["Go to vertex Store", "Store the map"]),
        ("zoom tog", ["Toggle the zoom"]),
        ("GO STO", ["Go to vertex Store"]),
        ("ctr", []),
    ],
)
def test_the_best_come_first_and_scattered_letters_are_none(typed: str, found: list[str]) -> None:
    ranks = {line: rank(typed, line, name) for line, name in LINES.items()}
    best = sorted((place, line) for line, place in ranks.items() if place is not None)
    assert len(best) == len(found)
    assert all(line.startswith(begin) for (_, line), begin in zip(best, found, strict=True))

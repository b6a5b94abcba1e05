"""The log of the robots: when, how serious, who and what, filtered."""

import pytest

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.ros_logs import LogLine, Severity
from fleet_tui.view.tables.links import Links
from fleet_tui.view.tables.robot_log import lines_of, robot_log_table
from tests.support.diagnostics import counter, seen, text
from tests.support.fleets import T0

LOG = [
    (T0 + 1, 1, "/robot_0/planner", "tick"),
    (T0 + 2, 20, "robot_1.base", "driving"),
    (T0 + 3, 4, "/robot_0/laser", "something is Close"),
    (T0 + 4, 50, "robot_1.base", "on fire"),
    (T0 + 5, 7, "/odd", "what level is that"),
]


def logged() -> tuple[FleetState, Links]:
    link = counter()
    for line in LOG:
        link.take_log(LogLine(*line))
    return seen(link)


def log(least: Severity = Severity.DEBUG, wanted: str = "") -> list[str]:
    state, links = logged()
    return text(robot_log_table(lines_of(links), links, state, lambda wall: f"<{wall:.0f}>", least, wanted))


def test_the_log_tells_when_how_serious_who_and_what() -> None:
    title, *lines = log()
    assert title == "Robot log /rosout  5 of 5 lines, DEBUG and worse, last 15 s ago"
    words = ["· DEBUG", "  INFO", "▲ WARN", "✗ FATAL", "level 7"]
    assert [word in line for word, line in zip(words, lines, strict=True)] == [True] * 5
    assert "/robot_0/laser" in lines[2] and "something is Close" in lines[2]
    assert lines[0].startswith("<17") and lines == sorted(lines)


@pytest.mark.parametrize(
    ("least", "wanted", "count"),
    [
        (Severity.INFO, "", 4),
        (Severity.WARN, "", 3),
        (Severity.FATAL, "", 2),  # a level that nobody knows is never hidden
        (Severity.DEBUG, "close", 1),
        (Severity.DEBUG, "ROBOT_1", 2),
        (Severity.ERROR, "laser", 0),
    ],
)
def test_level_and_text_filter_the_log(least: Severity, wanted: str, count: int) -> None:
    title, *lines = log(least, wanted)
    assert len(lines) == count and f"{count} of 5 lines" in title


def test_an_empty_log_says_why_it_is_empty() -> None:
    state, links = seen(counter())
    assert "nothing received on /rosout" in robot_log_table((), links, state, str, Severity.INFO, "").empty

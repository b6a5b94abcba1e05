"""The log of the robots: when, how serious, who and what, filtered."""

import pytest

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.ros_logs import LogLine, Severity
from fleet_tui.text.sanitize import cell_width
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.diagnostics.links import Links
from fleet_tui.ui.view.tables.diagnostics.robot_log import lines_of, robot_log_table
from fleet_tui.ui.view.tables.listing import Listing
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
    arrangement = RowArrangement()
    arrangement.typed = wanted
    shown = lines_of(links), links, state, lambda wall: f"<{wall:.0f}>", least
    return text(robot_log_table(*shown, arrangement=arrangement))


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
    assert len(lines) == count and (f"/{wanted}: {count}" if wanted else f"{count} of 5 lines") in title


def test_an_empty_log_says_why_it_is_empty() -> None:
    state, links = seen(counter())
    assert "nothing received on /rosout" in robot_log_table((), links, state, str, Severity.INFO).empty


def whole(text_of_line: str, width: int) -> list[str]:
    """The rows of one line that is shown whole."""
    link = counter()
    link.take_log(LogLine(T0 + 1, 8, "/robot_0/planner", text_of_line))
    state, links = seen(link)
    lines = lines_of(links)
    opened = {id(line) for line in lines}
    table = robot_log_table(lines, links, state, lambda _: "12:00", Severity.DEBUG, opened, width)
    assert len(set(table.keys)) == len(table.rows)
    return [row.rstrip("\n") for row in text(table)[2:]]


def test_an_opened_line_is_followed_by_its_whole_message_within_the_width() -> None:
    message = "no plan to the goal: " + " ".join(f"cell{n}" for n in range(60))
    rows = whole(message, 76)
    assert len(rows) > 3 and all(len(row) <= 76 for row in rows)
    assert " ".join(row.strip() for row in rows) == message
    assert [row.strip() for row in whole("first\nsecond\x1b[31m", 76)] == ["first", "second␛[31m"]
    assert all(cell_width(row) <= 40 for row in whole("机器人" * 60, 40))


def test_each_part_of_an_opened_message_copies_the_whole_of_it() -> None:
    link = counter()
    link.take_log(LogLine(T0 + 1, 8, "/robot_0/planner", "no plan " * 30 + "\nat all"))
    state, links = seen(link)
    lines, listing = lines_of(links), Listing()
    opened = {id(line) for line in lines}
    listing.show(robot_log_table(lines, links, state, str, Severity.DEBUG, opened, 40))
    listing.move(2)
    assert listing.text == "no plan " * 30 + "\nat all"
    listing.toggle_mark()
    listing.move(1)
    listing.toggle_mark()
    assert listing.text.count("at all") == 1, "marked twice, copied once"


def test_lines_that_are_not_opened_have_one_row_each() -> None:
    state, links = logged()
    lines = lines_of(links)
    table = robot_log_table(lines, links, state, str, Severity.DEBUG, {id(lines[1])}, 76)
    assert len(table.rows) == len(LOG) + 1 and table.rows[2].key == (id(lines[1]), 0)


def test_what_the_bridge_says_of_its_clients_is_one_line_unless_it_is_sought() -> None:
    link = counter()
    link.take_log(LogLine(T0 + 1, 20, "robot_0.base", "driving"))
    for n in range(3):
        link.take_log(LogLine(T0 + 2 + n, 20, "rosbridge_websocket", f"[Client 7] Subscribed to /topic_{n}"))
    link.take_log(LogLine(T0 + 6, 40, "rosbridge_websocket", "[Client 7] call_service: /x does not exist"))
    state, links = seen(link)

    def rows(wanted: str) -> list[str]:
        arrangement = RowArrangement()
        arrangement.typed = wanted
        shown = lines_of(links), links, state, lambda wall: f"<{wall:.0f}>", Severity.DEBUG
        return text(robot_log_table(*shown, arrangement=arrangement))[1:]

    first, folded, error = rows("")
    assert "driving" in first and "does not exist" in error
    assert "/topic_2 (and 2 more lines of the bridge about its clients)" in folded
    assert len(rows("Subscribed")) == 3

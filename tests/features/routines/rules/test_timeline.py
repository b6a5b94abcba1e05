"""A dry run: estimated times, and what is not known."""

from fleet_tui.commands.routes.order_draft import SPEED
from fleet_tui.features.routines.blocks import DayTime
from fleet_tui.features.routines.rules.timeline import MOST_ENTRIES, TimelineEntry, timeline
from tests.support.fleets import R0
from tests.support.routines import plan_of, two_robots


def drawn(*lines: str) -> list[TimelineEntry]:
    def next_time(at: DayTime, wall: float) -> float:
        return wall + (at.minute * 60.0 - wall) % 86400.0

    return timeline(two_robots().robots[R0], plan_of(*lines), 3600.0, next_time)


def times(*lines: str) -> list[tuple[int, float, float | None]]:
    return [(entry.line, entry.at, entry.seconds) for entry in drawn(*lines)]


def test_ways_and_waits_add_up() -> None:
    assert times("go 'Packing area'", "carry Base Consumidores", "wait 30 s", "wait until 01:01") == [
        (2, 0.0, 1.0 / SPEED),  # from the end of the edge that it is on
        (3, 2.0, 3.0 / SPEED),
        (4, 8.0, 30.0),
        (5, 38.0, 22.0),
    ]


def test_after_an_unknown_duration_times_are_lower_limits() -> None:
    found = drawn("run x", "wait 30 s")
    assert [(entry.seconds, entry.is_least) for entry in found] == [(None, False), (30.0, True)]
    assert found[0].note == "at most 10 min"


def test_rounds_are_repeated_and_an_endless_one_ends_it() -> None:
    assert [line for line, *_ in times("repeat 3", "wait 1 s", "end", "wait 2 s")] == [3, 3, 3, 5]
    found = drawn("repeat", "wait 1 s", "end", "wait 2 s")
    assert [entry.line for entry in found] == [3, 2] and found[-1].note.startswith("again and again")


def test_of_both_parts_of_an_if_the_longer_one_counts() -> None:
    found = drawn("if idle", "wait 5 s", "else", "wait 9 s", "end", "wait 1 s")
    assert [(entry.at, entry.note, entry.is_least) for entry in found] == [
        (0.0, "if idle", False),
        (0.0, "unless idle", False),
        (9.0, "", True),
    ]


def test_it_is_limited() -> None:
    assert len(drawn("repeat 10000", "wait 1 s", "end")) == MOST_ENTRIES + 1
    assert drawn("repeat 10000", "repeat 10000", "end", "end") == []


def test_a_place_that_is_unknown_is_told() -> None:
    assert drawn("go Nowhere")[0].note == "place unknown"

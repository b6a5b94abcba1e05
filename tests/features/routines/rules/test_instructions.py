"""Instructions of one line: their values, and what is wrong with others."""

import pytest

from fleet_tui.features.routines.blocks import (
    BatteryCondition,
    CarryBlock,
    DayTime,
    IdleCondition,
    Leaf,
    PlaceCondition,
    RunBlock,
    TimeSpan,
    WaitBlock,
)
from fleet_tui.features.routines.rules.parsing import RUN_WITHIN, condition, instruction, schedule
from fleet_tui.text.errors import CommandError


def read(line: str) -> Leaf:
    (block,) = instruction(7, line.split())
    assert block.line == 7 and block.text == line
    return block


@pytest.mark.parametrize(
    ("line", "until"),
    [
        ("wait 30 s", TimeSpan(30.0)),
        ("wait 30s", TimeSpan(30.0)),
        ("wait 1.5 min", TimeSpan(90.0)),
        ("wait 2 h", TimeSpan(7200.0)),
        ("wait until 06:45", DayTime(405)),
        ("wait until 6:45", DayTime(405)),
        ("wait until idle", IdleCondition()),
        ("wait until at Base", PlaceCondition("Base")),
        ("wait until battery > 80", BatteryCondition(True, 80.0)),
        ("wait until battery<80.5%", BatteryCondition(False, 80.5)),
    ],
)
def test_waits(line: str, until: object) -> None:
    block = read(line)
    assert isinstance(block, WaitBlock) and block.until == until


@pytest.mark.parametrize(
    ("line", "arguments", "within"),
    [
        ("run check.py --fast", ("check.py", "--fast"), RUN_WITHIN),
        ("run within 5 min check.py", ("check.py",), 300.0),
        ("run within 5s check.py 1 s", ("check.py", "1", "s"), 5.0),
    ],
)
def test_programs(line: str, arguments: tuple[str, ...], within: float) -> None:
    block = read(line)
    assert isinstance(block, RunBlock) and (block.arguments, block.within) == (arguments, within)


def test_a_carry_of_many_places_is_an_order_for_each_leg() -> None:
    legs = instruction(1, ["carry", "A", "B", "C"])
    assert [(leg.start, leg.end) for leg in legs if isinstance(leg, CarryBlock)] == [("A", "B"), ("B", "C")]


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("go", "usage: go PLACE"),
        ("go A B", "usage: go PLACE"),
        ("carry A", "usage: carry FROM TO"),
        ("wait", "usage: wait 30 s"),
        ("wait 5", "'5' is not a duration: write it as 30 s"),
        ("wait 200 h", "over 7 days: use a schedule"),
        ("wait until 24:00", "'24:00' is not a time"),
        ("wait until battery > 200", "above 100 per cent"),
        ("run", "usage: run PROGRAM"),
        ("run within 5 min", "usage: run PROGRAM"),
    ],
)
def test_mistakes(line: str, words: str) -> None:
    with pytest.raises(CommandError, match=words.replace("(", r"\(")):
        instruction(1, line.split())


def test_a_condition_that_is_none_is_told_with_the_right_ones() -> None:
    with pytest.raises(CommandError, match="unknown condition 'battery 30': use battery < 30"):
        condition(["battery", "30"])


@pytest.mark.parametrize("text", ["day 06:30", "weekday 23:59", "sunday 00:00"])
def test_a_schedule_is_told_as_it_is_typed(text: str) -> None:
    assert schedule(text.split()).text == text


@pytest.mark.parametrize(
    ("text", "words"),
    [("mondy 06:30", "did you mean monday"), ("06:30", "usage: every"), ("day 6", "'6' is not a time")],
)
def test_schedules_that_are_none(text: str, words: str) -> None:
    with pytest.raises(CommandError, match=words):
        schedule(text.split())

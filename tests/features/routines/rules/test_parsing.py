"""The text of a routine: its blocks, and every mistake with its line and remedy."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.routines.blocks import CarryBlock, GoBlock, IfBlock, RepeatBlock
from fleet_tui.features.routines.rules.parsing import MOST_LINES, parse_routine
from tests.support.routines import MORNING, bodies

WORDS = ("for", "robot_0", "go", "carry", "wait", "30", "s", "until", "repeat", "if", "else", "end", "on")
MORE = ("failure", "every", "day", "06:30", "battery", "<", "'", "#", "run", "within", "\x1b[2J", "\n", "\n")


def test_a_whole_file() -> None:
    found = parse_routine(MORNING)
    one, other = found.routine.lanes
    assert found.problems == () and [lane.robot for lane in (one, other)] == ["robot_0", "robot_1"]
    assert one.body == other.body and [schedule.text for schedule in found.routine.schedules] == [
        "weekday 06:30"
    ]
    go, repeat = one.body
    assert isinstance(go, GoBlock) and isinstance(repeat, RepeatBlock) and repeat.times == 2
    carry, choice = repeat.body
    assert isinstance(carry, CarryBlock) and isinstance(choice, IfBlock) and len(choice.otherwise) == 1
    assert [block.line for block in one.on_failure] == [13]


def test_one_failure_part_for_all_lanes_that_have_none() -> None:
    text = "for a\ngo A\non failure\ngo B\nend\nend\nfor b\ngo A\nend\non failure\ngo C\nend\n"
    lanes = parse_routine(text).routine.lanes
    assert [block.text for lane in lanes for block in lane.on_failure] == ["go B", "go C"]


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("", 1, "no lane: begin one with for ROBOT"),
        ("go A", 1, "go outside a lane: put it between for ROBOT and end"),
        ("for r\ngoo A\nend", 2, "unknown instruction 'goo', did you mean go?"),
        ("for\ngo A\nend", 1, "usage: for ROBOT"),
        ("for r\ngo A", 1, "for is not closed: add end"),
        ("for r\nrepeat 2\ngo A\nend\n", 1, "for is not closed"),
        ("for r\nrepeat 0\nend\nend", 2, "N from 1 to 10000"),
        ("for r\nrepeat ²\nend\nend", 2, "N from 1 to 10000"),
        ("for r\nif low\nend\nend", 2, "unknown condition 'low': use battery < 30"),
        ("for r\nelse\nend", 2, "else without if"),
        ("for r\nrepeat 2\non failure\nend\nend\nend", 3, "on failure: put it alone"),
        ("for r\non failure\nend\ngo A\nend", 4, "put it before on failure"),
        ("for r\nfor s\nend\nend", 2, "for inside a block: close that block"),
        ("for r\nend\nend", 3, "end without a block: remove it"),
        ("for r\ngo 'A\nend", 2, "a quotation mark is not closed"),
        ("for r\nend\nevery day 06:30", 3, "every: put it at the start"),
        ("for r\n" + "repeat 2\n" * 25, 1, "over 20 blocks within each other"),
        ("#\n" * (MOST_LINES + 1), MOST_LINES + 1, "over 2000 lines"),
        ("for " + "r " * 101 + "\nend", 1, "over 100 robots"),
    ],
)
def test_mistakes(text: str, line: int, words: str) -> None:
    found = parse_routine(text).problems
    assert any(one.line == line and words in one.text for one in found), found


@pytest.mark.parametrize("separator", ["\u2028", "\x0b", "\x85", "\x1c"])
def test_a_comment_ends_where_an_editor_ends_it(separator: str) -> None:
    parsed = parse_routine(f"for robot_0\r\n  go Base # then{separator}go Elsewhere\r\nend\r\n")
    (lane,) = parsed.routine.lanes
    assert [block.text for block in lane.body] == ["go Base"] and not parsed.problems


def test_all_mistakes_at_once() -> None:
    text = "every day 6\nfor r\ngo\nif x\nwait 5\nelse\nwait until noon\nend\nend\n"
    assert [problem.line for problem in parse_routine(text).problems] == [1, 3, 4, 5, 7]


@given(st.one_of(st.text(max_size=300), st.lists(st.sampled_from(WORDS + MORE)).map(" ".join)))
def test_no_text_crashes_it(text: str) -> None:
    found = parse_routine(text)
    assert found.problems or found.routine.lanes
    assert [one.line for one in found.problems] == sorted(one.line for one in found.problems)


@given(bodies)
def test_a_file_without_a_mistake_has_no_problem(lines: list[str]) -> None:
    text = "\n".join(["for r", *lines, "end"])
    found = parse_routine(text)
    assert found.problems == () and len(found.routine.lanes) == 1
    assert parse_routine("  # note\n\n" + text.replace("\n", "\n \t")).problems == ()

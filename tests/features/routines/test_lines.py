"""Routines as lines."""

import pytest

from fleet_tui.features.routines.blocks import RoutineProblem
from fleet_tui.features.routines.lane import Gate, Lane, LaneNote, LanePhase, Part, Position
from fleet_tui.features.routines.lines import (
    lane_text,
    lane_word,
    note_text,
    problem_line,
    summary_word,
    timeline_lines,
)
from fleet_tui.features.routines.rules.timeline import TimelineEntry
from fleet_tui.text.language import Message
from tests.support.routines import plan_of

PLAN = plan_of("go Base", "wait 30 s", "on failure", "go Store", "end")


def test_nothing_from_a_file_reaches_the_terminal_as_it_is() -> None:
    lines = [
        problem_line("morning", RoutineProblem(3, Message("unknown [2J"))),
        note_text(LaneNote(Message("begun"), 1, "go \x1b[2J", Message(""))),
        *timeline_lines([TimelineEntry("r\x1b", 1, "go \x1b", 0.0, None, False)]),
    ]
    assert not any("\x1b" in line or "\x07" in line for line in lines)


def test_a_timeline_has_each_robot_with_its_times() -> None:
    entries = [
        TimelineEntry("robot_0", 2, "go A", 0.0, 64.0, False, Message("32 m")),
        TimelineEntry("robot_0", 3, "run x", 64.0, None, True, Message("duration unknown")),
        TimelineEntry("robot_1", 2, "go A", 0.0, 4.0, False),
    ]
    assert list(timeline_lines(entries)) == [
        "robot_0:",
        "    0:00  line 2    go A (about 64 s, 32 m)",
        "  >=1:04  line 3    run x (duration unknown)",
        "robot_1:",
        "    0:00  line 2    go A (about 4 s)",
    ]


@pytest.mark.parametrize(
    ("lane", "word", "text"),
    [
        (Lane("r"), "running", "line 2: go Base"),
        (Lane("r", (Position(index=1),), LanePhase.WAITING), "waiting", "line 3: wait 30 s"),
        (Lane("r", gate=Gate.PAUSED), "paused", "line 2: go Base"),
        (
            Lane("r", phase=LanePhase.ORDERED, gate=Gate.HELD, detail=Message("no link")),
            "held",
            "line 2: go Base; its order continues; no link",
        ),
        (Lane("r", (Position(Part.FAILURE),), detail=Message("lost")), "running", "line 5: go Store; lost"),
        (Lane("r", phase=LanePhase.DONE, detail=Message("old")), "done", ""),
        (Lane("r", phase=LanePhase.FAILED, detail=Message("lost")), "failed", "lost"),
    ],
)
def test_states(lane: Lane, word: str, text: str) -> None:
    assert lane_word(lane) == word and lane_text(PLAN, lane) == text


def test_the_state_of_all_is_that_which_needs_a_person() -> None:
    done, held, failed = (
        Lane("a", phase=LanePhase.DONE),
        Lane("b", gate=Gate.HELD),
        Lane("c", phase=LanePhase.FAILED),
    )
    assert summary_word([done, failed, held]) == "held" and summary_word([done, failed]) == "failed"
    assert summary_word([done, Lane("d")]) == "running" and summary_word([]) == "done"

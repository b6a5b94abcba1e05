"""The time line: how far, how fast, what happened; it never lies about where the recording stands."""

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.replay import MarkKind, ReplayPosition, TimeMark
from fleet_tui.text.language import Message
from fleet_tui.text.units import span
from fleet_tui.ui.view.lines.time import bar, position_runs, time_at, time_line
from fleet_tui.ui.view.roles import StyleRole
from tests.support.fleets import text_of

ALARM = TimeMark(150.0, MarkKind.ALARM, Message("robot_0 offline"))
COMMAND = TimeMark(150.0, MarkKind.COMMAND, Message("robot_0 pause"))
GAP = TimeMark(180.0, MarkKind.GAP, Message("0:30 missing before this"))


def moment(at: float = 150.0, **more: Any) -> ReplayPosition:
    return ReplayPosition(began=100.0, ended=200.0, at=at, wall=1.7e9, **more)


def clock(_wall: float) -> str:
    return "12:04:31"


@pytest.mark.parametrize(
    ("seconds", "text"), [(0, "0:00"), (59.9, "0:59"), (61, "1:01"), (3600, "1:00:00"), (-1, "0:00")]
)
def test_spans(seconds: float, text: str) -> None:
    assert span(seconds) == text


@given(st.floats(90, 210), st.integers(1, 200), st.lists(st.floats(90, 210), max_size=5))
def test_both_lines_fill_their_width_wherever_it_stands(at: float, width: int, marks: list[float]) -> None:
    marked = [TimeMark(one, MarkKind.ALARM, Message("x" * 50)) for one in sorted(marks)]
    lines = time_line(moment(at, marks=marked, note="truncated"), clock, width)
    assert [len(text_of(line)) for line in lines] == [width, width]


def test_the_cursor_stands_where_it_is() -> None:
    texts = [text_of(bar(moment(at), 52)) for at in (100.0, 150.0, 200.0)]
    assert [text.index("●") for text in texts] == [6, 26, 45]
    assert [text[:6] for text in texts] == [" 0:00 ", " 0:50 ", " 1:40 "]
    assert texts[1] == f" 0:50 {'━' * 20}●{'─' * 19} 1:40 "


def test_of_marks_in_one_cell_the_alarm_is_seen() -> None:
    runs = bar(moment(100.0, marks=[ALARM, COMMAND, GAP]), 52)
    assert ("▲", StyleRole.ALARM) in runs and ("╳", StyleRole.WARN) in runs
    assert "◆" not in text_of(runs)


def test_a_cell_is_the_time_under_it() -> None:
    assert [time_at(moment(), x, 52) for x in (0, 6, 26, 51)] == [100.0, 100.0, 150.0, 200.0]
    assert text_of(bar(moment(time_at(moment(), 30, 52)), 52)).index("●") == 30


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ({}, "▸ 12:04:31 playing x1"),
        ({"speed": 0.25}, "playing x0.25"),
        ({"speed": 64.0, "reached": 12.34}, "playing x64 (x12.3 reached)"),
        ({"paused": True}, "‖ 12:04:31 stopped x1"),
        ({"busy": 0.4}, "seeking: 40 %"),
        ({"is_over": True, "paused": True}, "end of recording"),
        ({"note": "it was cut off"}, "it was cut off"),
    ],
)
def test_how_it_is_played(more: dict[str, Any], says: str) -> None:
    text = text_of(position_runs(moment(**more), clock, 80))
    assert says in text and "read-only" in text


def test_a_mark_is_told_while_it_is_news() -> None:
    def says(at: float, **more: Any) -> str:
        return text_of(position_runs(moment(at, marks=[ALARM, GAP], **more), clock, 120))

    assert "▲ robot_0 offline" in says(150.0) and "▲ robot_0 offline" in says(154.9)
    assert "robot_0" not in says(149.9) and "robot_0" not in says(155.1)
    assert "robot_0 offline" in says(165.0, speed=4.0)
    assert "robot_0" not in says(165.0, speed=4.0, paused=True)
    assert "╳ 0:30 missing" in says(182.0)


def test_words_from_outside_are_shown_as_text() -> None:
    mark = TimeMark(150.0, MarkKind.ALARM, Message("[2Jgone"))
    assert "␛[2Jgone" in text_of(position_runs(moment(marks=[mark]), clock, 80))

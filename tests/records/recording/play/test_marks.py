"""Marks of the time line: alarms as they rise, commands as they begin and fail, gaps in the records."""

from pathlib import Path

import pytest

from fleet_tui.model.replay import MarkKind
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.recording.play.playback import GAP, time_marks
from fleet_tui.records.recording.recording import Instant, Recording
from fleet_tui.records.recording.records import Lost, Mark
from tests.support.fleets import R0, WALL
from tests.support.recordings import header

ORIGIN = Origin("ana", "here:1", "r")


def marked(*marks: Mark) -> list[tuple[MarkKind, str]]:
    recording = recorded()
    recording.marks.extend(marks)
    return [(mark.kind, mark.text) for mark in time_marks(recording)]


def recorded() -> Recording:
    return Recording(Path("x"), header())


def mark(at: float, kind: str, change: str, **more: object) -> Mark:
    return Mark(at, WALL + at, ORIGIN.record(WALL + at, kind=kind, change=change, robot=R0, **more))


@pytest.mark.parametrize(
    ("change", "text"),
    [
        ("raised", "robot_0 offline"),
        ("raised again", "robot_0 offline (raised again)"),
        ("worse", "robot_0 offline (worse)"),
        ("acknowledged", None),
        ("returned, cleared", None),
    ],
)
def test_an_alarm_is_marked_as_it_rises(change: str, text: str | None) -> None:
    found = marked(mark(1.0, "alarm", change, what="offline", words="offline"))
    assert found == ([] if text is None else [(MarkKind.ALARM, text)])


@pytest.mark.parametrize(
    ("change", "text"),
    [
        ("checked", "robot_0 order Base -> 2"),
        ("refused", "robot_0 order Base -> 2: refused (busy)"),
        ("sent", None),
        ("confirmed", None),
    ],
)
def test_a_command_is_marked_as_it_begins_and_fails(change: str, text: str | None) -> None:
    route = {"start": "1", "start_label": "Base", "end": "2"}
    found = marked(mark(1.0, "command", change, what="order", words="busy", **route))
    assert found == ([] if text is None else [(MarkKind.COMMAND, text)])


def test_gaps_are_records_that_were_lost_and_times_at_which_the_computer_slept() -> None:
    recording = recorded()
    recording.lost.append(Lost(2.5, WALL, 12, "the disk was full"))
    walls = [0.0, 1.0, 2.0 + GAP / 2, 603.0, 304.0]
    recording.keyframes.extend(Instant(float(n), WALL + wall) for n, wall in enumerate(walls))
    found = time_marks(recording)
    assert [(one.at, one.kind) for one in found] == [(at, MarkKind.GAP) for at in (2.5, 3.0, 4.0)]
    assert found[0].text == "12 records missing here: the disk was full"
    assert "missing before this: recording computer suspended" in found[1].text
    assert found[2].text.startswith("clock set back by ")

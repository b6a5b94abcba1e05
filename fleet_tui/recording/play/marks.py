"""Marks of a recording's time line."""

from collections.abc import Iterator

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import FAILURES, Stage
from fleet_tui.recording.recording import Instant, Recording
from fleet_tui.recording.records import Mark
from fleet_tui.text.details import detail_text
from fleet_tui.view.lines.time import MarkKind, TimeMark, span

GAP = 2.0
"""Seconds by which the wall clock runs ahead of the recorded one if the recording machine was suspended."""

_WORDS = {Stage.CHECKED.value} | {stage.value for stage in (*FAILURES, Stage.NO_ANSWER, Stage.UNKNOWN)}
"""Marked stages of a command: its start, and ends that an operator must know."""
_RISES = ("raised", "raised again", "worse")


def time_marks(recording: Recording) -> list[TimeMark]:
    """Return every mark, the earliest first."""
    found = [*_happened(recording.marks), *_gaps(recording)]
    return sorted(found, key=lambda mark: mark.at)


def _happened(marks: list[Mark]) -> Iterator[TimeMark]:
    for mark in marks:
        record = mark.record
        if record.kind == "alarm" and record.change.startswith(_RISES):
            again = "" if record.change == "raised" else f" ({record.change})"
            yield TimeMark(mark.at, MarkKind.ALARM, f"{record.robot or record.link} {record.words}{again}")
        elif record.kind == "command" and record.change in _WORDS:
            yield TimeMark(mark.at, MarkKind.COMMAND, _command(record))


def _command(record: AuditRecord) -> str:
    places = [
        label or str(vertex)
        for vertex, label in ((record.start, record.start_label), (record.end, record.end_label))
        if vertex is not None
    ]
    text = " ".join(part for part in (record.robot, record.what, " -> ".join(places)) if part)
    if record.change == Stage.CHECKED.value:
        return text
    return f"{text}: {record.change}{detail_text(record.words)}"


def _gaps(recording: Recording) -> Iterator[TimeMark]:
    for lost in recording.lost:
        yield TimeMark(lost.at, MarkKind.GAP, f"{lost.records} records missing here: {lost.why}")
    before: Instant | None = None
    for moment in recording.keyframes:
        if before is not None:
            missing = (moment.wall - before.wall) - (moment.at - before.at)
            if abs(missing) > GAP:
                yield TimeMark(moment.at, MarkKind.GAP, _gap(missing))
        before = moment


def _gap(missing: float) -> str:
    if missing < 0:
        return f"clock set back by {span(-missing)}"
    return f"{span(missing)} missing before this: recording computer suspended, or its clock changed"

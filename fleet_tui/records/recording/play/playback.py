"""The engine of a player: the recorded clock relative to ours. Without threads."""

import time
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import FAILURES, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.replay import MarkKind, ReplayPosition, TimeMark
from fleet_tui.records.recording.play.cursor import RecordingCursor
from fleet_tui.records.recording.recording import LAST_SECOND, Instant, Recording
from fleet_tui.records.recording.records import Mark
from fleet_tui.text.details import detail_text
from fleet_tui.text.language import EMPTY, Message, joined
from fleet_tui.text.units import span

SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)
"""Recorded seconds per second of ours."""
LATE = 0.25
"""Seconds of work after which our clock is no longer followed: the recording plays slower."""
NOTHING_FOR = 5.0
"""Recorded seconds without a record that are skipped."""
LONG = 0.5
"""Seconds after which a jump reports its progress."""


GAP = 2.0
"""Seconds by which the wall clock runs ahead of the recorded one if the recording machine was suspended."""

_WORDS = {Stage.CHECKED.value} | {stage.value for stage in (*FAILURES, Stage.NO_ANSWER, Stage.UNKNOWN)}
"""Marked stages of a command: its start, and ends that an operator must know."""
_RISES = ("raised", "raised again", "worse")


class Playback:
    """Moves a cursor. Long operations call `goes_on` regularly for permission to continue."""

    def __init__(self, recording: Recording, speed: float) -> None:
        self.head = RecordingCursor(recording)
        self.marks = time_marks(recording)
        self.paused = False
        self._recording = recording
        self._speed = speed
        self._reached: float | None = None
        self._busy: float | None = None
        self._jumps = 0
        self._failure = EMPTY
        self._shown = self.head.state, self._moment()
        self.go_on()

    @property
    def shown(self) -> tuple[FleetState, ReplayPosition]:
        """Return the visible state, and its place in the recording. Callable from any thread."""
        return self._shown

    def show(self) -> None:
        """Show the current position; during a jump only that."""
        state = self.head.state if self._busy is None else self._shown[0]
        self._shown = state, self._moment()

    def _moment(self) -> ReplayPosition:
        recording = self._recording
        return ReplayPosition(
            began=recording.begin.at,
            ended=recording.end.at,
            at=self.head.at,
            wall=max(0.0, min(self.head.state.wall, LAST_SECOND)) or recording.begin.wall,
            speed=self._speed,
            reached=None if self.paused else self._reached,
            paused=self.paused,
            is_over=self.head.next_at is None,
            busy=self._busy,
            marks=self.marks,
            note=self._failure or recording.note,
            jumps=self._jumps,
        )

    def go_on(self) -> None:
        """Start the recorded clock from here and now."""
        self._since = time.monotonic()
        self._begun_at = self.head.at

    def play(self, goes_on: Callable[[], bool]) -> None:
        """Play up to our clock. It stops at the end."""
        following, now = self.head.next_at, time.monotonic()
        if self.paused or following is None:
            self.paused = True
            return
        if following - self.head.at > NOTHING_FOR:
            self._since = now
            self._begun_at = following
            self._mark_gap(following)
        wanted = self._begun_at + (now - self._since) * self._speed
        before = self.head.at
        if self.head.advance(wanted, lambda: goes_on() and time.monotonic() - now < LATE):
            self._reached = None
        else:
            self._reached = (self.head.at - before) / (time.monotonic() - now)
            self.go_on()

    def toggle(self) -> None:
        """Play, or stop."""
        self.paused = not self.paused
        self.go_on()

    def _mark_gap(self, until: float) -> None:
        text = Message("no records for the {span} before this", span=span(until - self.head.at))
        if all(mark.at != until for mark in self.marks if mark.kind is MarkKind.GAP):
            self.marks = sorted([*self.marks, TimeMark(until, MarkKind.GAP, text)], key=lambda mark: mark.at)

    def change_speed(self, step: int) -> None:
        """Set the next faster (1) or slower (-1) speed; 0 is the original one."""
        speed = self._speed
        index = bisect_right(SPEEDS, speed) if step > 0 else bisect_left(SPEEDS, speed) - 1
        self._speed = SPEEDS[max(0, min(index, len(SPEEDS) - 1))] if step else 1.0
        self._reached = None
        self.go_on()

    def step(self, step: Callable[[int], None], by: int) -> None:
        """Move forward or back by one of the cursor's steps, and stop there."""
        self.paused = True
        step(by)
        self._jumps += by < 0

    def seek(self, at: float, goes_on: Callable[[], bool]) -> None:
        """Go to a second of the recording."""
        began = time.monotonic()
        first: float | None = None

        def looks() -> bool:
            nonlocal first
            first = self.head.at if first is None else first
            if time.monotonic() - began > LONG:
                self._busy = (self.head.at - first) / max(at - first, 1e-9)
                self.show()
            return goes_on()

        try:
            self.head.seek(at, looks)
        finally:
            self._busy = None
        self._failure = EMPTY
        self._jumps += 1
        self.go_on()

    def fail(self, note: Message) -> None:
        """Stop, and report the reason."""
        self.paused = True
        self._failure = note


def time_marks(recording: Recording) -> list[TimeMark]:
    """Return every mark, the earliest first."""
    found = [*_happened(recording.marks), *_gaps(recording)]
    return sorted(found, key=lambda mark: mark.at)


def _happened(marks: list[Mark]) -> Iterator[TimeMark]:
    for mark in marks:
        record = mark.record
        if record.kind == "alarm" and record.change.startswith(_RISES):
            again = "" if record.change == "raised" else f" ({record.change})"
            yield TimeMark(
                mark.at,
                MarkKind.ALARM,
                Message(
                    "{robot} {text}{times}", robot=record.robot or record.link, text=record.words, times=again
                ),
            )
        elif record.kind == "command" and record.change in _WORDS:
            yield TimeMark(mark.at, MarkKind.COMMAND, _command(record))


def _command(record: AuditRecord) -> Message:
    places = [
        label or str(vertex)
        for vertex, label in ((record.start, record.start_label), (record.end, record.end_label))
        if vertex is not None
    ]
    text = joined(" ", (part for part in (record.robot, record.what, " -> ".join(places)) if part))
    if record.change == Stage.CHECKED.value:
        return text
    return Message(
        "{text}: {change}{detail}", text=text, change=record.change, detail=detail_text(record.words)
    )


def _gaps(recording: Recording) -> Iterator[TimeMark]:
    for lost in recording.lost:
        yield TimeMark(
            lost.at,
            MarkKind.GAP,
            Message("{records} records missing here: {why}", records=lost.records, why=Message(lost.why)),
        )
    before: Instant | None = None
    for moment in recording.keyframes:
        if before is not None:
            missing = (moment.wall - before.wall) - (moment.at - before.at)
            if abs(missing) > GAP:
                yield TimeMark(moment.at, MarkKind.GAP, _gap(missing))
        before = moment


def _gap(missing: float) -> Message:
    if missing < 0:
        return Message("clock set back by {span}", span=span(-missing))
    return Message(
        "{span} missing before this: recording computer suspended, or its clock changed", span=span(missing)
    )

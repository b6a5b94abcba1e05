"""The engine of a player: the recorded clock relative to ours. Without threads."""

import time
from bisect import bisect_left, bisect_right
from collections.abc import Callable

from fleet_tui.model.fleet import FleetState
from fleet_tui.recording.play.cursor import RecordingCursor
from fleet_tui.recording.play.marks import time_marks
from fleet_tui.recording.recording import LAST_SECOND, Recording
from fleet_tui.view.lines.time import MarkKind, ReplayPosition, TimeMark, span

SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)
"""Recorded seconds per second of ours."""
LATE = 0.25
"""Seconds of work after which our clock is no longer followed: the recording plays slower."""
NOTHING_FOR = 5.0
"""Recorded seconds without a record that are skipped."""
LONG = 0.5
"""Seconds after which a jump reports its progress."""


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
        self._failure = ""
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
        text = f"no records for the {span(until - self.head.at)} before this"
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
        self._failure = ""
        self._jumps += 1
        self.go_on()

    def fail(self, note: str) -> None:
        """Stop, and report the reason."""
        self.paused = True
        self._failure = note

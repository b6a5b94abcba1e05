"""A recording made of past data: its clock is that of the data."""

import math

from fleet_tui.config.schema import Config
from fleet_tui.model.events import Event, MessageArrived, TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.entries import Origin, alarm_records
from fleet_tui.records.recording.part_file import PartFile
from fleet_tui.records.recording.play.frames import Frames
from fleet_tui.records.recording.records import (
    EventRecord,
    Keyframe,
    Mark,
    Packer,
    ReceivedFrame,
    Record,
    encode,
)

FIRST_AT = 1.0
"""Monotonic seconds at its beginning."""
TICKS_PER_SECOND = 10
"""Seconds between ticks, as on a live link."""
KEYFRAME_EVERY = 60.0
"""Seconds."""
LONGEST_SILENCE = 7200.0
"""Seconds without a message that have ticks; the rest of a longer silence is skipped."""


class Track:
    """Writes events, and the ticks and alarms between them. Raises OSError if it can't write."""

    def __init__(
        self, file: PartFile, config: Config, state: FleetState, origin: Origin, wall: float
    ) -> None:
        """Continue after the header, at a Unix time, with a state whose `now` is FIRST_AT."""
        self.at = FIRST_AT
        self.state = state
        self._file = file
        self._origin = origin
        self._begun_wall = wall
        self._frames = Frames(config)
        self._packer = Packer()
        self._ticks = 0
        self._received: dict[str, float] = {}
        self._keyframe()

    @property
    def wall(self) -> float:
        """Return the current Unix time."""
        return self._begun_wall + self.at - FIRST_AT

    def on_received(self, link: str, frame: bytes, is_binary: bool) -> None:
        """Record a frame received now."""
        self._received[link] = self.at
        text, data = ("", frame) if is_binary else (frame.decode(), b"")
        self._take(ReceivedFrame(self.at, self.wall, link, "topics", text, data, is_binary))

    def on_event(self, event: Event) -> None:
        """Record an event of now."""
        self._take(EventRecord(self.at, self.wall, event))

    def advance(self, seconds: float) -> bool:
        """Advance the time to a number of seconds after the beginning. False if that is past: then it
        stays."""
        until = FIRST_AT + seconds
        if until < self.at:
            return False
        jump_at = self.at + LONGEST_SILENCE
        while (at := FIRST_AT + self._ticks / TICKS_PER_SECOND) <= until:
            if at > jump_at:
                self._ticks = max(self._ticks, int(seconds * TICKS_PER_SECOND))
                jump_at = math.inf
                continue
            self.at = at
            self._tick()
        self.at = until
        return True

    def _tick(self) -> None:
        if self.at >= self._keyframe_at:
            self._file.begin_member()
            self._keyframe()
        received, self._received = self._received, {}
        for link, at in received.items():
            self.on_event(MessageArrived(link, at))
        self.on_event(TimePassed(self.at, self.wall))
        self._ticks += 1

    def _take(self, record: Record) -> None:
        """Write an event, and its effect on the alarms."""
        self._put(record)
        before, self.state = self.state, self._frames.after(self.state, record)
        if before.alarms is not self.state.alarms:
            for mark in alarm_records(self._origin, before, self.state, self.wall):
                self._put(Mark(self.at, self.wall, mark))

    def _keyframe(self) -> None:
        self._keyframe_at = self.at + KEYFRAME_EVERY
        self._put(Keyframe.of(self.at, self.wall, self.state, self._packer))
        self._packer.forget()

    def _put(self, record: Record) -> None:
        self._file.write(encode(record, self._packer))

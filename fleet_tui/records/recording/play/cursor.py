"""A position in a recording, and the state there. Without clocks and threads."""

import math
from bisect import bisect_right
from collections import deque
from collections.abc import Callable
from typing import NamedTuple

from fleet_tui.model.events import TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.recording.play.frames import Frames
from fleet_tui.records.recording.recording import Recording
from fleet_tui.records.recording.records import EventRecord, Keyframe, Record, RecordingError
from fleet_tui.text.language import Message

REMEMBERED_EVERY = 500
"""Records between two cached states, so that a step back need not start at the keyframe."""
REMEMBERED = 400
"""Maximum number of states; above it every other one is dropped."""
BEHIND = 5000
"""Number of cached records, so that steps back need no reading."""
LOOK_EVERY = 200
"""Records between two checks whether to continue."""


class _Remembered(NamedTuple):
    """The state after a number of records from the keyframe, with the times of the last record and, if any,
    of the last tick since the keyframe."""

    records: int
    at: float
    tick_at: float | None
    state: FleetState


def _always() -> bool:
    return True


class RecordingCursor:
    """Moves by records; `at` is the monotonic second of the last one. All moves raise RecordingError if the
    recording can't be read."""

    def __init__(self, recording: Recording) -> None:
        self._recording = recording
        self.frames = Frames(recording.config)
        self._behind: deque[Record] = deque(maxlen=BEHIND)
        self._again: deque[Record] = deque()
        self._enter(0)

    def _enter(self, number: int) -> None:
        """Start at a keyframe, independent of earlier records. On an error the position stays."""
        wanted = self._recording.keyframes[number].at
        records = self._recording.records(wanted)
        first = next(records, None)
        if not isinstance(first, Keyframe) or first.at != wanted:
            raise RecordingError(
                Message("{name} has changed since it was opened: reopen it", name=self._recording.path.name)
            )
        self.frames.recount()
        self._records = records
        self._next: Record | None = None
        self._behind.clear()
        self._again.clear()
        self._keyframe = number - 1
        self._begin(first)

    def _begin(self, keyframe: Keyframe) -> None:
        """Load the whole state of a keyframe: records may be missing before it."""
        self.state = self._recording.state(keyframe)
        self.at = keyframe.at
        self._keyframe = self._keyframe + 1
        self._count = 0
        self._tick_at: float | None = None
        self._kept = [self._here()]

    def _here(self) -> _Remembered:
        return _Remembered(self._count, self.at, self._tick_at, self.state)

    @property
    def next_at(self) -> float | None:
        """Return the time of the next record, None at the end."""
        if self._next is None:
            self._next = self._again.popleft() if self._again else next(self._records, None)
        return None if self._next is None else self._next.at

    def take(self) -> Record | None:
        """Apply one record, and return it. None at the end."""
        if self.next_at is None:
            return None
        record, self._next = self._next, None
        if isinstance(record, Keyframe):
            self._begin(record)
        elif record is not None:
            self.state = self.frames.after(self.state, record)
            self.at = record.at
            self._tick_at = self.at if _is_tick(record) else self._tick_at
            self._count += 1
            self._behind.append(record)
            if self._count % REMEMBERED_EVERY == 0:
                self._kept.append(self._here())
            if len(self._kept) > REMEMBERED:
                del self._kept[1::2]
        return record

    def advance(self, until: float, goes_on: Callable[[], bool] = _always) -> bool:
        """Apply every record up to a second. False if it was cancelled."""
        taken = 0
        while self.next_at is not None and self.next_at <= until:
            self.take()
            taken += 1
            if taken % LOOK_EVERY == 0 and not goes_on():
                return False
        return True

    def seek(self, at: float, goes_on: Callable[[], bool] = _always) -> bool:
        """Go to the state after the last record up to a second, anywhere in the recording."""
        moments = self._recording.keyframes
        number = max(0, bisect_right(moments, at, key=lambda moment: moment.at) - 1)
        if number != self._keyframe:
            self._enter(number)
        elif at < self.at:
            self._back(bisect_right(self._kept, at, key=lambda kept: kept.at) - 1)
        return self.advance(at, goes_on)

    def _back(self, index: int) -> None:
        """Go to a cached state of this keyframe, skipping the records before it."""
        kept = self._kept[: max(0, index) + 1]
        back = self._count - kept[-1].records
        if back <= len(self._behind):
            self._wind(back)
        else:
            self._enter(self._keyframe)
            for _ in range(kept[-1].records):
                next(self._records, None)
        self._kept = kept
        self._count, self.at, self._tick_at, self.state = kept[-1]

    def _wind(self, back: int) -> None:
        """Queue the last records to be read once more."""
        if self._next is not None:
            self._again.appendleft(self._next)
            self._next = None
        for _ in range(back):
            self._again.appendleft(self._behind.pop())
        self.frames.recount()

    def step_record(self, step: int) -> None:
        """Move one record forward or back."""
        if step > 0:
            self.take()
        elif self._count == 0:
            self._before_keyframe()
        else:
            wanted = self._count - 1
            self._back(bisect_right(self._kept, wanted, key=lambda kept: kept.records) - 1)
            while self._count < wanted:
                self.take()

    def _before_keyframe(self) -> None:
        """Go to the record before the current keyframe, if there is one."""
        if self._keyframe > 0:
            self._enter(self._keyframe - 1)
            while self.next_at is not None and not isinstance(self._next, Keyframe):
                self.take()

    def step_tick(self, step: int) -> None:
        """Go to the next or the previous tick of the recorded clock."""
        if step < 0:
            self._before_tick()
            while self._tick_at is None and self._keyframe > 0:
                self._before_tick()  # the keyframe lies between two ticks
            self.seek(self._tick_or_keyframe)
            return
        while (record := self.take()) is not None and not _is_tick(record):
            pass

    @property
    def _tick_or_keyframe(self) -> float:
        return self._kept[0].at if self._tick_at is None else self._tick_at

    def _before_tick(self) -> None:
        self.seek(math.nextafter(self._tick_or_keyframe, -math.inf))


def _is_tick(record: Record) -> bool:
    return isinstance(record, EventRecord) and isinstance(record.event, TimePassed)

"""Plays a recording: the only thread that changes the state, without any connection."""

import logging
import sys
import threading
from collections import deque
from collections.abc import Callable
from functools import partial

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.replay import ReplayPosition
from fleet_tui.records.recording.play.playback import Playback
from fleet_tui.records.recording.play.times import moment_of
from fleet_tui.records.recording.recording import Recording
from fleet_tui.state.store import Store
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import EMPTY, Message, message_of

LOG = logging.getLogger(__name__)

STEADY = 1 / 30
"""Seconds between two reads of the clock while it plays."""
ONCE_MORE = 1.0
"""Recorded seconds after a mark within which "previous" means the one before it."""
SWITCH_INTERVAL = 0.0005
"""Python's switch interval while the screen waits for this thread, in seconds."""


class Player:
    """Runs requests one by one; callable from any thread. Raises RecordingError for a recording that can't be
    played."""

    def __init__(self, recording: Recording, speed: float = 1.0) -> None:
        self._recording = recording
        self._jobs: deque[Callable[[], None]] = deque()
        self._changed = threading.Condition()
        self._closing = False
        self._target: float | None = None
        self._playback = Playback(recording, speed)
        self.frames = self._playback.head.frames
        """Reads what is played, and counts it."""

    def start(self, store: Store) -> None:
        """Start to play into a store."""
        sys.setswitchinterval(SWITCH_INTERVAL)
        self._playback.go_on()
        threading.Thread(target=self._run, args=(store,), name="fleet-tui-player", daemon=True).start()

    def enter(self, at: float) -> None:
        """Go to the first position, before it is started."""
        self._playback.seek(at, lambda: True)
        self._playback.show()

    def close(self) -> None:
        """Stop permanently."""
        with self._changed:
            self._closing = True
            self._changed.notify()

    @property
    def state(self) -> FleetState:
        return self._playback.shown[0]

    @property
    def moment(self) -> ReplayPosition:
        """Return the current position in the recording."""
        return self._playback.shown[1]

    def toggle(self) -> None:
        """Play, or stop."""
        self._ask(self._playback.toggle)

    def change_speed(self, step: int) -> None:
        """Set the next faster (1) or slower (-1) speed; 0 is the original one."""
        self._ask(partial(self._playback.change_speed, step))

    def step(self, ticks: int) -> None:
        """Move one tick of the recorded clock forward (1) or back (-1), and stop there."""
        self._ask(partial(self._playback.step, self._playback.head.step_tick, ticks))

    def step_record(self, records: int) -> None:
        """Move one record forward (1) or back (-1), and stop there."""
        self._ask(partial(self._playback.step, self._playback.head.step_record, records))

    def seek(self, at: float) -> None:
        """Go to a monotonic second of the recording, replacing any pending request."""
        self._target = at = max(self._recording.begin.at, min(at, self._recording.end.at))
        self._ask(partial(self._seek, at))

    def time_of(self, text: str) -> float:
        """Return the second of a written time. Raises FleetError."""
        return moment_of(text, self._recording)

    def skip(self, seconds: float) -> None:
        """Skip a number of seconds forward or back, from the pending position."""
        self.seek(self._going_to + seconds)

    def to_end(self, step: int) -> None:
        """Go to the beginning (-1) or the end (1)."""
        self.seek(self._recording.end.at if step > 0 else self._recording.begin.at)

    def to_mark(self, step: int) -> Message:
        """Go to the next (1) or previous (-1) mark; return a notice if no such mark exists."""
        here, marks = self._going_to, self._playback.marks
        if step > 0:
            found = [mark for mark in marks if mark.at > here][:1]
        else:
            before = here if self.moment.paused else here - ONCE_MORE
            found = [mark for mark in marks if mark.at < before][-1:]
        for mark in found:
            self.seek(mark.at)
        if found:
            return EMPTY
        if step > 0:
            return Message("no alarm, command or gap after this")
        return Message("no alarm, command or gap before this")

    @property
    def _going_to(self) -> float:
        target = self._target
        return self.moment.at if target is None else target

    def _ask(self, job: Callable[[], None]) -> None:
        with self._changed:
            self._jobs.append(job)
            self._changed.notify()

    def _play(self) -> None:
        self._playback.play(lambda: not self._jobs and not self._closing)

    def _seek(self, at: float) -> None:
        try:
            if self._target == at:
                self._playback.seek(at, lambda: self._target == at and not self._closing)
        finally:
            if self._target == at:
                self._target = None

    def _run(self, store: Store) -> None:
        while True:
            with self._changed:
                if not self._jobs and not self._closing:
                    self._changed.wait(None if self._playback.paused else STEADY)
                if self._closing:
                    return
                job = self._jobs.popleft() if self._jobs else self._play
            try:
                job()
            except FleetError as problem:
                self._playback.fail(message_of(problem))
            except Exception as problem:
                LOG.exception("replay")
                self._playback.fail(
                    Message("playback stopped: {problem} (see the log file)", problem=problem)
                )
            self._playback.show()
            store.put(self.state)

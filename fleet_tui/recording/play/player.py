"""Plays a recording: the only thread that changes the picture, and no connection to anything."""

import logging
import sys
import threading
from collections import deque
from collections.abc import Callable
from functools import partial

from fleet_tui.errors import FleetError
from fleet_tui.model.fleet import FleetState
from fleet_tui.recording.play.playback import Playback
from fleet_tui.recording.play.times import moment_of
from fleet_tui.recording.recording import Recording
from fleet_tui.state.store import Store
from fleet_tui.view.lines.time import ReplayPosition

LOG = logging.getLogger(__name__)

STEADY = 1 / 30
"""Seconds between two looks at the clock while it plays."""
ONCE_MORE = 1.0
"""Recorded seconds after a mark within which "previous" means the one before it."""
SWITCH_INTERVAL = 0.0005
"""As long as Python lets this thread run on while the screen waits, in seconds."""


class Player:
    """Does one thing after the other; any thread may ask for them. Raises RecordingError for a
    recording that can't be played."""

    def __init__(self, recording: Recording, speed: float = 1.0) -> None:
        self._recording = recording
        self._jobs: deque[Callable[[], None]] = deque()
        self._changed = threading.Condition()
        self._closing = False
        self._target: float | None = None
        self._deck = Playback(recording, speed)
        self.frames = self._deck.head.frames
        """Reads what is played, and counts it."""

    def start(self, store: Store) -> None:
        """Begin to play into a store."""
        sys.setswitchinterval(SWITCH_INTERVAL)
        self._deck.go_on()
        threading.Thread(target=self._run, args=(store,), name="fleet-tui-player", daemon=True).start()

    def enter(self, at: float) -> None:
        """Go to where it is to begin, before it is started."""
        self._deck.seek(at, lambda: True)
        self._deck.show()

    def close(self) -> None:
        """Stop for good."""
        with self._changed:
            self._closing = True
            self._changed.notify()

    @property
    def state(self) -> FleetState:
        """Return what is to be seen now."""
        return self._deck.shown[0]

    @property
    def moment(self) -> ReplayPosition:
        """Return where in the recording what is seen was."""
        return self._deck.shown[1]

    def toggle(self) -> None:
        """Play, or stop."""
        self._ask(self._deck.toggle)

    def change_speed(self, step: int) -> None:
        """The next faster (1) or slower (-1) speed; 0 is as it was."""
        self._ask(partial(self._deck.change_speed, step))

    def step(self, ticks: int) -> None:
        """One tick of the recorded clock on (1) or back (-1), and stop there."""
        self._ask(partial(self._deck.step, self._deck.head.step_tick, ticks))

    def step_record(self, records: int) -> None:
        """One record on (1) or back (-1), and stop there."""
        self._ask(partial(self._deck.step, self._deck.head.step_record, records))

    def seek(self, at: float) -> None:
        """To a monotonic second of the recording, instead of any other that was asked for before."""
        self._target = at = max(self._recording.begin.at, min(at, self._recording.end.at))
        self._ask(partial(self._seek, at))

    def time_of(self, text: str) -> float:
        """The second that is written as a time. Raises FleetError."""
        return moment_of(text, self._recording)

    def skip(self, seconds: float) -> None:
        """So much on or back, from where it is going."""
        self.seek(self._going_to + seconds)

    def to_end(self, step: int) -> None:
        """To the beginning (-1) or the end (1)."""
        self.seek(self._recording.end.at if step > 0 else self._recording.begin.at)

    def to_mark(self, step: int) -> str:
        """To the next (1) or previous (-1) mark; where there is none, what to say."""
        here, marks = self._going_to, self._deck.marks
        if step > 0:
            found = [mark for mark in marks if mark.at > here][:1]
        else:
            before = here if self.moment.paused else here - ONCE_MORE
            found = [mark for mark in marks if mark.at < before][-1:]
        for mark in found:
            self.seek(mark.at)
        if found:
            return ""
        return f"no alarm, command or gap {'after' if step > 0 else 'before'} this"

    @property
    def _going_to(self) -> float:
        target = self._target
        return self.moment.at if target is None else target

    def _ask(self, job: Callable[[], None]) -> None:
        with self._changed:
            self._jobs.append(job)
            self._changed.notify()

    def _play(self) -> None:
        self._deck.play(lambda: not self._jobs and not self._closing)

    def _seek(self, at: float) -> None:
        try:
            if self._target == at:
                self._deck.seek(at, lambda: self._target == at and not self._closing)
        finally:
            if self._target == at:
                self._target = None

    def _run(self, store: Store) -> None:
        while True:
            with self._changed:
                if not self._jobs and not self._closing:
                    self._changed.wait(None if self._deck.paused else STEADY)
                if self._closing:
                    return
                job = self._jobs.popleft() if self._jobs else self._play
            try:
                job()
            except FleetError as problem:
                self._deck.fail(str(problem))
            except Exception as problem:
                LOG.exception("replay")
                self._deck.fail(f"playback stopped: {problem} (see the log file)")
            self._deck.show()
            store.put(self.state)

"""Records the watched fleet. No method waits for a disk, and no error here reaches the link: lost records are
counted, and reported."""

import logging
import threading
import time
from collections import deque
from pathlib import Path
from typing import Any

from fleet_tui.config.schema import Config
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.recording.part_files import USUAL, PartLimits
from fleet_tui.records.recording.part_writer import PartWriter
from fleet_tui.state.store import Store
from fleet_tui.storage.worker import Worker
from fleet_tui.text.language import EMPTY, Message

LOG = logging.getLogger(__name__)

KEYFRAME_EVERY = 60.0
"""Maximum seconds between keyframes, which a replay must read before its start."""
KEYFRAME_AFTER = 20_000
"""Maximum records between keyframes: fewer seconds for a large fleet, so that a replay seeks within a
second."""
DRAIN_EVERY = 0.5
FLUSH_EVERY = 0.9
"""Seconds between two reads of the queue, and the maximum loss by a kill."""
MOST_WAITING = 32 * 2**20
"""Maximum bytes that wait to be written; one frame may exceed it."""
OVERHEAD = 300
"""Bytes of an entry besides its frame."""
LAST_WORDS = 1.0
"""Maximum seconds for the end."""


class Recorder:
    """A tap. `on_...` and `watch` are called on the network loop, the rest from any thread."""

    def __init__(
        self, first: Path, config: Config, store: Store, origin: Origin, limits: PartLimits = USUAL
    ) -> None:
        """Begin. Raises RecordingError if the file can't be created, or exists already."""
        self.writer = PartWriter(first, config, origin, limits)
        self._store = store
        self._queue: deque[tuple[Any, ...]] = deque()
        self._in = 0
        self._out = 0
        self._dropped = 0
        self._next_keyframe = 0.0
        self._since = 0
        self._begun = False
        self._flush_at = time.monotonic() + FLUSH_EVERY
        self.path = first
        self.began = time.monotonic()
        self._worker = Worker("record", self._write, DRAIN_EVERY, self._end)
        self._worker.start()
        store.watchers = [*store.watchers, self.watch]

    @property
    def problem(self) -> Message:
        """Return the reason that nothing is written now, empty while data is written."""
        if self.writer.files.problem:
            return self.writer.files.problem
        return Message("data rate too high") if self._dropped else EMPTY

    @property
    def size(self) -> int:
        """Bytes written so far, compressed."""
        return self.writer.files.size

    @property
    def records(self) -> int:
        """Return the number of records written so far."""
        return self.writer.records

    @property
    def paths(self) -> list[Path]:
        """Return the current files, the oldest first."""
        return list(self.writer.files.paths)

    def on_received(self, link: str, channel: str, payload: bytes, is_binary: bool, at: float) -> None:
        """Take a frame that arrived at `at`."""
        self._take(len(payload), self.writer.received, at, link, channel, payload, is_binary)

    def on_sent(self, link: str, channel: str, payload: bytes) -> None:
        """Take a sent frame."""
        self._take(len(payload), self.writer.sent, time.monotonic(), link, channel, payload)

    def on_event(self, event: Event) -> None:
        """Take an event before the store gets it."""
        at = time.monotonic()
        if (
            at >= self._next_keyframe
            or self._since > KEYFRAME_AFTER
            or self.writer.wants_keyframe
            or self._dropped
        ):
            self._take_keyframe(at)
        self._take(0, self.writer.event, at, event)

    def watch(self, before: FleetState, after: FleetState) -> None:
        """Take the change of a command or an alarm."""
        self._take(0, self.writer.changed, time.monotonic(), before, after)

    def _take(self, size: int, *entry: Any) -> None:
        if self._in - self._out > MOST_WAITING or self._dropped or not self._begun:
            # After a gap, the following records would give another state: drop up to the next keyframe.
            self._dropped += self._begun
            return
        self._since += 1
        self._in += size + OVERHEAD
        self._queue.append((size + OVERHEAD, *entry))

    def _take_keyframe(self, at: float) -> None:
        """Queue the state before the next record; later if too much waits."""
        if self._in - self._out > MOST_WAITING // 2:
            return
        dropped, self._dropped = self._dropped, 0
        self._begun = True
        self.writer.wants_keyframe = False
        self._next_keyframe = at + KEYFRAME_EVERY
        self._since = 0
        if dropped:
            self._take(0, self.writer.missed, at, dropped, "received faster than written")
        self._take(0, self.writer.keyframe, at, self._store.state)

    def flush(self, within: float = LAST_WORDS) -> bool:
        """Write everything so far to the files, which are whole until the next write, if the disk takes it.
        Tell whether that was in time."""
        done = threading.Event()
        self._queue.append((0, self._flush, done))
        self._worker.wake()
        return done.wait(within)

    def _flush(self, done: threading.Event) -> None:
        self.writer.flush(whole=True)
        done.set()

    def close(self) -> None:
        """Stop, and end the file."""
        self._store.watchers = [one for one in self._store.watchers if one != self.watch]
        self._worker.close(LAST_WORDS)

    def _write(self) -> None:
        self._drain()
        now = time.monotonic()
        if now >= self._flush_at:
            self._flush_at = now + FLUSH_EVERY
            self._guarded(self.writer.flush)

    def _end(self) -> None:
        self._drain()
        self.writer.close()

    def _drain(self) -> None:
        self.writer.note_time()
        for _ in range(len(self._queue)):
            size, *entry = self._queue.popleft()
            self._guarded(*entry)
            self._out += size

    def _guarded(self, call: Any, *what: Any) -> None:
        """Run a step; whatever the error, the remaining entries must still be written."""
        try:
            call(*what)
        except Exception as problem:
            LOG.exception("recording")
            self.writer.lose(f"internal error: {problem}")

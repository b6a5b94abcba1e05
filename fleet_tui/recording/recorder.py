"""Records while the fleet is watched. Nothing here waits for a disk, and nothing that goes wrong here
reaches the link: what can't be kept is counted, and said."""

import logging
import threading
import time
from collections import deque
from pathlib import Path
from typing import Any

from fleet_tui.audit.entries import Origin
from fleet_tui.config.schema import Config
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.recording.part_files import USUAL, PartLimits
from fleet_tui.recording.part_writer import PartWriter
from fleet_tui.state.store import Store

LOG = logging.getLogger(__name__)

KEYFRAME_EVERY = 60.0
"""Seconds: for so long a replay has to look ahead at most, wherever it begins."""
KEYFRAME_AFTER = 20_000
"""Records: of a large fleet sooner, so that a replay is anywhere within a second."""
DRAIN_EVERY, FLUSH_EVERY = 0.5, 0.9
"""Seconds between two looks at what has come, and what a kill costs at most."""
MOST_WAITING = 32 * 2**20
"""Bytes that wait to be written; one frame may come on top."""
OVERHEAD = 300
"""Bytes that an entry takes beside its frame."""
LAST_WORDS = 1.0
"""Seconds that the end may take."""


class Recorder:
    """A tap. `heard`, `sent`, `told` and `watch` are called on the network loop, the rest by any thread."""

    def __init__(
        self, first: Path, config: Config, store: Store, origin: Origin, limits: PartLimits = USUAL
    ) -> None:
        """Begin. Raises RecordingError where the file can't be made, or is there already."""
        self._writer = PartWriter(first, config, origin, limits)
        self._store = store
        self._queue: deque[tuple[Any, ...]] = deque()
        self._in = self._out = 0
        self._dropped = 0
        self._next_keyframe, self._since = 0.0, 0
        self._begun = self._closing = False
        self._wake = threading.Event()
        self.path = first
        self.began = time.monotonic()
        self._thread = threading.Thread(target=self._run, name="fleet-tui-record", daemon=True)
        self._thread.start()
        store.watchers = [*store.watchers, self.watch]

    @property
    def problem(self) -> str:
        """Return why nothing is written now, "" while all is well."""
        if self._writer.files.problem:
            return self._writer.files.problem
        return "data rate too high" if self._dropped else ""

    @property
    def size(self) -> int:
        """Bytes written so far, compressed."""
        return self._writer.files.size

    @property
    def records(self) -> int:
        """Return how many were written so far."""
        return self._writer.records

    @property
    def paths(self) -> list[Path]:
        """The files that there are now, the oldest first."""
        return list(self._writer.files.paths)

    def heard(self, link: str, channel: str, payload: bytes, is_binary: bool, at: float) -> None:
        """A frame came at `at`."""
        self._take(len(payload), self._writer.heard, at, link, channel, payload, is_binary)

    def sent(self, link: str, channel: str, payload: bytes) -> None:
        """A frame left."""
        self._take(len(payload), self._writer.sent, time.monotonic(), link, channel, payload)

    def told(self, event: Event) -> None:
        """Something happened; the store does not know it yet."""
        at = time.monotonic()
        if (
            at >= self._next_keyframe
            or self._since > KEYFRAME_AFTER
            or self._writer.wants_keyframe
            or self._dropped
        ):
            self._take_keyframe(at)
        self._take(0, self._writer.told, at, event)

    def watch(self, before: FleetState, after: FleetState) -> None:
        """A command or an alarm changed."""
        self._take(0, self._writer.changed, time.monotonic(), before, after)

    def _take(self, size: int, *entry: Any) -> None:
        if self._in - self._out > MOST_WAITING or self._dropped or not self._begun:
            # With a gap in it, what follows would make another picture: up to the next keyframe.
            self._dropped += self._begun
            return
        self._since += 1
        self._in += size + OVERHEAD
        self._queue.append((size + OVERHEAD, *entry))

    def _take_keyframe(self, at: float) -> None:
        """The state as it is before what comes next. Where too much waits, it comes later."""
        if self._in - self._out > MOST_WAITING // 2:
            return
        dropped, self._dropped = self._dropped, 0
        self._begun, self._writer.wants_keyframe = True, False
        self._next_keyframe, self._since = at + KEYFRAME_EVERY, 0
        if dropped:
            self._take(0, self._writer.missed, at, dropped, "received faster than written")
        self._take(0, self._writer.keyframe, at, self._store.state)

    def flush(self, within: float = LAST_WORDS) -> bool:
        """Have everything up to now in the files, which are whole until the next write, if the disk takes
        it. Whether that was in time."""
        done = threading.Event()
        self._queue.append((0, self._flush, done))
        self._wake.set()
        return done.wait(within)

    def _flush(self, done: threading.Event) -> None:
        self._writer.flush(whole=True)
        done.set()

    def close(self) -> None:
        """Stop, and end the file."""
        self._store.watchers = [one for one in self._store.watchers if one != self.watch]
        self._closing = True
        self._wake.set()
        self._thread.join(LAST_WORDS)

    def _run(self) -> None:
        flush_at = 0.0
        while not self._closing:
            self._wake.wait(DRAIN_EVERY)
            self._wake.clear()
            self._drain()
            now = time.monotonic()
            if now >= flush_at:
                flush_at = now + FLUSH_EVERY
                self._guarded(self._writer.flush)
        self._drain()
        self._guarded(self._writer.close)

    def _drain(self) -> None:
        self._writer.note_time()
        for _ in range(len(self._queue)):
            size, *entry = self._queue.popleft()
            self._guarded(*entry)
            self._out += size

    def _guarded(self, call: Any, *what: Any) -> None:
        """Whatever is wrong with one entry, or with us, the rest is still to be written."""
        try:
            call(*what)
        except Exception as problem:
            LOG.exception("recording")
            self._writer.lose(f"internal error: {problem}")

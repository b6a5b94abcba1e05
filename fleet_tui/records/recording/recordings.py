"""The recordings of a console: the last minutes continuously, and one on request."""

import logging
import math
import os
import re
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from fleet_tui.config.schema import Config
from fleet_tui.records.audit.log import new_origin
from fleet_tui.records.recording.part_files import PartLimits, parts_beside
from fleet_tui.records.recording.recorder import Recorder
from fleet_tui.records.recording.taps import Taps
from fleet_tui.state.store import Store
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import EMPTY, Message, verbatim
from fleet_tui.text.units import age

LOG = logging.getLogger(__name__)

RECENT = "recent"
RECORDINGS = "recordings"
RECENT_PART = 60.0
"""Seconds of a file of the last minutes."""
PARTS = 8
"""Minimum number of files that share the bytes of the last minutes."""


class Recordings:
    """`taps` is the tap of the console's link. Callable from any thread, one call at a time."""

    def __init__(self, config: Config, store: Store, folder: Path, demo: bool = False) -> None:
        self.taps = Taps()
        self._config = config
        self._store = store
        self._folder = folder
        self._demo = demo
        self._recent: Recorder | None = None
        self._recorder: Recorder | None = None
        self._earlier = list[Path]()
        """The last minutes before the fleet was extended."""
        self._problem = EMPTY

    @property
    def recorder(self) -> "Recorder | None":
        """Return the recording that the operator started, while it runs."""
        return self._recorder

    def keep_recent(self) -> None:
        """Keep the last minutes from now on, as configured."""
        # A demo does not delete the files of a site's console that crashed.
        usual, folder = self._config.recording, self._folder / RECENT / ("demo" if self._demo else "")
        if not usual.recent_minutes:
            return
        size = usual.recent_mb * 1e6
        kept = math.ceil(usual.recent_minutes * 60 / RECENT_PART) + 1
        # One file is being written, not counted with the others.
        limits = PartLimits(
            part_bytes=size / PARTS, part_seconds=RECENT_PART, kept=kept, total_bytes=size - size / PARTS
        )
        try:
            remove_stale(folder)
            self._recent = self._record(folder / f"{_of_this_process()}-{_now()}.jsonl.gz", limits)
        except (FleetError, OSError) as problem:
            LOG.warning("last minutes not kept: %s", problem)
            self._problem = verbatim(getattr(problem, "strerror", None) or problem)

    def extend(self, config: Config, change: Callable[[], None]) -> None:
        """Go on in new recordings with this configuration, after a `change` of the fleet to it: a recording
        has one."""
        began = self._recorder is not None
        for recorder in (self._recorder, self._recent):
            if recorder is not None:
                self.taps.detach(recorder)
        for path in self._earlier:
            path.unlink(missing_ok=True)
        self._earlier = self._recent.paths if self._recent is not None else []
        self._recorder = self._recent = None
        change()
        self._config = config
        self.keep_recent()
        if began:
            try:
                self.start()
            except FleetError as problem:
                LOG.warning("recording ended: %s", problem)

    def start(self) -> Path:
        """Start a recording; return its path. Raises RecordingError."""
        usual = self._config.recording
        limits = PartLimits(
            part_bytes=usual.rotate_mb * 1e6, part_seconds=usual.rotate_minutes * 60, kept=usual.keep
        )
        self._recorder = self._record(self._folder / RECORDINGS / f"{_now()}.jsonl.gz", limits)
        return self._recorder.path

    def stop(self) -> Message:
        recorder, self._recorder = self._recorder, None
        if recorder is None:
            return Message("no recording running")
        lasted = age(time.monotonic() - recorder.began)
        self.taps.detach(recorder)
        lost = Message(", incomplete: {problem}", problem=recorder.problem) if recorder.problem else ""
        return Message(
            "recorded {lasted}, {size} MB{lost}: {path}",
            lasted=lasted,
            size=f"{recorder.size / 1000000.0:.1f}",
            lost=lost,
            path=recorder.path,
        )

    def notes(self) -> list[Message]:
        """Return notes: that it records, and any failures."""
        found = list[Message]()
        if self._recorder is not None:
            problem = self._recorder.problem
            lasts = age(time.monotonic() - self._recorder.began)
            found.append(
                Message("rec: not written: {problem}", problem=problem)
                if problem
                else Message("rec {lasts}", lasts=lasts)
            )
        problem = self._recent.problem if self._recent else self._problem
        return [*found, Message("last minutes not kept: {problem}", problem=problem)] if problem else found

    def recent(self) -> list[Path]:
        """Return the files of the last minutes, the oldest first: together, in this order, or each alone they
        are a recording."""
        if self._recent is None:
            return []
        self._recent.flush()
        return self._recent.paths

    def close(self) -> None:
        """End all recordings. The last minutes stay for later analysis."""
        for recorder in (self._recorder, self._recent):
            if recorder is not None:
                self.taps.detach(recorder)

    def _record(self, path: Path, limits: object) -> "Recorder":
        assert isinstance(limits, PartLimits)
        origin = new_origin(self._config, self._demo)
        return self.taps.attach(Recorder(path, self._config, self._store, origin, limits))


def _now() -> str:
    return time.strftime("%Y%m%d-%H%M%S")


def _of_this_process() -> str:
    """Return a unique name of this process, also among machines with the same home."""
    return f"{_host()}-{os.getpid()}"


def _host() -> str:
    return re.sub(r"[^A-Za-z0-9]+", "_", os.uname().nodename)


def remove_stale(folder: Path) -> None:
    """Remove the last minutes of processes that have ended, except the newest: it may be needed for analysis.
    Raises OSError."""
    ended = sorted(_ended(folder))
    for _, run, path in ended:
        if run != ended[-1][1]:
            path.unlink(missing_ok=True)


def recent_runs(folder: Path) -> dict[str, list[Path]]:
    """Return the last minutes of every console in a state folder: by name, the oldest file first."""
    files = (folder / RECENT).glob("*.jsonl.gz")
    return {path.name.partition(".")[0]: list(parts_beside(path)) for path in sorted(files)}


def _ended(folder: Path) -> Iterator[tuple[str, str, Path]]:
    """Return start, run and path of all files of ended processes of this machine."""
    if not folder.is_dir():
        return
    for path in folder.iterdir():
        found = re.fullmatch(
            re.escape(_host()) + r"-(\d{1,9})-(\d{8}-\d{6})(?:\.\d{4,9})?\.jsonl\.gz", path.name
        )
        if found and not _is_running(int(found[1])):
            yield found[2], f"{found[1]}-{found[2]}", path


def _is_running(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True
    # Ours would have another name: the earlier process of this number has ended.
    return process != os.getpid()

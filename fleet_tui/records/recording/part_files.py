"""The files of a running recording: a new one in time, old ones deleted, another after an error."""

import logging
import re
import time
from collections.abc import Callable, Iterator
from pathlib import Path

from msgspec import Struct

from fleet_tui.records.recording.part_file import PartFile
from fleet_tui.records.recording.records import RecordingError
from fleet_tui.text.language import EMPTY, Message, verbatim

LOG = logging.getLogger(__name__)

RETRY = 1.0
"""Seconds between two attempts after a disk error."""

_SUFFIX = re.compile(r"(?:\.jsonl|\.json)?(?:\.gz)?$")


def _split(name: str) -> tuple[str, str]:
    found = _SUFFIX.search(name)
    cut = found.start() if found else len(name)
    return name[:cut], name[cut:]


def part_path(first: Path, number: int) -> Path:
    """Return the path of a part; 0 is the first."""
    stem, suffix = _split(first.name)
    return first.with_name(f"{stem}.{number:04}{suffix}") if number else first


def parts_beside(path: Path) -> Iterator[Path]:
    """Return every file that may be a part of the recording of `path`, in order of their numbers."""
    stem, suffix = _split(path.name)
    stem = re.sub(r"\.\d{4,9}$", "", stem)
    numbered = re.compile(re.escape(stem) + r"(?:\.(\d{4,9}))?" + re.escape(suffix))
    try:
        names = [found for one in path.parent.iterdir() if (found := numbered.fullmatch(one.name))]
    except OSError:
        names = []
    for found in sorted(names, key=lambda found: int(found[1] or 0)):
        yield path.with_name(found[0])


class PartLimits(Struct, frozen=True, kw_only=True):
    """Limits of a new file (its bytes, its seconds), number of files kept (0: all), and their total bytes."""

    part_bytes: float = 256e6
    part_seconds: float = 3600.0
    kept: int = 0
    total_bytes: float = float("inf")


USUAL = PartLimits()


class PartFiles:
    """A failed operation returns False, with the reason in `problem`; the next `turn` tries another file."""

    def __init__(self, first: Path, limits: PartLimits, head: Callable[[int, float], bytes]) -> None:
        """Begin. `head` returns the first lines of a part that begins at a monotonic second. Raises
        RecordingError if `first`, or another part of it, exists already, or can't be created."""
        if any(parts_beside(first)):
            raise RecordingError(Message("{first}: exists: choose another name, or remove it", first=first))
        self.problem = EMPTY
        self.paths: list[Path] = []
        self._first = first
        self._limits = limits
        self._head = head
        self._number = self._before = 0
        self._began = self._retry_at = 0.0
        self._file: PartFile | None = None
        try:
            self._open(time.monotonic())
        except (OSError, ValueError) as problem:
            message = getattr(problem, "strerror", "") or problem
            raise RecordingError(
                Message("{first}: not writable: {message}", first=first, message=message)
            ) from None

    @property
    def is_open(self) -> bool:
        return self._file is not None

    @property
    def size(self) -> int:
        """Return the bytes written, in all files."""
        return self._before + (self._file.size if self._file else 0)

    def needs_turn(self, at: float) -> bool:
        """Tell whether a new file is due, because one is full, or it is time for another attempt."""
        if self._file is None:
            return time.monotonic() >= self._retry_at
        limits = self._limits
        return self._file.size > limits.part_bytes or at - self._began >= limits.part_seconds

    def turn(self, at: float) -> bool:
        """Start a new gzip member, or a new file, so that readers can seek here."""
        try:
            if self._file is None or self.needs_turn(at):
                self.close()
                self._open(at)
            else:
                self._file.begin_member()
        except OSError as problem:
            # A foreign file may have the name.
            self._number += isinstance(problem, FileExistsError)
            return self._fail(problem)
        self.problem = EMPTY
        return True

    def write(self, lines: bytes) -> bool:
        """Add lines, which are on the disk after the next flush."""
        return self._do(lambda file: file.write(lines))

    def flush(self, whole: bool = False) -> bool:
        """Put everything on the disk; `whole`: as a file with a proper end, until the next write."""

        def flush(file: PartFile) -> None:
            if not file.is_there():
                raise OSError(None, "file removed")
            file.begin_member() if whole else file.flush()

        return self._do(flush)

    def close(self) -> bool:
        """End the file properly."""
        done = self._do(lambda file: file.end())
        self._let_go()
        return done

    def _do(self, act: Callable[[PartFile], None]) -> bool:
        if self._file is None:
            return False
        try:
            act(self._file)
        except OSError as problem:
            return self._fail(problem)
        return True

    def _open(self, at: float) -> None:
        path = part_path(self._first, self._number)
        self._file = PartFile(path, self._head(self._number, at))
        self._number = self._number + 1
        self._began = at
        self.paths.append(path)
        self._drop_old()

    def _drop_old(self) -> None:
        """Delete the oldest files above the limit. Only those of this recording are touched."""
        limits = self._limits
        while len(self.paths) > 1:
            sizes = [path.stat().st_size if path.exists() else 0 for path in self.paths]
            if not (limits.kept and len(self.paths) > limits.kept) and sum(sizes) <= limits.total_bytes:
                break
            self.paths.pop(0).unlink(missing_ok=True)

    def _let_go(self) -> None:
        file, self._file = self._file, None
        if file is not None:
            self._before += file.size
            file.close()

    def _fail(self, problem: OSError) -> bool:
        message = verbatim(problem.strerror or problem)
        if message != self.problem:
            LOG.error("recording: not written: %s: %s", self._first, message)
        self.problem = message
        self._retry_at = time.monotonic() + RETRY
        self._let_go()
        return False

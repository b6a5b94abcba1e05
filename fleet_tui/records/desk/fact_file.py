"""The shared file of facts: every console appends to it, and reads on where it stopped. All see one order."""

import errno
import math
import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

import msgspec

from fleet_tui.records.desk.facts import Fact, SharedClosure, SharedNote
from fleet_tui.storage.handles import open_shared
from fleet_tui.storage.line_file import append_line
from fleet_tui.storage.lock import lock
from fleet_tui.storage.whole_file import replace_shared
from fleet_tui.text.language import in_english

FILE = "facts.jsonl"
LOCK = "facts.lock"
LARGEST = 1_000_000
"""Bytes of the file above which it is written again without what is over."""
LOCK_WITHIN = 1.0
"""Seconds to wait for the lock, which another console holds for a moment."""
RECENT = 200
"""Facts that stay then, whatever they are: a console that has just come reads them."""
NOTES_KEPT = 200
CLOSURES_KEPT = 1000
AT_ONCE = 4 * LARGEST
"""Bytes that are read at a time."""
SHORTEN_EVERY = 60.0
"""Seconds between two attempts to shorten the file: each reads all of it, and may fail."""

_DECODER: msgspec.json.Decoder[Fact] = msgspec.json.Decoder(Fact)


class FactFile:
    """One console's place in the file. Not for several threads."""

    def __init__(self, folder: Path) -> None:
        self._path = folder / FILE
        self._lock = folder / LOCK
        self._handle: int | None = None
        self._at = 0
        self._known: dict[str, None] = {}
        self._shortens_at = -math.inf
        self.grows = ""
        """Why the file could not be shortened the last time."""
        self.is_past = True
        """Whether the facts of the next reading were told before this console came."""
        self.ignored = 0
        """Lines that are no facts."""

    @contextmanager
    def appending(self) -> Iterator[Callable[[Fact], None]]:
        """Provide what appends one fact after the other, while no other console writes. Raises OSError."""
        with self._locked():
            handle = open_shared(self._path, os.O_RDWR | os.O_APPEND | os.O_CREAT)
            try:
                yield lambda fact: _append(handle, msgspec.json.encode(fact, enc_hook=in_english) + b"\n")
            finally:
                os.close(handle)

    @contextmanager
    def _locked(self) -> Iterator[None]:
        handle = open_shared(self._lock, os.O_RDWR | os.O_CREAT)
        try:
            if not lock(handle, LOCK_WITHIN):
                raise OSError(errno.EAGAIN, f"{self._lock.name} is locked by another console")
            yield
        finally:
            os.close(handle)

    def shorten(self, now: float) -> None:
        """Write a large file again without what is over, from time to time; `now` is monotonic. If that fails
        the file grows, and nothing else."""
        if now < self._shortens_at:
            return
        try:
            if self._size() <= LARGEST:
                return
            self._shortens_at = now + SHORTEN_EVERY
            with self._locked():
                if (size := self._size()) > LARGEST:
                    self._shorten(size)
            self.grows = ""
        except OSError as problem:
            self.grows = problem.strerror or str(problem)

    def _size(self) -> int:
        try:
            return self._path.stat(follow_symlinks=False).st_size
        except FileNotFoundError:
            return 0

    def _shorten(self, size: int) -> None:
        """Write the file again with what still counts. The lock is held."""
        handle = open_shared(self._path, os.O_RDONLY)
        try:
            lines = os.pread(handle, AT_ONCE, max(0, size - AT_ONCE)).splitlines()
        finally:
            os.close(handle)
        kept = still_counting([fact for line in lines if (fact := _fact(line)) is not None])
        replace_shared(
            self._path, b"".join(msgspec.json.encode(fact, enc_hook=in_english) + b"\n" for fact in kept)
        )

    def read(self) -> list[Fact]:
        """Return the facts since the last time, this console's own among them. Raises OSError."""
        found = self._read_on()
        if self._is_replaced():
            found += self._read_on()  # what came between the two looks
            self._reopen()
            found += self._read_on()
        return found

    def _is_replaced(self) -> bool:
        try:
            now = self._path.stat(follow_symlinks=False)
        except FileNotFoundError:
            self.is_past = False
            return False
        if self._handle is None:
            return True
        mine = os.fstat(self._handle)
        return (now.st_dev, now.st_ino) != (mine.st_dev, mine.st_ino) or now.st_size < self._at

    def _reopen(self) -> None:
        self.close()
        self._handle = open_shared(self._path, os.O_RDONLY)
        self._at = 0

    def _read_on(self) -> list[Fact]:
        """Return the new facts of the open file, whole lines only."""
        if self._handle is None:
            return []
        data = os.pread(self._handle, AT_ONCE, self._at)
        end = data.rfind(b"\n") + 1
        if not end and len(data) == AT_ONCE:
            end = len(data)  # no line of ours
        self._at += end
        self.is_past = self.is_past and len(data) == AT_ONCE
        return [fact for line in data[:end].splitlines() if (fact := self._new(line)) is not None]

    def _new(self, line: bytes) -> Fact | None:
        """Return the fact of a line, None if it is none or was read before."""
        fact = _fact(line)
        if fact is None:
            self.ignored += bool(line)
            return None
        if fact.id in self._known:
            return None
        self._known[fact.id] = None
        if len(self._known) > LARGEST // 50:
            del self._known[next(iter(self._known))]
        return fact

    def close(self) -> None:
        if self._handle is not None:
            os.close(self._handle)
            self._handle = None


def _append(handle: int, line: bytes) -> None:
    """Append a line. Raises OSError, and leaves nothing of it then."""
    size = os.fstat(handle).st_size
    try:
        append_line(handle, line)
    except OSError:
        os.ftruncate(handle, size)
        raise


def _fact(line: bytes) -> Fact | None:
    try:
        return _DECODER.decode(line)
    except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError):
        return None


def lasts(fact: Fact) -> bool:
    """Tell whether a fact counts for a console that was not there yet when it was told."""
    return isinstance(fact, SharedClosure | SharedNote)


def still_counting(facts: Iterable[Fact]) -> list[Fact]:
    """Return the facts that a new console needs, in their order: closed edges, the last notes, the newest."""
    facts = list(facts)
    last: dict[tuple[str, str, str], SharedClosure] = {}
    for fact in facts:
        if isinstance(fact, SharedClosure):
            last[fact.ends] = fact
    closed = [fact for fact in last.values() if fact.closed][-CLOSURES_KEPT:]
    notes = [fact for fact in facts if isinstance(fact, SharedNote)][-NOTES_KEPT:]
    kept = {fact.id for fact in (*closed, *notes, *facts[-RECENT:])}
    return [fact for fact in facts if fact.id in kept]

"""Locks of files between processes. The system lets go of those of a process that ends, however it ends."""

import fcntl
import os
import time
from collections.abc import Callable
from pathlib import Path

from fleet_tui.storage.handles import open_private

LONGEST_OWNER = 200
"""Bytes of the owner in the file of a lock."""
LOOKED_AT = 0.05
"""Seconds in which who only looks at a lock has gone again."""
LOOK = 0.005
"""Seconds between two tries."""


def lock(handle: int, within: float = 0.0) -> bool:
    """Lock an open file until it is closed; tell whether that was possible within so many seconds. Raises
    OSError where files can't be locked."""
    until = time.monotonic() + within
    while not _try(handle, fcntl.LOCK_EX):
        if time.monotonic() >= until:
            return False
        time.sleep(LOOK)
    return True


def is_locked(handle: int) -> bool:
    """Tell whether another open file of the same name holds the lock, also where nobody can tell."""
    try:
        return not _try(handle, fcntl.LOCK_SH)
    except OSError:
        return True


def _try(handle: int, kind: int) -> bool:
    try:
        fcntl.flock(handle, kind | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


class LockFile:
    """A lock with a file of its own, in which its owner stands."""

    def __init__(self, path: Path, opening: Callable[[Path, int], int] = open_private) -> None:
        self.path = path
        self._opening = opening
        self._handle: int | None = None

    @property
    def is_held(self) -> bool:
        """Tell whether no other process can have it: somebody may have removed the file."""
        try:
            return self._handle is not None and os.path.samestat(os.fstat(self._handle), self.path.stat())
        except OSError:
            return False

    def take(self, owner: str = "") -> bool:
        """Tell whether this process has it, and take it if it is free. Raises OSError if there can be no such
        file."""
        if self.is_held:
            return True
        self.release()
        handle = self._opening(self.path, os.O_RDWR | os.O_CREAT)
        try:
            if not lock(handle, LOOKED_AT):
                return False
            os.ftruncate(handle, 0)
            os.pwrite(handle, owner.encode()[:LONGEST_OWNER], 0)
            self._handle, handle = handle, -1
        finally:
            if handle >= 0:
                os.close(handle)
        return True

    def release(self) -> None:
        """Let others take it."""
        if self._handle is not None:
            os.close(self._handle)
            self._handle = None


def owner_of(path: Path, opening: Callable[[Path, int], int] = open_private) -> str | None:
    """Return what the process wrote that holds the lock of this file, None if none of this machine does."""
    try:
        handle = opening(path, os.O_RDONLY)
    except OSError:
        return None
    try:
        return os.pread(handle, LONGEST_OWNER, 0).decode(errors="replace") if is_locked(handle) else None
    finally:
        os.close(handle)

"""The turn to observe a site: of several consoles only one writes what its robots do."""

import fcntl
import os
from contextlib import suppress
from pathlib import Path


class Turn:
    """A lock on a file beside the history; the system lets go of that of a process which was killed."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._handle: int | None = None

    @property
    def is_held(self) -> bool:
        """Tell whether no other process can have it."""
        return self._handle is not None

    def take(self) -> bool:
        """Tell whether this process observes; take the turn if it is free."""
        if self._handle is not None:
            return True
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True, mode=0o700)
            handle = os.open(f"{self._path}.lock", os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        except OSError:
            return True  # the database will say why
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            os.close(handle)
            return False
        self._handle = handle
        return True

    def close(self) -> None:
        """Let another console observe."""
        if self._handle is not None:
            with suppress(OSError):
                os.close(self._handle)
            self._handle = None

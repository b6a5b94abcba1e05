"""The file of orders that this console keeps, which survives the process: one console of a user owns it at a
time."""

import fcntl
import os
import socket
from pathlib import Path

import msgspec

from fleet_tui.model.order import Stop

FILE, LOCK = "queue.json", "queue.lock"
LARGEST = 2**24


class WaitingOrder(msgspec.Struct, frozen=True):
    """An order that waits for its robot behind the bridge at `url`; `wall` is the Unix time at which it was
    given, `floor` the floor."""

    url: str
    robot: str
    stops: tuple[Stop, ...]
    wall: float
    floor: str = ""


class QueueFile:
    """The file in a folder; without a folder no order outlives this process."""

    def __init__(self, folder: Path | None, operator: str) -> None:
        self._folder, self._me = folder, f"{operator}@{socket.gethostname()}"
        self._lock: int | None = None
        self.owner = self._me
        """The console that keeps orders, as name@host."""
        self.problem = ""
        """The reason that waiting orders would not survive this console, empty if they do."""

    def claim(self) -> bool:
        """Become the console that keeps orders, unless another one is."""
        if self._folder is None or self._lock is not None:
            return True
        try:
            self._folder.mkdir(parents=True, exist_ok=True, mode=0o700)
            handle = os.open(self._folder / LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
        except OSError as problem:
            self.problem = f"{self._folder / LOCK}: {problem.strerror}"
            return True
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            self.owner = os.read(handle, 200).decode(errors="replace") or "another console"
            os.close(handle)
            return False
        self._lock, self.owner = handle, self._me
        os.ftruncate(handle, 0)
        os.pwrite(handle, self._me.encode(), 0)
        return True

    def load(self) -> list[WaitingOrder]:
        """Return the kept orders; an unreadable file is reported as a problem and kept under another name."""
        if self._folder is None or self._lock is None:
            return []
        path = self._folder / FILE
        try:
            with path.open("rb") as file:
                return msgspec.json.decode(file.read(LARGEST), type=list[WaitingOrder])
        except FileNotFoundError:
            return []
        except (OSError, msgspec.MsgspecError) as problem:
            aside = path.with_suffix(".unreadable")
            self.problem = f"{path} unreadable ({problem}): kept as {aside.name}"
            try:
                path.replace(aside)
            except OSError as error:
                self.problem = f"{path} unreadable: {error.strerror}"
            return []

    def save(self, kept: list[WaitingOrder]) -> None:
        """Save the kept orders atomically."""
        if self._folder is None or self._lock is None:
            return
        path = self._folder / FILE
        beside = path.with_suffix(".new")
        try:
            handle = os.open(beside, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_CLOEXEC, 0o600)
            with os.fdopen(handle, "wb") as file:
                file.write(msgspec.json.encode(kept))
            beside.replace(path)
            self.problem = ""
        except OSError as problem:
            self.problem = f"{path} not writable: {problem.strerror}"

    def close(self) -> None:
        """Let other consoles keep orders."""
        if self._lock is not None:
            os.close(self._lock)
            self._lock = None

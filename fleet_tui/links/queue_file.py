"""The file of orders that this console keeps, which survives the process: one console of a user owns it at a
time."""

import socket
from pathlib import Path

import msgspec

from fleet_tui.model.order import Stop
from fleet_tui.storage.lock import LockFile, owner_of
from fleet_tui.storage.whole_file import replacing
from fleet_tui.text.language import Message, in_english

FILE = "queue.json"
LOCK = "queue.lock"
LARGEST = 2**24


class WaitingOrder(msgspec.Struct, frozen=True):
    """An order that waits for its robot behind the bridge at `url`, without stops the start of a charge;
    `wall` is the Unix time at which it was given, `floor` the floor."""

    url: str
    robot: str
    stops: tuple[Stop, ...]
    wall: float
    floor: str = ""


class QueueFile:
    """The file in a folder; without a folder no order outlives this process."""

    def __init__(self, folder: Path | None, operator: str) -> None:
        self._path = folder / FILE if folder is not None else None
        self._lock = LockFile(folder / LOCK) if folder is not None else None
        self._me = f"{operator}@{socket.gethostname()}"
        self.owner = self._me
        """The console that keeps orders, as name@host."""
        self.problem = ""
        """The reason that waiting orders would not survive this console, empty if they do."""

    def claim(self) -> bool:
        """Become the console that keeps orders, unless another one is."""
        if self._lock is None:
            return True
        try:
            is_mine = self._lock.take(self._me)
        except OSError as problem:
            self.problem = f"{self._lock.path}: {problem.strerror}"
            return True
        self.owner = self._me if is_mine else owner_of(self._lock.path) or Message("another console")
        return is_mine

    def load(self) -> list[WaitingOrder]:
        """Return the kept orders; an unreadable file is reported as a problem and kept under another name."""
        if (path := self._kept_at()) is None:
            return []
        try:
            with path.open("rb") as file:
                return msgspec.json.decode(file.read(LARGEST), type=list[WaitingOrder])
        except FileNotFoundError:
            return []
        except (OSError, msgspec.MsgspecError) as problem:
            aside = path.with_suffix(".unreadable")
            self.problem = Message(
                "{path} unreadable ({problem}): kept as {name}", path=path, problem=problem, name=aside.name
            )
            try:
                path.replace(aside)
            except OSError as error:
                self.problem = Message("{path} unreadable: {strerror}", path=path, strerror=error.strerror)
            return []

    def save(self, kept: list[WaitingOrder]) -> None:
        """Save the kept orders atomically."""
        if (path := self._kept_at()) is None:
            return
        try:
            with replacing(path, is_synced=False) as file:
                file.write(msgspec.json.encode(kept, enc_hook=in_english))
            self.problem = ""
        except OSError as problem:
            self.problem = Message("{path} not writable: {strerror}", path=path, strerror=problem.strerror)

    def _kept_at(self) -> Path | None:
        return self._path if self._lock is not None and self._lock.is_held else None

    def close(self) -> None:
        """Let other consoles keep orders."""
        if self._lock is not None:
            self._lock.release()

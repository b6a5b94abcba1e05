"""What this console tells the desk, on its way into the shared file: each fact once, while it is so."""

import itertools
import time
from collections.abc import Callable

import msgspec

from fleet_tui.records.desk.fact_file import FactFile
from fleet_tui.records.desk.facts import Fact
from fleet_tui.storage.write_queue import WriteQueue

WAITING = 1000
"""Facts that wait for a writable folder; of more the oldest are lost, and counted."""


class FactOutbox:
    """Facts of one console and its operator `name`; told from any thread, sent from one."""

    def __init__(self, file: FactFile, console: str, name: str) -> None:
        self._file = file
        self._console = console
        self._name = name
        self._numbers = itertools.count(1)
        self._waiting = WriteQueue[Fact](WAITING)

    @property
    def lost(self) -> int:
        """Return the number of facts that did not reach the file since it was last writable."""
        return self._waiting.lost

    def tell(self, kind: type[Fact], /, **fields: object) -> None:
        usual = {"id": f"{self._console}:{next(self._numbers)}", "by": self._name, "wall": time.time()}
        self._waiting.append(msgspec.convert({**usual, **fields}, kind))

    def send(self, as_now: Callable[[Fact], Fact | None] = lambda fact: fact) -> None:
        """Append what waits: each fact leaves as soon as it is written. Raises OSError. `as_now` returns a
        fact as it is by now, None if it is over: it may have waited for long."""
        if not self._waiting:
            return
        with self._file.appending() as append:
            while self._waiting:
                fact = self._waiting.popleft()
                try:
                    if (newest := as_now(fact)) is not None:
                        append(newest)
                except OSError:
                    self._waiting.put_back(fact)
                    raise
        self._waiting.lost = 0

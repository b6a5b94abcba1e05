"""Consoles at one desk: each a store whose events come from one thread at a time, and its desk."""

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Note
from fleet_tui.records.desk.desk import SharedDesk
from fleet_tui.state.store import Store
from tests.support.fleets import T0, fleet, link_up, tick
from tests.support.polling import HANGS, eventually

R3 = "robot_3"
OFFLINE = (R3, "offline")


class DeskConsole:
    """A console of five robots, without a screen and without a wire."""

    def __init__(self, folder: Path, name: str, shares: bool = True) -> None:
        self._lock = threading.Lock()
        self._store = Store(fleet(5, 2))
        self.desk = SharedDesk(folder, self._store, name, shares)
        self.notes: list[tuple[Note, bool]] = []
        self.desk.on_note = lambda note, is_new: self.notes.append((note, is_new))
        self.post(link_up(T0))

    @property
    def state(self) -> FleetState:
        return self._store.state

    def post(self, event: Event) -> None:
        with self._lock:
            self._store.apply(event)

    def tick(self, at: float) -> None:
        """Let time pass; robots are silent."""
        self.post(tick(at))

    def becomes(self, holds: Callable[[FleetState], object], within: float = HANGS) -> float:
        """Wait until the state is as wanted; return the seconds."""
        began = time.monotonic()
        eventually(lambda: holds(self.state), within)
        return time.monotonic() - began


@contextmanager
def at_desk(folder: Path, *names: str) -> Iterator[list[DeskConsole]]:
    """Run consoles that see each other, until the end."""
    consoles = [DeskConsole(folder, name) for name in names]
    try:
        for one in consoles:
            one.desk.start(one.post)
        for one in consoles:
            one.becomes(lambda state: len(state.desk.others) >= len(names) - 1)
        yield consoles
    finally:
        for one in consoles:
            one.desk.close()

"""The desk for a command without a screen, which is not seen there: claims, and orders that are removed."""

import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from fleet_tui.config.schema import Config
from fleet_tui.model.desk.events import ColleaguesSeen
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.desk.commands import elsewhere_event, own_steps
from fleet_tui.records.desk.desk import EVERY, LAST_CHANCE, colleagues, shown
from fleet_tui.records.desk.fact_file import FactFile
from fleet_tui.records.desk.facts import SharedCommand
from fleet_tui.records.desk.outbox import FactOutbox
from fleet_tui.records.desk.presence import PresenceReader, new_console_id
from fleet_tui.state.store import Store
from fleet_tui.storage.worker import Worker
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize

FIRST_WITHIN = 1.0
"""Seconds to wait for the first look: a folder that does not respond holds no command back."""


class DeskVisit:
    """A look at the desk every quarter of a second: its thread posts who is there and which orders the others
    remove, and shares the cancels and clears of `name`."""

    def __init__(self, folder: Path, name: str, post: Callable[[Event], object]) -> None:
        self._post = post
        self._own = new_console_id()
        self._reader = PresenceReader(folder)
        self._facts = FactFile(folder)
        self._outbox = FactOutbox(self._facts, self._own, name)
        self._has_looked = threading.Event()
        self._worker = Worker("desk", self._look, EVERY, self._end)
        self._problem = ""

    def start(self) -> str:
        """Look for the first time; return the reason that claims are not known, empty if they are."""
        self._worker.start()
        return self._problem if self._has_looked.wait(FIRST_WITHIN) else "not responding"

    def watch(self, before: FleetState, after: FleetState) -> None:
        """Share what was removed here; written later."""
        for fields in own_steps(before, after):
            self._outbox.tell(SharedCommand, **fields)

    def close(self) -> None:
        """Share what is left."""
        self._worker.close(LAST_CHANCE)

    def _end(self) -> None:
        self._look()
        self._facts.shorten(time.monotonic())
        self._facts.close()

    def _look(self) -> None:
        try:
            self._exchange()
        except OSError as problem:
            self._problem = problem.strerror or str(problem)
        finally:
            self._has_looked.set()

    def _exchange(self) -> None:
        self._outbox.send()
        self._post(ColleaguesSeen(colleagues(self._reader.look())))
        is_new = not self._facts.is_past
        for fact in self._facts.read():
            if is_new and fact.console != self._own and isinstance(fact, SharedCommand):
                self._post(elsewhere_event(fact, shown(fact.by)))


@contextmanager
def watched_desk(
    config: Config, store: Store, name: str, post: Callable[[Event], object], say: Callable[[Message], object]
) -> Iterator[None]:
    """Visit the desk of the configuration, if it has one, while this lasts. Says why claims are not known."""
    if not config.desk.folder:
        yield
        return
    folder = config.beside(config.desk.folder)
    visit = DeskVisit(folder, name, post)
    if problem := visit.start():
        say(sanitize(Message("desk: claims unknown: {folder}: {problem}", folder=folder, problem=problem)))
    store.watchers.append(visit.watch)
    try:
        yield
    finally:
        store.watchers.remove(visit.watch)
        visit.close()

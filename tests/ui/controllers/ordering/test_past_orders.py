"""Orders of earlier sessions: from the newest records of the audit log, read once and never on the loop."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.commands.language.favourites import Given
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import Audit
from fleet_tui.state.store import Store
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.controllers.ordering import past_orders
from fleet_tui.ui.controllers.ordering.past_orders import PastOrders
from tests.support.desk import Desk
from tests.support.fleets import R0, commanded, fleet, graph, labels, place_order, reduced

STORE, BACK = Given("1", "Base", "2", "Store"), Given("2", "Store", "1", "Base")
ORDER, RETURN = place_order(R0, 1, 2), place_order(R0, 2, 1)


def known() -> FleetState:
    return reduced(fleet(), graph(1, 2, 3), labels({1: "Base", 2: "Store"}))


@contextmanager
def log(folder: Path, run: str = "now", demo: bool = False) -> Iterator[Audit]:
    audit = Audit(audit_file(folder / FILE_NAME), Origin("ana", "host:1", run, demo))
    yield audit
    audit.close(known())


def wrote(folder: Path, *given: Command, run: str = "earlier", demo: bool = False) -> None:
    """A session in which these commands were sent, one after the other."""
    store = Store(known())
    with log(folder, run, demo) as audit:
        store.watchers.append(audit.watch)
        for n, command in enumerate(given):
            for fact in commanded(n, command, Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED):
                store.apply(fact)


class Background:
    """Keeps work until it is let go."""

    def __init__(self) -> None:
        self.work: list[tuple[Callable[[], object], Callable[[Any], None]]] = []

    def __call__(self, work: Callable[[], object], then: Callable[[Any], None]) -> None:
        self.work.append((work, then))

    def run(self) -> None:
        for work, then in self.work:
            then(work())


def past_orders_of(audit: Audit | None, state: FleetState) -> tuple[PastOrders, Background]:
    desk, files, background = Desk(state), ConsoleFiles(), Background()
    files.audit = audit
    desk.in_background = background
    return PastOrders(desk.console(files)), background


def read(audit: Audit | None, state: FleetState) -> list[Given]:
    past, background = past_orders_of(audit, state)
    past.read(lambda: None)
    background.run()
    return past.newest_first()


def test_orders_of_this_session_precede_those_of_earlier_ones(tmp_path: Path) -> None:
    wrote(tmp_path, ORDER)
    with log(tmp_path) as audit:
        assert read(audit, reduced(known(), *commanded(1, RETURN, Stage.SENT))) == [BACK, STORE]


def test_this_sessions_own_records_count_once(tmp_path: Path) -> None:
    wrote(tmp_path, ORDER, run="now")
    with log(tmp_path) as audit:
        assert read(audit, known()) == []


def test_the_demo_and_real_fleets_are_never_mixed(tmp_path: Path) -> None:
    wrote(tmp_path, ORDER, demo=True)
    wrote(tmp_path, RETURN)
    with log(tmp_path) as audit:
        assert read(audit, known()) == [BACK]
    with log(tmp_path, demo=True) as audit:
        assert read(audit, known()) == [STORE]


def test_orders_without_a_start_are_left_out(tmp_path: Path) -> None:
    wrote(tmp_path, place_order(R0, 2))
    with log(tmp_path) as audit:
        assert read(audit, known()) == []


def test_only_the_newest_records_are_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    wrote(tmp_path, ORDER, RETURN)
    monkeypatch.setattr(past_orders, "MOST_READ", 5)
    with log(tmp_path) as audit:
        assert read(audit, known()) == [BACK]


def test_the_log_is_read_once_and_in_the_background(tmp_path: Path) -> None:
    wrote(tmp_path, ORDER)
    with log(tmp_path) as audit:
        told = list[str]()
        past, background = past_orders_of(audit, known())
        for name in ("first", "second"):
            past.read(lambda name=name: told.append(name))  # type: ignore[misc]  # mypy knows no default of a lambda
        assert past.newest_first() == [] and len(background.work) == 1
        background.run()
        assert past.newest_first() == [STORE] and told == ["first"]


def test_without_a_log_or_with_an_unreadable_one_there_are_only_those_of_this_session(tmp_path: Path) -> None:
    assert read(None, known()) == []
    with log(tmp_path) as audit:
        audit.file.path.unlink(missing_ok=True)
        audit.file.path.mkdir()
        assert read(audit, known()) == []

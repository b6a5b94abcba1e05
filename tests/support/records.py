"""Records and logs for the tests of the journal."""

from pathlib import Path

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.audit.file import FILE_NAME, audit_file
from fleet_tui.records.audit.log import Audit
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.state.store import Store
from tests.support.fleets import (
    R0,
    T0,
    WALL,
    commanded,
    fleet,
    graph,
    labels,
    link_up,
    place_order,
    pose,
    reduced,
)

ANA = Origin("ana", "host:1", "run1")


def record(detail: str = "", **more: object) -> AuditRecord:
    fields = {"kind": "command", "what": "pause", "change": "sent", "robot": R0, "words": detail, **more}
    return ANA.record(WALL, **fields)


def known_fleet() -> FleetState:
    """A robot with two labelled vertices and one without."""
    return reduced(fleet(), link_up(T0), graph(1, 2, 3), labels({1: "Base", 3: "Store"}), pose(T0))


def watched(folder: Path, origin: Origin = ANA) -> tuple[Store, Audit]:
    """A store whose changes go to the log of a folder."""
    store, audit = Store(known_fleet()), Audit(audit_file(folder / FILE_NAME), origin)
    store.watchers.append(audit.watch)
    store.watchers.append(lambda _before, _after: _written(audit))
    return store, audit


def _written(audit: Audit) -> None:
    """Wait for all lines: a busy machine may write them later than the console waits."""
    with audit._changed:
        assert audit._changed.wait_for(lambda: audit.is_written or audit._problem, 30)


def read(folder: Path) -> list[AuditRecord]:
    """The log of a folder, the oldest record first; nothing in it may be unreadable."""
    reading = AuditReader(folder / FILE_NAME)
    found = list(reading.newest_first())[::-1]
    assert reading.unreadable == 0
    return found


ORDER = place_order(R0, 1, 2)


def give(store: Store, id_: int, command: Command, *stages: Stage, detail: str = "") -> None:
    for fact in commanded(id_, command, *stages, detail=detail):
        store.apply(fact)

"""The past of a new history: the commands, alarms and orders of the audit log."""

import sqlite3
from datetime import datetime
from itertools import islice
from pathlib import Path

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import Stage
from fleet_tui.model.history.facts import OrderChange
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.records.history.tables import ENDS, write, write_record

MOST = 200_000
"""Records that are read, the newest ones."""
STAGES = {Stage.CONFIRMED.value: "queued", **{end: end for end in ENDS}}


def rebuild(database: sqlite3.Connection, audit: Path, robots: frozenset[str], since: float) -> int:
    """Write the records of real fleets' robots since a moment; return their number. Raises OSError."""
    newest = (record for record in AuditReader(audit).newest_first() if not record.demo)
    kept = [one for one in islice(newest, MOST) if _is_ours(one, robots) and _at(one) >= since]
    for record in reversed(kept):
        write_record(database, record)
        change = order_change(record)
        if change is not None:
            write(database, change, record.run, record.operator)
    return len(kept)


def catch_up(database: sqlite3.Connection, audit: Path, robots: frozenset[str], since: float) -> None:
    """Write the steps of commands since a moment once more: a console that ended while the disk was full, or
    the file locked, could not. Raises OSError."""
    found = []
    for record in islice(AuditReader(audit).newest_first(), MOST):
        if _at(record) < since:
            break
        if record.kind == "command" and record.robot in robots and not record.demo:
            found.append(record)
    for record in reversed(found):
        write_record(database, record)


def _is_ours(record: AuditRecord, robots: frozenset[str]) -> bool:
    return record.kind in ("command", "alarm") and (not record.robot or record.robot in robots)


def _at(record: AuditRecord) -> float:
    return datetime.fromisoformat(record.time).timestamp()


def order_change(record: AuditRecord) -> OrderChange | None:
    """Return what a record tells about an order that was placed, None if nothing."""
    stage = STAGES.get(record.change)
    if stage is None or record.order is None or record.end is None:
        return None
    names = [record.start_label or record.start, record.end_label or record.end]
    way = " -> ".join(filter(None, names)) if names[0] else f"-> {names[1]}"
    words = record.words if stage in ENDS else ""
    at = _at(record)
    return OrderChange(record.robot, record.order, way, at, stage, record.floor, words, record.id)

"""The audit log for reading: a row for each record, and the details of one."""

from collections.abc import Sequence
from operator import itemgetter

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import FAILURES, Stage
from fleet_tui.records.audit.line import time_text, what_text
from fleet_tui.text.details import detail_text
from fleet_tui.text.language import N_, tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.ui.view.tables.table import Run, Table

TROUBLE = frozenset(stage.value for stage in (*FAILURES, Stage.NO_ANSWER, Stage.UNKNOWN)) | {
    "console closed",
    "lost",
}
_ROLES = {"confirmed": StyleRole.GOOD, "raised": StyleRole.WARN, "raised again": StyleRole.WARN}


def audit_table(
    records: Sequence[AuditRecord],
    note: str = "",
    empty: str = "",
    width: int = UNBOUNDED,
    arrangement: RowArrangement | None = None,
) -> Table:
    """Return records in the given sequence; `note` is beside the title, `empty` shown if there are none."""
    title = ((tr("Audit log"), StyleRole.TITLE), (f" {sanitize(note)}", StyleRole.DIM))
    entries = list(enumerate(records))
    return table_of(
        title, _COLUMNS, entries, itemgetter(0), width, arrangement=arrangement, empty=sanitize(empty)
    )


def _told(entry: tuple[int, AuditRecord]) -> list[Run]:
    _, record = entry
    role = StyleRole.ALARM if record.change in TROUBLE else _ROLES.get(record.change, StyleRole.TEXT)
    runs = [(what_text(record), StyleRole.TEXT), (f": {record.change}", role)]
    return [*runs, (detail_text(sanitize(record.words)), StyleRole.DIM)] if record.words else runs


_COLUMNS: Sequence[Column[tuple[int, AuditRecord]]] = (
    Column(
        N_("time"),
        lambda entry: (time_text(entry[1]), StyleRole.DIM),
        14,
        "",
        order=lambda entry: -entry[0],
        stays=True,
    ),
    Column(N_("operator"), lambda entry: (entry[1].operator, StyleRole.DIM), (3, 10), "", sorts=True),
    Column(N_("text"), _told, None, ""),
    Column(N_("robot"), text=lambda entry: entry[1].robot or "", sorts=True),
    Column(N_("outcome"), text=lambda entry: entry[1].change, sorts=True),
)


def details(record: AuditRecord) -> list[str]:
    """Return all fields of a record, in a few lines."""
    by = f"{record.time}  {record.operator} at {record.console}" + (", demo" if record.demo else "")
    about = [what_text(record, with_ids=True)]
    about += [f"on {record.floor}"] if record.floor else []
    about += [f"request {record.id}"] if record.id is not None else []
    about += [f"order {record.order}"] if record.order is not None and record.end is not None else []
    about += [f"{record.priority} priority", f"x{record.count}"] if record.priority else []
    about += [f"{record.link} {record.url}"] if record.url else []
    said = f"{record.change}: {record.words}" if record.words else record.change
    return [sanitize(line) for line in (by, ", ".join(about), said)]

"""The audit log on the screen: typed text filters it, Enter shows one command from the key to its end."""

from collections.abc import Callable, Iterator, Sequence
from datetime import datetime
from functools import partial
from operator import itemgetter
from typing import ClassVar

from textual import on
from textual.binding import BindingType
from textual.widgets import Input
from textual.worker import get_current_worker

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import FAILURES, Stage
from fleet_tui.records.audit.export import export
from fleet_tui.records.audit.line import time_text, what_text
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.records.audit.search import Search, search_of
from fleet_tui.text.details import detail_text
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import N_, Message, counted, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.screens.tables.paged_overlay import TableOverlay
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement, table_of
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column
from fleet_tui.ui.view.tables.table import Run, Table
from fleet_tui.ui.widgets.field import Keys
from fleet_tui.ui.widgets.messages import RowPicked

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


SHOWN = 1000
"""Number of records that are listed; a narrower search reaches the older ones."""
HOW = Message("type to filter, robot: by: outcome: since:2h  Enter steps  Ctrl-S CSV")


class AuditLog(TableOverlay):
    """Reads the files in a thread, so that large ones don't block the console. Its filter is a search in
    them."""

    BINDINGS: ClassVar[list[BindingType]] = [("escape", "close", "Close")]

    def __init__(self, files: ConsoleFiles, say: Callable[[Message], object]) -> None:
        super().__init__("audit", lambda _: self._look_closer(), 0.0, say)
        self._files = files
        self._records: list[AuditRecord] = []
        self._told = "", ""

    def field_keys(self) -> Keys:
        return {
            "escape": self.action_close,
            "enter": self._look_closer,
            "ctrl+s": self._export,
            "tab": lambda: self.screen.set_focus(self.rows),
        }

    def show(self) -> None:
        """Open on the newest records."""
        self.field.placeholder = translate(HOW)
        self.field.display = True
        self.open(self.field)
        self._find("")

    def action_filter(self) -> None:
        self.screen.set_focus(self.field)

    def _find(self, typed: str) -> None:
        """Start a search for the typed text."""
        with self.field.prevent(Input.Changed):
            self.field.value = typed
        self._search()

    def filter(self, typed: str) -> None:
        self._search()

    def _wanted(self) -> "tuple[AuditReader, Search] | None":
        """Return the log and the search, unless the typed text is no valid search."""
        audit = self._files.audit
        if audit is None:
            self._show_found([], empty=tr("no audit log on this console"))
            return None
        try:
            search = search_of(self.field.value, datetime.now().astimezone(), audit.origin.demo)
        except FleetError as problem:
            self._show_found([], empty=str(problem))
            return None
        return AuditReader(audit.file.path), search

    def _search(self) -> None:
        self.workers.cancel_group(self, "audit")  # also for a text that is no search
        wanted = self._wanted()
        if wanted is not None:
            self.run_worker(partial(self._read, *wanted), thread=True, group="audit")

    def _read(self, reading: "AuditReader", search: "Search") -> None:
        """Read the newest matching records, in a thread."""
        worker = get_current_worker()
        found: list[AuditRecord] = []
        problem = tr("no matching record")
        try:
            for record in reading.newest_first():
                if worker.is_cancelled:
                    return
                if search.wants(record):
                    found.append(record)
                    if len(found) > SHOWN:
                        break
        except OSError as failed:
            problem = tr("log not readable: {strerror}", strerror=failed.strerror)
        note = tr("newest {count}", count=SHOWN) if len(found) > SHOWN else str(len(found))
        if reading.note:
            note += f", {reading.note}"

        def show() -> None:
            if not worker.is_cancelled:  # on the screen's thread, which may have begun another search
                self._show_found(found[:SHOWN], note, problem)

        self.app.call_from_thread(show)

    def _show_found(self, records: list[AuditRecord], note: str = "", empty: str = "") -> None:
        self._records = records
        self._told = note, empty
        self.rows.listing.cursor = 0
        self.rows.listing.marks.clear()  # the keys of rows are their places
        self.look()

    def look(self) -> None:
        """Show what was found."""
        arranged = self.rows.row_width, self.rows.arrangement
        self.rows.show(audit_table(self._records, *self._told, *arranged))
        self._detail()

    @on(RowPicked)
    def _detail(self) -> None:
        place = self.rows.listing.cursor
        known = isinstance(place, int) and place < len(self._records)
        lines = details(self._records[place]) if known and isinstance(place, int) else []
        self.note("\n".join(lines))

    def _look_closer(self) -> None:
        """Show the marked command alone, with all its steps; again, all records."""
        place = self.rows.listing.cursor
        if not isinstance(place, int) or place >= len(self._records):
            return
        record = self._records[place]
        this = f"request:{record.id}" if record.id is not None else f"{record.robot} {record.what}".strip()
        self._find("" if self.field.value == this else this)

    def _export(self) -> None:
        if self._files.refusal:
            self.note(translate(self._files.refusal))
            return
        wanted = self._wanted()
        if wanted is not None:
            self.note(tr("writing ..."))
            self.run_worker(partial(self._write, *wanted), thread=True, group="audit export")

    def _write(self, reading: "AuditReader", search: "Search") -> None:
        """Write all matching records to a new file beside the log, in a thread."""
        worker = get_current_worker()

        def wanted() -> Iterator[AuditRecord]:
            for record in filter(search.wants, reading.newest_first()):
                if worker.is_cancelled:
                    raise InterruptedError
                yield record

        path = reading.path.with_name(f"audit-{datetime.now():%Y%m%d-%H%M%S}.csv")
        try:
            count = export(path, wanted())
            said = translate(
                counted(
                    "{count} record written to {path}", "{count} records written to {path}", count, path=path
                )
            )
        except InterruptedError:
            return
        except OSError as problem:
            said = tr("not written: {path}: {strerror}", path=path, strerror=problem.strerror)
        self.app.call_from_thread(self.note, said)

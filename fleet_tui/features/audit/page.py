"""The audit log on the screen: typed text filters it, Enter shows one command from the key to its end."""

from collections.abc import Callable, Iterator
from datetime import datetime
from functools import partial
from typing import ClassVar

from textual import on
from textual.binding import BindingType
from textual.widgets import Input
from textual.worker import get_current_worker

from fleet_tui.features.audit.table import audit_table, details
from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.export import export
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.records.audit.search import Search, search_of
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message, counted, tr, translate
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.screens.tables.paged_overlay import TableOverlay
from fleet_tui.ui.widgets.field import Keys
from fleet_tui.ui.widgets.messages import RowPicked

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

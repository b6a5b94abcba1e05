"""The programs of the robot servers: a list, and the log of one of them. Looks only while it is open."""

import asyncio
import time
from collections.abc import Hashable
from typing import ClassVar

from textual.binding import BindingType

from fleet_tui.config.log_file import state_folder
from fleet_tui.features.programs.requests import ProgramRequests
from fleet_tui.features.programs.table import log_table, note, program_table
from fleet_tui.programs.arguments import log
from fleet_tui.programs.log_tail import LogTail
from fleet_tui.programs.watch import ProgramWatch
from fleet_tui.text.language import translate
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.local_time import since_text
from fleet_tui.ui.screens.overlay import ReturningOverlay
from fleet_tui.ui.screens.tables.paged_overlay import TableOverlay
from fleet_tui.ui.widgets.bindings import overlay_bindings

EVERY = 0.25  # seconds between two updates


class Programs(ReturningOverlay, TableOverlay):
    """One table: the programs, or the lines of a log with a field that filters them."""

    BINDINGS: ClassVar[list[BindingType]] = [("escape,q", "back", "Back"), *overlay_bindings("programs")]

    def __init__(self, console: Console) -> None:
        super().__init__("programs", self._choose, EVERY, console.notices.say)
        self._watch = ProgramWatch(console.settings.programs, state_folder() / "programs")
        self.requests = ProgramRequests(self._watch, console)
        self._log_of = ""
        self._tail = LogTail()
        self._following: asyncio.Task[None] | None = None

    def show(self) -> None:
        """Open on the list."""
        self.leave_page()
        self._watch.open()
        self.begin(self.rows)

    def show_log(self, name: str) -> None:
        program, status = self._watch.programs[name], self._watch.rows[name].status
        has_systemd = status is None or status.has_systemd
        self._log_of = name
        self._tail = LogTail()
        self._following = asyncio.ensure_future(
            self._tail.follow(log(program, self._watch.folder, has_systemd))
        )
        self.open(self.rows)
        self.enter_page()
        self.field.begin()
        self.look()

    def leave_field(self) -> None:
        if self.is_on_page:
            self.action_back()
        else:
            super().leave_field()

    def leave_page(self) -> None:
        """Show the list again, and follow no log any more."""
        self._end_log()
        super().leave_page()

    def _end_log(self) -> None:
        if self._following is not None:
            self._following.cancel()
            self._following = None

    def _choose(self, key: Hashable) -> None:
        if isinstance(key, str):
            self.requests.menu(key, self.show_log)

    def tick(self) -> None:
        """Look at the programs only while they are shown."""
        if self.is_open:
            self._watch.open()
        else:
            self._watch.close()
            self.leave_page()
        super().tick()

    def tick_closed(self) -> bool:
        return True

    def look(self) -> None:
        """Show the current rows."""
        now = time.monotonic()
        if self.is_on_page:
            lines, said = tuple(self._tail.lines), self._tail.note
            self.rows.show(log_table(self._log_of, lines, said, self.rows.arrangement))
        else:
            rows = list(self._watch.rows.values())
            self.rows.show(program_table(rows, since_text, now, self.rows.row_width, self.rows.arrangement))
        marked = self._watch.rows.get(str(self.rows.listing.cursor))
        self.note(translate(note(marked, now)) if marked is not None else "")

    def on_unmount(self) -> None:
        """End every process that looks."""
        self._watch.close()
        self._end_log()

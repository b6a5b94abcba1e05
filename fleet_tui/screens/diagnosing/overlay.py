"""The diagnostics screen: a live version of `doctor`. It uses no resources while it is closed."""

from collections.abc import Hashable, Mapping
from typing import ClassVar

from textual import on
from textual.binding import BindingType
from textual.timer import Timer
from textual.widgets import Input

from fleet_tui.keys import DIAGNOSTICS, PAGES, Pane, by_id
from fleet_tui.rules.why.reason import Reason
from fleet_tui.screens.diagnosing.controls import DiagnosticsControls
from fleet_tui.screens.diagnosing.pages import BESIDE, FILTERED, Page, Pages
from fleet_tui.screens.tables.paged_overlay import PagedOverlay
from fleet_tui.terminal.display_driver import DisplayDriver
from fleet_tui.terminal.lean_app import LeanApp
from fleet_tui.text.language import tr
from fleet_tui.view.lines.diagnostics import foot_runs, page_runs
from fleet_tui.widgets.bindings import bindings, overlay_bindings

KEYS = by_id(DIAGNOSTICS)
EVERY = 0.25  # seconds between two updates
TWO_PAGES = 180
"""Cells of the screen from which a second page is beside the open one."""


class Diagnostics(PagedOverlay):
    """One table with the rows of the open page."""

    BINDINGS: ClassVar[list[BindingType]] = [
        *bindings(Pane.DIAGNOSTICS),
        *overlay_bindings("diagnostics"),
    ]

    def __init__(self, pages: Pages, keys: Mapping[str, tuple[str, ...]]) -> None:
        self._pages = pages
        self._keys = keys
        self._controls = DiagnosticsControls(self, pages)
        self._end: Hashable = None
        self._timer: Timer | None = None
        text = tr("filter text; Enter keeps it, Esc clears it")
        super().__init__("diagnostics", self._controls.choose, text)

    def show(self, robot: str, cause: Reason | None = None) -> None:
        """Open on the last page, first the link's, for a `cause` on the one that shows more of it; `robot` is
        the one whose topic is marked first."""
        self.open(self.rows)
        self._controls.begin(robot, None if cause is None else Page[cause.page.upper()])
        self._tick()
        if self._timer is None:
            self._timer = self.set_interval(EVERY, self._tick)

    def _tick(self) -> None:
        if self.is_open:
            self.look()
        elif self._timer is not None:
            self._timer.stop()
            self._timer = None

    def on_resize(self) -> None:
        """Fill it at its new size."""
        if self.is_open:
            self.look()

    @property
    def output(self) -> DisplayDriver:
        """The output to the terminal, for copying."""
        assert isinstance(self.app, LeanApp)
        return self.app.output

    def look(self) -> None:
        """Show the current page."""
        page, listing = self._controls.current, self.rows.listing
        self.beside.display = self.screen.size.width >= TWO_PAGES
        self._pages.width = self.rows.row_width
        table = self._pages.table(page, self.output.budget)
        keys = table.keys
        # At the end of the log, the cursor stays at the end.
        if page is Page.LOG and keys and listing.cursor in (None, self._end):
            listing.cursor = keys[-1]
        self._end = keys[-1] if keys else None
        if listing.cursor is None and keys:
            listing.cursor = keys[0]
        self.rows.show(table)
        if self.beside.display:
            self._show_beside(BESIDE[page])
        self._tabs.show(*page_runs(list(PAGES), page, self._pages.frozen(page)))
        self._foot.show(*foot_runs(self._keys, page, self._controls.notice))

    def _show_beside(self, page: Page) -> None:
        marked = self.rows.listing.cursor
        if page is Page.RAW and isinstance(marked, tuple) and marked != self._pages.topic:
            self._pages.choose(*marked)
        self._pages.width = self.beside.row_width
        self.beside.show(self._pages.table(page, self.output.budget))

    def action_key(self, id_: str) -> None:
        KEYS[id_].action(self._controls)

    def put_filter(self, text: str) -> None:
        """Filter the rows of the page, with the focus on the rows."""
        self._field.put(text)

    def open_filter(self) -> None:
        """Focus the field of the filter, on a page that has one."""
        if self._controls.current in FILTERED or self.screen.focused is self._field:
            self._field.begin()

    @on(Input.Changed, "#diagnostics-filter")
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        self._pages.wanted[self._controls.current] = event.value.strip()
        self.look()

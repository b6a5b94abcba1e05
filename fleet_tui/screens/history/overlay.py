"""The history: events, what robots did, batteries, alarms and blocked places of a time."""

from functools import partial
from typing import TYPE_CHECKING, ClassVar

from textual import on
from textual.app import SuspendNotSupported
from textual.binding import BindingType
from textual.timer import Timer
from textual.widgets import Input

from fleet_tui.controllers.history.controls import HistoryControls, words_of
from fleet_tui.controllers.history.replaying import PastReplay, run_in_terminal
from fleet_tui.keys import HISTORY, Pane, by_id
from fleet_tui.log_file import state_folder
from fleet_tui.screens.history.pages import HistoryPages, long_moment
from fleet_tui.screens.tables.paged_overlay import PagedOverlay
from fleet_tui.text.language import tr
from fleet_tui.view.history.tables import NAMES
from fleet_tui.view.lines.history import foot_runs, page_runs
from fleet_tui.view.tables.table import column
from fleet_tui.widgets.background import run_in_background
from fleet_tui.widgets.bindings import bindings, overlay_bindings

if TYPE_CHECKING:
    from collections.abc import Sequence

    from fleet_tui.screens.main import MainScreen
    from fleet_tui.screens.rest import Rest

KEYS = by_id(HISTORY)
EVERY = 5.0
"""Seconds between two looks into a history that goes on."""
FIGURES = {"Robots": 1, "Batteries": 28, "Alarms": 32}
"""Cells of a row beside a picture and the name of a robot."""


def history_overlay(screen: "MainScreen", rest: "Rest") -> "HistoryOverlay":
    options = lambda: rest.map.picture.options  # noqa: E731  # a name for a value that changes
    pages = HistoryPages(screen.store, screen.settings.clock, screen.navigation, options)

    def run(command: "Sequence[str]") -> str:
        try:
            with screen.app.suspend():
                return run_in_terminal(command)
        except SuspendNotSupported:
            return tr("this terminal can't be given to a recording: open it in another one")

    replaying = PastReplay(screen.files, state_folder(), lambda: _loss(rest), run)
    return HistoryOverlay(screen, pages, replaying)


def _loss(rest: "Rest") -> str:
    """Return the reason why this console can't be left alone, empty if it can."""
    if rest.drives.mode is not None:
        return tr("a robot is driven by hand")
    return tr("a routine runs here") if rest.routines.has_losses else ""


class HistoryOverlay(PagedOverlay):
    """One table with the rows of the open page. It reads nothing while it is closed."""

    BINDINGS: ClassVar[list[BindingType]] = [
        *bindings(Pane.HISTORY),
        *overlay_bindings("history"),
    ]

    def __init__(self, screen: "MainScreen", pages: HistoryPages, replaying: PastReplay) -> None:
        self._pages = pages
        self._store = screen.store
        self._keys = screen.settings.keys
        low = lambda: screen.store.state.limits.battery_low  # noqa: E731  # of the newest state
        in_background = partial(run_in_background, self)
        self._controls = HistoryControls(self, screen.files, replaying, in_background, low)
        self._timer: Timer | None = None
        words = tr("words, !word; Enter keeps them, Esc clears them")
        super().__init__("history", self._controls.choose, words)

    def show(self) -> None:
        """Open on the page that was open last."""
        self.open(self.rows)
        self._controls.page(self._controls.page_number)
        if self._timer is None:
            self._timer = self.set_interval(EVERY, self._tick)

    def _tick(self) -> None:
        if not self.is_open and self._timer is not None:
            self._timer.stop()
            self._timer = None
        elif not self._controls.until and not self._controls.is_reading:
            self._controls.read()

    def on_resize(self) -> None:
        """Read it for its new size."""
        if self.is_open:
            self._controls.read()
            self.look()

    @property
    def parts(self) -> int:
        """Return the cells of a picture in a row, beside names and figures."""
        names = column(self._store.state.robots, at_most=NAMES)
        return self.rows.row_width - names - FIGURES.get(self._controls.name, 0)

    def look(self) -> None:
        """Show what was read."""
        controls = self._controls
        size = self.rows.row_width, max(1, self.rows.size.height - 1)
        self.rows.show(self._pages.table(controls, words_of(self._field.value), size))
        until = long_moment(controls.until) if controls.until else tr("now")
        self._tabs.show(*page_runs(controls.page_number, controls.span, until, self._tabs.size.width))
        self._foot.show(*foot_runs(self._keys, controls.name, controls.notice))

    def action_key(self, id_: str) -> None:
        KEYS[id_].action(self._controls)

    def open_filter(self) -> None:
        """Focus the field of the filter."""
        self._field.begin()

    def put_filter(self, text: str) -> None:
        """Filter by a text, with the focus on the rows."""
        self._field.put(text)

    def back(self) -> None:
        """Clear the filter, or close."""
        if self._field.value:
            self._field.leave(clear=True)
            self.look()
        else:
            self.action_close()

    @on(Input.Changed, "#history-filter")
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        self.look()

"""The history: events, what robots did, batteries, alarms and blocked places of a time."""

from collections.abc import Callable, Sequence
from datetime import datetime
from typing import ClassVar

from msgspec.structs import replace
from textual.app import SuspendNotSupported
from textual.binding import BindingType

from fleet_tui.config.log_file import state_folder
from fleet_tui.features.history.controls import HistoryControls
from fleet_tui.features.history.places import heat_rows, places_table
from fleet_tui.features.history.replaying import PastReplay, run_in_terminal
from fleet_tui.features.history.tables import (
    NAMES,
    alarms_table,
    batteries_table,
    curve_of,
    events_table,
    robots_table,
)
from fleet_tui.keys import Pane
from fleet_tui.records.history.division import Division
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.screens.tables.paged_overlay import PagedOverlay
from fleet_tui.ui.view.lines.history import foot_runs, page_runs
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.table import Row, Table, column
from fleet_tui.ui.widgets.bindings import bindings, overlay_bindings

EVERY = 5.0
"""Seconds between two looks into a history that goes on."""
FIGURES = {"Robots": 1, "Batteries": 28, "Alarms": 32}
"""Cells of a row beside a picture and the name of a robot."""


SAME_DAY = 20 * 3600.0
"""Seconds of a time up to which its moments need no date."""


class HistoryPages:
    """Makes the table of the open page."""

    def __init__(self, console: Console, options: Callable[[], MapOptions]) -> None:
        self._store = console.store
        self._clock = console.settings.clock
        self._navigation = console.navigation
        self._options = options

    def table(self, controls: HistoryControls, arrangement: RowArrangement, size: tuple[int, int]) -> Table:
        """Return the open page as arranged, for `size` cells and lines."""
        shown, is_ascii = controls.shown, self._options().drawing is Drawing.ASCII
        mark = self._mark(shown.time)
        match controls.name:
            case "Events":
                return events_table(shown, self._moment(shown.time), arrangement)
            case "Robots":
                return robots_table(shown, mark, is_ascii, arrangement)
            case "Batteries" if controls.chart:
                return self._chart(controls, size)
            case "Batteries":
                low = self._store.state.limits.battery_low
                return batteries_table(shown, mark, is_ascii, low, arrangement)
            case "Alarms":
                return alarms_table(shown, mark, is_ascii, arrangement)
        return self._places(controls, size, is_ascii)

    def _chart(self, controls: HistoryControls, size: tuple[int, int]) -> Table:
        """Return the curve of one robot; what draws it was imported when the page was read."""
        from fleet_tui.ui.view.robot.chart import battery_chart

        shown, robot = controls.shown, controls.chart
        low, until = self._store.state.limits.battery_low, shown.time.until
        charges, drawing = shown.charges.get(robot, ()), self._options().drawing
        samples = curve_of(charges, shown.time)
        lines = battery_chart(samples, (until, until), size, low, self._clock, drawing) if samples else ()
        title = (
            (tr("Battery of {robot}", robot=sanitize(robot)), StyleRole.TITLE),
            (tr("  Esc: all robots"), StyleRole.DIM),
        )
        return Table(title, [Row(None, tuple(line)) for line in lines], tr("no level in this time"))

    def _places(self, controls: HistoryControls, size: tuple[int, int], is_ascii: bool) -> Table:
        places = controls.shown.places
        floors = list(
            dict.fromkeys(place.floor for place in places if place.floor in self._store.state.floors)
        )
        selection = self._navigation.selection
        if floors:
            selection = replace(selection, floor=floors[controls.floor % len(floors)])
        rows = heat_rows(self._store.state, selection, places, self._options(), size, is_ascii)
        empty = translate(sanitize(controls.shown.problem)) or tr("no robot was blocked in this time")
        return places_table(rows if floors else [], selection, places, empty)

    def _moment(self, time: Division) -> Callable[[float], str]:
        return self._clock if time.until - time.since <= SAME_DAY else long_moment

    def _mark(self, time: Division) -> Callable[[float], str]:
        if time.until - time.since > 2 * SAME_DAY:
            return lambda at: f"{datetime.fromtimestamp(at).astimezone():%d %b}"
        return lambda at: self._clock(at)[:5]


def long_moment(at: float) -> str:
    """Return a local time with its date."""
    return f"{datetime.fromtimestamp(at).astimezone():%m-%d %H:%M:%S}"


class HistoryOverlay(PagedOverlay):
    """One table with the rows of the open page. It reads nothing while it is closed."""

    BINDINGS: ClassVar[list[BindingType]] = [*bindings(Pane.HISTORY), *overlay_bindings("history")]

    def __init__(
        self, console: Console, options: Callable[[], MapOptions], loss: Callable[[], Message]
    ) -> None:
        """`loss` returns the reason why this console can't be left alone for a replay, empty if it can."""
        self._pages = HistoryPages(console, options)
        self._store = console.store
        self._keys = console.settings.keys
        replaying = PastReplay(console, state_folder(), loss, self._run)
        self._controls = HistoryControls(self, console, replaying)
        self.actions = self._controls.actions
        super().__init__("history", self._controls.choose, EVERY, self._answer)

    def _run(self, command: Sequence[str]) -> Message:
        try:
            with self.app.suspend():
                return run_in_terminal(command)
        except SuspendNotSupported:
            return Message("a recording can't use this terminal: open it in another one")

    def show(self) -> None:
        """Open on the page that was open last."""
        self.begin(self.rows)
        self._controls.page(self._controls.page_number)

    def tick(self) -> None:
        """Read a history that goes on."""
        if not self.is_open:
            super().tick()
        elif not self._controls.until and not self._controls.is_reading:
            self._controls.read()

    def on_resize(self) -> None:
        """Read it for its new size."""
        if self.is_open:
            self._controls.read()
        super().on_resize()

    @property
    def parts(self) -> int:
        """Return the cells of a picture in a row, beside names and figures."""
        names = column(self._store.state.robots, at_most=NAMES)
        return self.rows.row_width - names - FIGURES.get(self._controls.name, 0)

    def look(self) -> None:
        """Show what was read."""
        controls = self._controls
        size = self.rows.row_width, max(1, self.rows.size.height - 1)
        self.rows.show(self._pages.table(controls, self.rows.arrangement, size))
        until = long_moment(controls.until) if controls.until else tr("now")
        self._tabs.show(*page_runs(controls.page_number, controls.span, until, self._tabs.size.width))
        self._foot.show(*foot_runs(self._keys, controls.name, controls.notice))

    def action_key(self, id_: str) -> None:
        self.actions[id_]()

    def _answer(self, text: Message) -> None:
        self._controls.notice = text
        self.look()

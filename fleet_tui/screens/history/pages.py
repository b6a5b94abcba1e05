"""The tables of the history's pages, at the size of the screen."""

from collections.abc import Callable, Sequence
from datetime import datetime

from msgspec.structs import replace

from fleet_tui.controllers.history.controls import HistoryControls
from fleet_tui.controllers.navigation import Navigation
from fleet_tui.rules.history.division import Division
from fleet_tui.state.store import Store
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.history.places import heat_rows, places_table
from fleet_tui.view.history.tables import (
    alarms_table,
    batteries_table,
    curve_of,
    events_table,
    robots_table,
)
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Row, Table

SAME_DAY = 20 * 3600.0
"""Seconds of a time up to which its moments need no date."""


class HistoryPages:
    """Makes the table of the open page; `clock` formats Unix seconds as a time of day."""

    def __init__(
        self,
        store: Store,
        clock: Callable[[float], str],
        navigation: Navigation,
        options: Callable[[], MapOptions],
    ) -> None:
        self._store = store
        self._clock = clock
        self._navigation = navigation
        self._options = options

    def table(self, controls: HistoryControls, words: Sequence[str], size: tuple[int, int]) -> Table:
        """Return the open page with rows that have every word, for `size` cells and lines."""
        shown, is_ascii = controls.shown, self._options().drawing is Drawing.ASCII
        mark = self._mark(shown.time)
        match controls.name:
            case "Events":
                return events_table(shown, words, self._moment(shown.time))
            case "Robots":
                return robots_table(shown, words, mark, is_ascii)
            case "Batteries" if controls.chart:
                return self._chart(controls, size)
            case "Batteries":
                low = self._store.state.limits.battery_low
                return batteries_table(shown, words, mark, is_ascii, low)
            case "Alarms":
                return alarms_table(shown, words, mark, is_ascii)
        return self._places(controls, size, is_ascii)

    def _chart(self, controls: HistoryControls, size: tuple[int, int]) -> Table:
        """Return the curve of one robot; what draws it was imported when the page was read."""
        from fleet_tui.view.robot.chart import battery_chart

        shown, robot = controls.shown, controls.chart
        low, until = self._store.state.limits.battery_low, shown.time.until
        charges, drawing = shown.charges.get(robot, ()), self._options().drawing
        samples = curve_of(charges, shown.time)
        lines = battery_chart(samples, (until, until), size, low, self._clock, drawing) if samples else ()
        title = (
            (tr(f"Battery of {sanitize(robot)}"), StyleRole.TITLE),
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
        empty = controls.shown.problem or tr("no robot was blocked in this time")
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

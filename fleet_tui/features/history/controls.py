"""Actions in the history: its page, its time, its filter, the way into a recording."""

import sqlite3
import time
from collections.abc import Callable, Hashable, Mapping
from functools import partial
from pathlib import Path
from typing import Protocol

from msgspec.structs import replace

from fleet_tui.features.history.events import past_events
from fleet_tui.features.history.replaying import PastReplay
from fleet_tui.features.history.shift import ShownShift
from fleet_tui.features.history.tables import moment_of
from fleet_tui.keys import HISTORY_PAGES
from fleet_tui.model.history.totals import ChargeTotal
from fleet_tui.model.order import natural
from fleet_tui.records.history.database import is_empty, opened_to_read
from fleet_tui.records.history.division import Division, divided
from fleet_tui.records.history.reading import History
from fleet_tui.records.history.timeline import main_activities
from fleet_tui.records.history.totals import Totals
from fleet_tui.situation.battery.forecast import WINDOW, BatteryForecast, forecast
from fleet_tui.situation.battery.history import BatterySample
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.widgets.rows_pane import RowsPane

HOUR = 3600.0
SPANS = {
    "15 min": HOUR / 4,
    "1 h": HOUR,
    "8 h": 8 * HOUR,
    "24 h": 24 * HOUR,
    "7 d": 168 * HOUR,
    "30 d": 720 * HOUR,
}
"""Times that are shown, in seconds."""
USUAL = "8 h"
NEARLY = 0.05
"""Part of a time: one that ends so shortly ago goes on up to now."""
NAMES = tuple(HISTORY_PAGES)
"""Pages in the order of their numbers."""
NO_HISTORY = Message("this console keeps no history: set days in [history]")


MOST = 2000
"""Events of each kind at most, the newest."""


class HistoryView(Protocol):
    """The overlay, as its controls see it."""

    rows: RowsPane
    """The rows of the open page."""

    @property
    def parts(self) -> int:
        """Return the cells of a picture in a row."""

    def look(self) -> None:
        """Show what was read."""

    def action_filter(self) -> None:
        """Focus the field."""

    def put_filter(self, text: str) -> None:
        """Filter by a text, with the focus on the rows."""

    def action_back(self) -> None:
        """Clear the filter, or close."""


class HistoryControls:
    """`page_number` is that of the open page, `shown` what was read for it, `chart` the robot whose curve is
    shown alone, `notice` the response to the last key. The time of `span` ends now unless `until` says
    when."""

    def __init__(self, view: HistoryView, console: Console, replaying: PastReplay) -> None:
        self._view = view
        self._files = console.files
        self._replaying = replaying
        self._in_background = console.in_background
        self._store = console.store
        self.page_number = 1
        self.until = 0.0
        self.chart = ""
        self.span = ""  # until the first look: as long as the history, at most the usual one
        self.shown = ShownShift(divided(0.0, HOUR, 1))
        self.floor = 0
        self.notice = EMPTY
        self.is_reading = False
        self._wanted = 0
        self.actions: dict[str, Callable[[], None]] = {
            **{f"history_{name.lower()}": partial(self.page, n) for n, name in enumerate(HISTORY_PAGES, 1)},
            "history_next_page": partial(self.step_page, 1),
            "history_previous_page": partial(self.step_page, -1),
            "history_filter": self.filter,
            "history_earlier": partial(self.shift, -1),
            "history_later": partial(self.shift, 1),
            "history_longer": partial(self.stretch, 1),
            "history_shorter": partial(self.stretch, -1),
            "history_floor": self.next_floor,
            "history_replay": self.replay,
            "history_leave": self.leave,
        }

    @property
    def name(self) -> str:
        """Return the name of the open page."""
        return NAMES[self.page_number - 1]

    def read(self) -> None:
        """Read the page for the current time; what is shown stays until then."""
        until = self.until or time.time()
        division = divided(until - SPANS[self.span or USUAL], until, max(10, self._view.parts))
        history = self._files.history
        self._wanted += 1
        if history is None:
            self._take(self._wanted, ShownShift(division, problem=NO_HISTORY))
            return
        self.is_reading = True
        work = partial(read_page, history.path, self.name, division, self._store.state.limits.battery_low)
        self._in_background(work, partial(self._take, self._wanted))

    def _take(self, wanted: int, shown: ShownShift) -> None:
        if wanted != self._wanted:
            return
        self.shown = shown
        self.is_reading = False
        if not self.span:
            age = shown.time.until - (shown.begun or 0.0)
            self.span = next((name for name, seconds in SPANS.items() if seconds >= age), USUAL)
            if SPANS[self.span] > SPANS[USUAL]:
                self.span = USUAL
            if self.span != USUAL:
                self.read()
        self._view.look()

    def page(self, number: int) -> None:
        self.page_number = number
        self.notice = EMPTY
        self.chart = ""
        self.shown = ShownShift(self.shown.time, problem=Message("reading ..."))
        self._read_and_look()

    def step_page(self, step: int) -> None:
        """Show the next (1) or previous (-1) page."""
        self.page((self.page_number - 1 + step) % len(NAMES) + 1)

    def filter(self) -> None:
        """Open the field for the filter."""
        self._view.action_filter()

    def shift(self, step: int) -> None:
        """Show a later (1) or an earlier (-1) time, at last one that goes on."""
        span, now = SPANS[self.span or USUAL], time.time()
        until = (self.until or now) + step * span / 2
        self.until = 0.0 if until >= now - span * NEARLY else until
        self._read_and_look()

    def stretch(self, step: int) -> None:
        """Show a longer (1) or a shorter (-1) time up to the same end."""
        names = list(SPANS)
        self.span = names[min(len(names) - 1, max(0, names.index(self.span or USUAL) + step))]
        self._read_and_look()

    def _read_and_look(self) -> None:
        self.read()
        self._view.look()  # the title says at once for which time the rows are awaited

    def next_floor(self) -> None:
        """Show the places of the next floor."""
        self.floor += 1
        self._view.look()

    def choose(self, key: Hashable) -> None:
        """Open what a row is about: a robot's curve, its events, or the recording of a moment."""
        if not isinstance(key, str):
            self.replay()
        elif self.name == "Batteries":
            self.chart = key
            self._view.look()
        else:
            self._view.put_filter(key)
            self.page(1)

    def replay(self) -> None:
        """Open the recording at the time of the marked row; of one without at the end of the time shown."""
        moment = moment_of(self._view.rows.listing.cursor)
        at = moment[1] if moment is not None else self.shown.time.until
        self._in_background(partial(self._replaying.find, at), partial(self._open, at))

    def _open(self, at: float, found: tuple[Path, float] | None) -> None:
        self.notice = self._replaying.open(found, at)
        self._view.look()

    def leave(self) -> None:
        """Go back one level: from a curve to all, then clear the filter, then close."""
        if self.chart:
            self.chart = ""
            self._view.look()
        else:
            self._view.action_back()


def read_page(path: Path, name: str, time: Division, battery_low: float) -> ShownShift:
    """Return what the page of this name shows of a time; `battery_low` is the limit in per cent."""
    shown = ShownShift(time)
    try:
        with opened_to_read(path) as database:
            if is_empty(database):
                return replace(shown, problem=Message("nothing recorded yet"))
            history = History(database, MOST)
            shown = replace(shown, begun=history.begun())
            return PAGES[name](history, Totals(database), shown, battery_low)
    except sqlite3.Error as problem:
        return replace(shown, problem=Message("the history can't be read: {problem}", problem=problem))


def _events(history: History, _totals: Totals, shown: ShownShift, _low: float) -> ShownShift:
    time = shown.time.since, shown.time.until
    events = past_events(
        history.orders(*time),
        history.alarms(*time),
        history.commands(*time),
        history.links(*time),
        history.notes(*time),
    )
    return replace(shown, events=events)


def _robots(_history: History, totals: Totals, shown: ShownShift, _low: float) -> ShownShift:
    activities = totals.activities(shown.time)
    names = sorted({one.robot for one in activities}, key=natural)
    return replace(shown, timeline=main_activities(names, shown.time, activities))


def _batteries(history: History, totals: Totals, shown: ShownShift, low: float) -> ShownShift:
    import fleet_tui.ui.view.robot.chart  # noqa: F401  # takes a tenth of a second

    charges: dict[str, list[ChargeTotal]] = {}
    for one in totals.charges(shown.time):
        charges.setdefault(one.robot, []).append(one)
    found = {name: charges[name] for name in sorted(charges, key=natural)}
    return replace(shown, charges=found, forecasts=_forecasts(history, found, shown.time.until, low))


def _forecasts(
    history: History, robots: Mapping[str, object], until: float, low: float
) -> Mapping[str, BatteryForecast]:
    found = {}
    for robot in robots:
        charges = history.charges(robot, until - WINDOW, until)
        guess = forecast([BatterySample(one.at, one.percent, True) for one in charges], low, until)
        if guess is not None:
            found[robot] = guess
    return found


def _alarms(history: History, _totals: Totals, shown: ShownShift, _low: float) -> ShownShift:
    return replace(shown, alarms=history.alarms(shown.time.since, shown.time.until))


def _places(_history: History, totals: Totals, shown: ShownShift, _low: float) -> ShownShift:
    return replace(shown, places=totals.blocked(shown.time.since, shown.time.until))


PAGES: Mapping[str, Callable[[History, Totals, ShownShift, float], ShownShift]] = {
    "Events": _events,
    "Robots": _robots,
    "Batteries": _batteries,
    "Alarms": _alarms,
    "Places": _places,
}

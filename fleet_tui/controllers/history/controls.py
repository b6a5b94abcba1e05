"""Actions in the history: its page, its time, its filter, the way into a recording."""

import time
from collections.abc import Callable, Hashable, Sequence
from functools import partial
from pathlib import Path
from typing import Protocol

from fleet_tui.controllers.files import ConsoleFiles
from fleet_tui.controllers.history.reading import read_page
from fleet_tui.controllers.history.replaying import PastReplay
from fleet_tui.controllers.parts import InBackground
from fleet_tui.keys import HISTORY_PAGES
from fleet_tui.rules.history.division import divided
from fleet_tui.view.history.shift import ShownShift
from fleet_tui.view.history.tables import moment_of
from fleet_tui.widgets.rows_pane import RowsPane

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
NO_HISTORY = "this console keeps no history: set days in [history]"


class HistoryView(Protocol):
    """The overlay, as its controls see it."""

    rows: RowsPane
    """The rows of the open page."""

    @property
    def parts(self) -> int:
        """Return the cells of a picture in a row."""

    def look(self) -> None:
        """Show what was read."""

    def open_filter(self) -> None:
        """Focus the field."""

    def put_filter(self, text: str) -> None:
        """Filter by a text, with the focus on the rows."""

    def back(self) -> None:
        """Clear the filter, or close."""


class HistoryControls:
    """`page_number` is that of the open page, `shown` what was read for it, `chart` the robot whose curve is
    shown alone, `notice` the response to the last key. The time of `span` ends now unless `until` says
    when."""

    def __init__(
        self,
        view: HistoryView,
        files: ConsoleFiles,
        replaying: PastReplay,
        in_background: InBackground,
        battery_low: Callable[[], float],
    ) -> None:
        self._view = view
        self._files = files
        self._replaying = replaying
        self._in_background = in_background
        self._battery_low = battery_low
        self.page_number = 1
        self.until = 0.0
        self.chart = ""
        self.span = ""  # until the first look: as long as the history, at most the usual one
        self.shown = ShownShift(divided(0.0, HOUR, 1))
        self.floor = 0
        self.notice = ""
        self.is_reading = False
        self._wanted = 0

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
        work = partial(read_page, history.path, self.name, division, self._battery_low())
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
        self.notice = ""
        self.chart = ""
        self.shown = ShownShift(self.shown.time, problem="reading ...")
        self._read_and_look()

    def step_page(self, step: int) -> None:
        """Show the next (1) or previous (-1) page."""
        self.page((self.page_number - 1 + step) % len(NAMES) + 1)

    def filter(self) -> None:
        """Open the field for the filter."""
        self._view.open_filter()

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
            self._view.back()


def words_of(typed: str) -> Sequence[str]:
    return [word.casefold() for word in typed.split()]

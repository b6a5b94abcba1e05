"""Differences between a live fleet and a recording, as needed by the screen."""

import time
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Protocol

from fleet_tui.keys import Key, Pane
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.problem import Right
from fleet_tui.text.language import translate
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.view.lines.status import PAUSED, console_notes, resume_all, status_line, status_right
from fleet_tui.ui.view.tables.table import Run, cut, width_of

if TYPE_CHECKING:
    from fleet_tui.ui.controllers.typed import Typed
    from fleet_tui.ui.widgets.time_line import TimeLine

Headline = tuple[tuple[Run, ...], tuple[Run, ...]]
"""The line that is always visible: its left and its right end."""


class ConsoleSession(Protocol):
    """A console on a live fleet or on a recording."""

    panes: tuple[Pane, ...]
    """The panes whose keys work everywhere."""
    pane: Pane | None
    """The pane whose keys are listed first, None for the one with the focus."""

    def offers(self, key: Key) -> bool:
        """Tell whether a key has a use."""

    def headline(self, state: FleetState, robot: str, width: int) -> Headline:
        """Return the line that is always visible; of `width` cells, as far as it can."""

    def time_line(self) -> "TimeLine | None":
        """Return the widget of the position in a recording."""

    @property
    def actions(self) -> Mapping[str, Callable[[], object]]:
        """Return the actions of the keys of a recording's player."""

    def typed(self, line: str) -> "Typed | None":
        """Parse a typed line as a time to go to, None if it is not one."""

    def pick_time(self, x: int, width: int) -> None:
        """Go to the time of cell `x` of a time line `width` cells wide."""


OpenSession = Callable[[Console, Callable[[], bool]], ConsoleSession]
"""From a console, and what clears the trails of its map, or returns False while there is no map."""


class LiveSession:
    """A console on the live fleet: the keys of recordings are disabled."""

    panes: tuple[Pane, ...] = (Pane.CONSOLE,)
    pane: Pane | None = None

    def __init__(self, console: Console, _forget_trails: Callable[[], bool]) -> None:
        self._console = console

    def offers(self, key: Key) -> bool:
        """Leave out the keys of recordings."""
        return key.pane is not Pane.RECORDING

    def headline(self, state: FleetState, robot: str, width: int) -> Headline:
        """Return the state of this console and of the link, and the console in command."""
        may, files = self._console.dispatch.permissions, self._console.files
        settings = self._console.settings
        kept = list(map(translate, files.notes()))
        notes = console_notes(state, may.read_only, may.armed, time.monotonic() - state.now)
        runs = status_line(state, robot, notes, kept=kept, width=width)
        if may.armed and not may.read_only and may.right >= Right.DISPATCH:
            way_back = f", {resume_all(settings.keys)}"
            notes = [note + way_back * note.endswith(translate(PAUSED)) for note in notes]
            longer = status_line(state, robot, notes, kept=kept)
            runs = longer if width_of(longer) <= width else runs
        right = status_right(settings.clock(state.wall), files.operator)
        if any(link.phase is not Phase.UP for link in state.links.values()):
            # Without a link the time tells that this console lives; the alarm has the whole reason.
            runs = cut(runs, max(0, width - width_of(right[-1:]) - 1))
        return runs, right

    def time_line(self) -> None:
        """Return no time line."""

    actions: Mapping[str, Callable[[], object]] = {}  # there is no player

    def typed(self, line: str) -> None:
        """Parse no line as a time."""

    def pick_time(self, x: int, width: int) -> None:
        """Do nothing: there is no time line."""

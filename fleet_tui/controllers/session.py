"""Differences between a live fleet and a recording of one, as the screen sees them."""

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol

from fleet_tui.actions import PlayerActions
from fleet_tui.controllers.dispatch import Dispatch
from fleet_tui.controllers.files import ConsoleFiles
from fleet_tui.keys import Key, Pane
from fleet_tui.model.fleet import FleetState
from fleet_tui.view.lines.status import console_notes, status_line, status_right
from fleet_tui.view.tables.table import Run

if TYPE_CHECKING:
    from fleet_tui.controllers.typed import Typed
    from fleet_tui.widgets.time_line import TimeLine

Headline = tuple[tuple[Run, ...], tuple[Run, ...]]
"""The line that is always in view: its left and its right end."""


class ConsoleSession(Protocol):
    """A console on a live fleet or on a recording."""

    panes: tuple[Pane, ...]
    """The panes of keys that work everywhere."""
    pane: Pane | None
    """The pane whose keys come first, None for the one with the focus."""

    def offers(self, key: Key[Any]) -> bool:
        """Tell whether a key means anything."""

    def headline(self, state: FleetState, robot: str) -> Headline:
        """Return the line that is always in view."""

    def time_line(self) -> "TimeLine | None":
        """Make the widget that shows where in a recording this is."""

    def play(self, do: Callable[[PlayerActions], object]) -> None:
        """Have the player of a recording do something; say why it does not."""

    def typed(self, line: str) -> "Typed | None":
        """Read a typed line as a time to go to, None where it is none."""

    def pick_time(self, x: int, width: int) -> None:
        """Go to the time of cell `x` of a time line `width` cells wide."""


class LiveSession:
    """A console on the fleet itself: no key of a recording means anything."""

    panes: tuple[Pane, ...] = (Pane.CONSOLE,)
    pane: Pane | None = None

    def __init__(self, dispatch: Dispatch, files: ConsoleFiles, clock: Callable[[float], str]) -> None:
        self._dispatch, self._files, self._clock = dispatch, files, clock

    def offers(self, key: Key[Any]) -> bool:
        """Leave out the keys of recordings."""
        return key.pane is not Pane.RECORDING

    def headline(self, state: FleetState, robot: str) -> Headline:
        """Show what holds for this console, the link, and who commands."""
        may = self._dispatch.permissions
        notes = console_notes(state, may.read_only, may.armed, time.monotonic() - state.now)
        runs = status_line(state, robot, [*notes, *self._files.notes()])
        return runs, status_right(self._clock(state.wall), self._files.operator)

    def time_line(self) -> None:
        """Show no time line."""

    def play(self, do: Callable[[PlayerActions], object]) -> None:
        """Do nothing: there is no player."""

    def typed(self, line: str) -> None:
        """Read no line as a time."""

    def pick_time(self, x: int, width: int) -> None:
        """Do nothing: there is no time line."""

"""The Textual app before the console: a person chooses the fleet to open. It sends no commands."""

import asyncio
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import ClassVar, Literal

from rich.style import Style
from textual.binding import BindingType
from textual.screen import Screen
from textual.theme import Theme

from fleet_tui.console.first_run import LOCAL, FirstRun
from fleet_tui.links.discovery.choices import Choice
from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.ui.screens.opening import RowsScreen
from fleet_tui.ui.terminal.ending import leave_on_signals, terminal_restorer
from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.themes import FleetTheme
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.opening import Line, Rows, arrival_rows

KEYS = (("enter", "open"), ("up/down", "line"), ("left/right", "choose"), ("q", "quit"))
NONE = {"floor": "any floor", "frame": "no floor"}
"""Text of an empty option."""


class Arrival(RowsScreen):
    """Every choice is preset to the best guess: Enter opens."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("enter", "open", "Open the console"),
        ("up,k", "move(-1)", "Move up one line"),
        ("down,j", "move(1)", "Move down one line"),
        ("left,h", "choose(-1)", "Choose the previous option"),
        ("right,l,space", "choose(1)", "Choose the next option"),
        ("q,escape", "leave", "Quit"),
    ]

    def __init__(
        self,
        styles: Mapping[StyleRole, Style],
        site: DiscoveredSite,
        done: Callable[[DiscoveredSite | None], None],
    ) -> None:
        super().__init__(styles, KEYS)
        self._site = site
        self._done = done
        self._cursor = 0

    def rows(self, width: int, height: int) -> Rows:
        """Return the findings and the choices."""
        site = self._site
        summary = f"{site.bridge.shown}: {site.summary}"
        lines = [_line(choice) for choice in site.choices]
        return arrival_rows(summary, lines, site.lacks, self._cursor, width, height)

    def action_move(self, step: int) -> None:
        """Move to another line."""
        self._cursor = max(0, min(len(self._site.choices) - 1, self._cursor + step))
        self.show()

    def action_choose(self, step: int) -> None:
        """Select another option of the line."""
        choices = self._site.choices
        if choices:
            choice = choices[self._cursor]
            options = _options(choice)
            chosen = options[(options.index(choice.chosen) + step) % len(options)]
            self._site = replace(self._site, answers={**self._site.answers, choice.id: chosen})
            # Another kind may have fewer choices.
            self.action_move(0)

    def action_open(self) -> None:
        """Open the console with the current choices."""
        self._done(self._site)

    def action_leave(self) -> None:
        """Leave without opening a console."""
        self._done(None)


def _options(choice: Choice) -> list[str]:
    """Return every choice; none if there is no address or a better one was found."""
    is_open = choice.id[0] in NONE or not choice.chosen
    return [*([""] if is_open else []), *choice.options]


def _line(choice: Choice) -> Line:
    number = choice.options.index(choice.chosen) + 1 if choice.chosen else 0
    return Line(choice.text, choice.chosen or NONE.get(choice.id[0], "none"), number, len(choice.options))


Chosen = DiscoveredSite | Literal["demo"] | None
"""The site to open the console on, or a simulated fleet, or None: the operator left."""


class EntryApp(LeanApp, inherit_bindings=False):
    """Begins with the uncertain settings of `site`, or without one with the robots at an address. `places`:
    the searched paths of a configuration, each with its state."""

    TITLE = "fleet-tui"
    BINDINGS: ClassVar[list[BindingType]] = [("ctrl+c", "nothing", "")]
    ENABLE_COMMAND_PALETTE = False

    def __init__(
        self,
        theme: FleetTheme,
        colour: bool,
        site: DiscoveredSite | None = None,
        places: Sequence[tuple[str, str]] = (),
        address: str = LOCAL,
    ) -> None:
        # Without colour Textual must use the terminal's own, or it sends greys.
        super().__init__(ansi_color=not colour)
        self.register_theme(Theme(**theme.textual()))
        self.theme = f"fleet-{theme.name}"
        self._roles = theme.styles(colour)
        self._start = site
        self._places = places
        self._address = address
        self._restore = terminal_restorer()
        self.chosen: Chosen = None

    def get_default_screen(self) -> Screen[None]:
        """Return the choices of a known site, else the first-run screen."""
        if self._start is not None:
            return Arrival(self._roles, self._start, self._end)
        return FirstRun(self._roles, self._places, self.found, self._address)

    def on_ready(self) -> None:
        """Restore the terminal in any case at the end."""
        if not self.is_headless:
            leave_on_signals(asyncio.get_running_loop(), self.exit, self._restore)

    def found(self, chosen: Chosen) -> None:
        if isinstance(chosen, DiscoveredSite) and (chosen.choices or chosen.lacks):
            self.push_screen(Arrival(self._roles, chosen, self._end))
        else:
            self._end(chosen)

    def _end(self, chosen: Chosen) -> None:
        self.chosen = chosen
        self.exit()

    def action_nothing(self) -> None:
        """Ignore Ctrl-C, as in the console."""

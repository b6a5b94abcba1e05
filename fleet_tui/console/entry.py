"""The Textual app before the console: a person chooses the fleet to open. It sends no commands."""

import asyncio
from collections.abc import Sequence
from typing import ClassVar, Literal

from textual.binding import BindingType
from textual.screen import Screen
from textual.theme import Theme

from fleet_tui.console.first_run import LOCAL, FirstRun
from fleet_tui.console.site_choice import Arrival
from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.ui.terminal.ending import leave_on_signals, terminal_restorer
from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.themes import FleetTheme

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

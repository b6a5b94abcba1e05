"""The Textual app. Owns the store, the backend and the refresh timer."""

import logging
import time
from functools import partial
from typing import ClassVar

from textual.binding import BindingType
from textual.theme import Theme

from fleet_tui.backend import Backend, Connect, connect_live
from fleet_tui.config.schema import Config
from fleet_tui.keymap import keymap
from fleet_tui.model.commands import Command
from fleet_tui.model.events import Event
from fleet_tui.screens.main import MainScreen
from fleet_tui.state.store import Store
from fleet_tui.terminal.annunciator import Annunciator
from fleet_tui.terminal.ending import leave_on_signals, terminal_restorer
from fleet_tui.terminal.steady_app import SteadyApp
from fleet_tui.themes import FleetTheme
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.widgets.bindings import bindings, textual_keymap

LOG = logging.getLogger(__name__)


def clock(wall: float) -> str:
    """Unix seconds as a local time of day; a recording may say what is none."""
    try:
        return time.strftime("%H:%M:%S", time.localtime(wall)) if wall else ""
    except (OverflowError, ValueError, OSError):
        return "no time"


class FleetApp(SteadyApp, inherit_bindings=False):
    """The console. Its backend is opened last: importing a link takes longer than painting."""

    TITLE = "fleet-tui"
    CSS_PATH = "fleet.tcss"
    BINDINGS: ClassVar[list[BindingType]] = bindings("anywhere")
    ENABLE_COMMAND_PALETTE = False

    def __init__(
        self,
        config: Config,
        store: Store,
        themes: dict[str, FleetTheme],
        drawing: Drawing,
        colour: bool = True,
        opening: Connect = connect_live,
    ) -> None:
        # Without colour Textual must leave the terminal's own, or it sends greys.
        super().__init__(Theme(**themes[config.ui.theme].textual()), ansi_color=not colour)
        self._config, self._themes = config, themes
        self._drawing, self._colour = drawing, colour
        self.store = store
        self.opening = opening
        self._backend: Backend | None = None
        self._restore = terminal_restorer()
        keys, _ = keymap(config.keys)
        self.main = MainScreen(self.store, self.submit, self.tell, self._show_map, keys, clock)
        self.main.read_only, self.main.armed = config.operator.read_only, config.operator.armed
        self.main.announce = Annunciator(config.alarms, self.call).look
        self.main.themes = {name: partial(self.use_theme, name) for name in themes}
        self.main.filled = self.show_first
        self.main.set_inks(themes[config.ui.theme].styles(colour))
        # Only what differs: Textual goes through the whole keymap at every key.
        usual, _ = keymap({})
        self.set_keymap(textual_keymap({id_: key for id_, key in keys.items() if key != usual[id_]}))

    def get_default_screen(self) -> MainScreen:
        """The one screen; everything else opens over its map."""
        return self.main

    async def on_ready(self) -> None:
        """Paint first, then connect."""
        if not self.is_headless:
            leave_on_signals(self.exit, self._restore)
        await self.stand()
        self.budget.every = 1 / self._config.ui.ticks_per_second
        tick = partial(self.budget.ticks.timed, self.main.tick)
        self.set_interval(self.budget.every, partial(self.steadily, tick))
        self.call_after_refresh(self._connect)

    async def furnish(self) -> None:
        """The map, and what opens over the panes."""
        await self.main.furnish(self._drawing)
        self.use_theme(self._config.ui.theme)
        self.main.tick()

    def _connect(self) -> None:
        self.run_worker(self._open_backend, thread=True, exit_on_error=False)

    def _open_backend(self) -> None:
        try:
            self.opening(self._config, self.store, self._enter)
        except Exception as problem:
            LOG.exception("the link can't be opened")
            self.call_from_thread(self.main.say, f"the link can't be opened: {problem} (see the log file)")

    def _enter(self, backend: Backend) -> None:
        self._backend = self.main.backend = backend

    def submit(self, command: Command) -> None:
        """Send a command now, or say why not."""
        if not self.main.armed:
            self.main.say("not sent: this console is not armed, : Arm lets commands leave")
        elif self._backend is None:
            self.main.say("not sent: the console is still starting")
        else:
            self._backend.submit(command)

    def tell(self, event: Event) -> None:
        """Tell the store something that happened here."""
        if self._backend is not None:
            self._backend.tell(event)

    def note(self, text: str) -> None:
        """Tell the operator, with the next tick."""
        self.main.note(text)

    def _show_map(self, robot: str, floor: str) -> bool:
        """Ask for a live map; False while there is nobody to ask."""
        if self._backend is None:
            return False
        self._backend.show_map(robot, floor)
        return True

    def use_theme(self, name: str) -> None:
        """Change every colour, at once."""
        theme = self._themes[name]
        self.register_theme(Theme(**theme.textual()))
        self.theme = f"fleet-{name}"
        self.main.set_inks(theme.styles(self._colour))

    def action_help(self) -> None:
        """Help, also while typing."""
        self.main.action_help()

    def action_pause_all(self) -> None:
        """Pause every robot from wherever the operator is."""
        self.main.action_pause_all()

    def on_unmount(self) -> None:
        """Close the connections before the loop goes."""
        if self._backend is not None:
            self._backend.close()

"""The Textual app. Owns the store, the backend and the refresh timer."""

import asyncio
import logging
import time
from collections.abc import Callable
from functools import partial
from typing import ClassVar

from textual.binding import BindingType
from textual.theme import Theme

from fleet_tui.config.fleet import drive_of
from fleet_tui.config.rights import permissions_of
from fleet_tui.config.schema import Config
from fleet_tui.console.main_screen import MainScreen
from fleet_tui.keys import BY_ID, Pane
from fleet_tui.keys.keymap import keymap
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.history.notifying import alarm_program
from fleet_tui.state.store import Store
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.ui.backend import Backend, LiveBackend
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.controllers.session import LiveSession, OpenSession
from fleet_tui.ui.controllers.settings import ConsoleSettings
from fleet_tui.ui.terminal.annunciator import Annunciator
from fleet_tui.ui.terminal.ending import leave_on_signals, terminal_restorer
from fleet_tui.ui.terminal.fault_guard import FaultGuard
from fleet_tui.ui.terminal.first_paint import FirstPaint
from fleet_tui.ui.terminal.key_releases import KeyReleased
from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.themes import FleetTheme
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.widgets.bindings import bindings, textual_key, textual_keymap


def announcing(
    config: Config, backend: Backend, send: Callable[[str], bool], say: Callable[[Message], None]
) -> Callable[[FleetState], None]:
    """Return what is called with every state. `send` writes to the terminal, `say` tells the operator that
    the program failed; what a recording shows calls nobody else."""
    annunciator = Annunciator(config.alarms, send)
    program = alarm_program(config, say) if isinstance(backend, LiveBackend) else None

    def look(state: FleetState) -> None:
        annunciator.look(state)
        if program is not None:
            program.look(state)

    return look


LOG = logging.getLogger(__name__)


def clock(wall: float) -> str:
    """Return Unix seconds as a local time of day; a recording may contain invalid ones."""
    try:
        return time.strftime("%H:%M:%S", time.localtime(wall)) if wall else ""
    except (OverflowError, ValueError, OSError):
        return Message("no time")


class FleetApp(LeanApp, inherit_bindings=False):
    """The console. Its backend is opened last: importing a link takes longer than painting."""

    TITLE = "fleet-tui"
    CSS_PATH = "../fleet.tcss"
    BINDINGS: ClassVar[list[BindingType]] = bindings(Pane.ANYWHERE)
    ENABLE_COMMAND_PALETTE = False

    def __init__(
        self,
        config: Config,
        store: Store,
        themes: dict[str, FleetTheme],
        drawing: Drawing,
        *,
        colour: bool = True,
        backend: Backend | None = None,
        open_session: OpenSession = LiveSession,
        files: ConsoleFiles | None = None,
        terminal: str = "",
        message: Message = EMPTY,
    ) -> None:
        """Without a `backend` the console connects to the fleet of `config`. `terminal` is its description in
        help, `message` the first notice."""
        # Without colour Textual must use the terminal's own, or it sends greys.
        super().__init__(ansi_color=not colour)
        theme = Theme(**themes[config.ui.theme].textual())
        self._start = self.startup = FirstPaint(self, self.output, theme, colour, self._mount_rest)
        self.config = config
        self._themes = themes
        self._colour = colour
        self.backend = backend or LiveBackend(config, store)
        self._restore = terminal_restorer()
        keys, _ = keymap(config.keys)
        settings = self._settings(keys, drawing, terminal, message)
        self.main = MainScreen(store, self.backend, settings, files or ConsoleFiles(), open_session)
        self._guard = self.faults = FaultGuard(partial(self.main.notices.note, stays=True))
        self.main.set_role_styles(themes[config.ui.theme].styles(colour))
        # Only the changes: Textual goes through the whole keymap at every key.
        pausing = {textual_key(key) for key in keys["pause_all"]}
        self.keys.guard(self.main.tell_dropped, pausing.__contains__)
        self.set_keymap(textual_keymap({id_: key for id_, key in keys.items() if key != BY_ID[id_].keys}))

    def _settings(
        self, keys: dict[str, tuple[str, ...]], drawing: Drawing, terminal: str, message: Message
    ) -> ConsoleSettings:
        config = self.config
        return ConsoleSettings(
            keys=keys,
            clock=clock,
            permissions=permissions_of(config),
            drawing=drawing,
            themes={name: partial(self.use_theme, name) for name in self._themes},
            announce=announcing(config, self.backend, self.output.call, lambda it: self.main.notices.say(it)),
            resized=self._start.show,
            terminal=terminal,
            message=message,
            programs=config.programs,
            drive={robot.name: drive_of(config, robot) for robot in config.robots},
            routines=config.routine_folder,
            doubt=config.doubt,
            picture_limit=1000 * config.camera.kB_per_s,
        )

    def get_default_screen(self) -> MainScreen:
        """Return the one screen; everything else opens over its map."""
        return self.main

    async def on_ready(self) -> None:
        """Paint first, then connect."""
        if not self.is_headless:
            leave_on_signals(asyncio.get_running_loop(), self.exit, self._restore)
        await self._start.finish()
        if not self.is_headless:
            self.keys.watch()
        budget = self.output.budget
        budget.every = 1 / self.config.ui.ticks_per_second
        tick = partial(self._guard.steadily, partial(budget.ticks.timed, self.main.tick))
        self.set_interval(budget.every, partial(self.answer.then, self, tick))
        self.call_after_refresh(self._connect)

    async def _mount_rest(self) -> None:
        """Mount the map, and the overlays."""
        await self.main.mount_features()
        self.use_theme(self.config.ui.theme)
        self.main.tick()

    def _connect(self) -> None:
        self.run_worker(self._open_backend, thread=True, exit_on_error=False)

    def _open_backend(self) -> None:
        try:
            self.backend.open()
        except Exception as problem:
            LOG.exception("link not opened")
            said = Message("link not opened: {problem} (see the log file)", problem=problem)
            self.call_from_thread(self.main.notices.say, said, stays=True)

    def use_theme(self, name: str) -> None:
        """Change every colour, at once."""
        theme = self._themes[name]
        self.register_theme(Theme(**theme.textual()))
        self.theme = f"fleet-{name}"
        self.main.set_role_styles(theme.styles(self._colour))

    async def on_key_released(self, released: KeyReleased) -> None:
        """Stop what drives only while its key is held."""
        if self.main.is_complete:
            await self.keys.then(partial(self.main.features.driving.release_key, released.key))

    def on_unmount(self) -> None:
        """Close the connections before the loop goes."""
        self.backend.close()

"""Textual's app, overridden where Textual has no hook; the work is done by other objects."""

import logging
import math
import time
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from rich.console import RenderableType
from textual import _compositor, events
from textual.app import App
from textual.driver import Driver
from textual.screen import Screen
from textual.worker import WorkerFailed

from fleet_tui.links.transports.loop import end_turn, give_turn
from fleet_tui.ui.terminal.display_driver import DisplayDriver
from fleet_tui.ui.terminal.key_queue import KeyDone, KeyQueue
from fleet_tui.ui.terminal.key_releases import parse_releases, tell_releases
from fleet_tui.ui.terminal.terminal_driver import TerminalDriver

if TYPE_CHECKING:
    from collections.abc import Mapping

    from textual.actions import ActionParseResult
    from textual.dom import DOMNode

    from fleet_tui.ui.terminal.fault_guard import FaultGuard
    from fleet_tui.ui.terminal.first_paint import FirstPaint

LOG = logging.getLogger(__name__)


WITHIN = 0.03
"""Seconds after a key in which a picture is its answer; some keys have none."""


class LeanApp(App[None]):
    """Paints by its display driver. Without a fault guard a failed worker ends it; without a first paint,
    typed keys go to Textual at once."""

    LEAN = True
    faults: "FaultGuard | None" = None
    startup: "FirstPaint | None" = None
    failure: Exception | None = None
    """The error that ended it, if any."""

    def __init__(self, ansi_color: bool = False, driver_class: type[Driver] | None = None) -> None:
        super().__init__(driver_class=driver_class, ansi_color=ansi_color)
        parse_releases()
        self.output = DisplayDriver(self, self.LEAN)
        self.answer = KeyAnswer()
        self.keys = KeyQueue(self, super().on_event)
        self.keys.unread_for = self.output.unread_for
        self.output.read_again = self.keys.read_again

    def get_driver_class(self) -> type[Driver]:
        """Return the driver that Textual chooses, for a terminal our own."""
        chosen = super().get_driver_class()
        return TerminalDriver if chosen.__name__ == "LinuxDriver" else chosen

    def on_mount(self) -> None:
        """Repaint when the process goes on after a stop."""
        if isinstance(self._driver, TerminalDriver):
            self._driver.repaint = self.action_repaint

    def _handle_exception(self, error: Exception) -> None:
        # Textual ends the app.
        if isinstance(error, WorkerFailed):
            self._worker_failed(error.error)
        else:
            self.failure = self.failure or error
            super()._handle_exception(error)

    def _worker_failed(self, error: BaseException) -> None:
        if self.faults is not None:
            self.faults.worker_failed(error)
        else:
            LOG.error("worker", exc_info=error)
            self.failure = self.failure or RuntimeError(error)
            self.exit()

    def _fatal_error(self) -> None:
        """Exit. Textual would paint a traceback with the values of all variables, secrets among them."""
        self._close_messages_no_wait()

    async def run_action(
        self,
        action: "str | ActionParseResult",
        default_namespace: "DOMNode | None" = None,
        namespaces: "Mapping[str, DOMNode] | None" = None,
    ) -> bool:
        """Run the action of a key, a button or a line of the palette."""
        # Textual ends the app if an action fails.
        try:
            return await super().run_action(action, default_namespace, namespaces)
        except Exception as problem:
            if self.faults is None:
                raise
            self.faults.action_failed(action, problem)
            return True

    async def on_event(self, event: events.Event) -> None:
        """Keep typed keys until their target is mounted."""
        # Textual passes it to the focused widget.
        if self.startup is not None and isinstance(event, events.InputEvent | events.Paste):
            await self.startup.finish()
        if isinstance(event, events.Key | events.MouseScrollDown | events.MouseScrollUp):
            self.answer.asked()
        if isinstance(event, events.InputEvent | events.Paste) and not event.is_forwarded:
            await self.keys.take(event)
        else:
            await super().on_event(event)

    async def on_key_done(self, done: KeyDone) -> None:
        """Deliver the next key."""
        await self.keys.passed(done)

    def _display(self, screen: Screen[object], renderable: RenderableType | None) -> None:
        # Textual writes whole rows, and waits for the terminal.
        update = renderable if isinstance(renderable, _compositor.CompositorUpdate) else None
        shows = self._running and not self._closed and not self._batch_count
        if update is None or self.is_headless or self.is_inline or not self.output.paints():
            super()._display(screen, renderable)
        else:
            try:
                if shows:
                    self.output.show(update)
                    self.answer.shown()
            finally:
                self.post_display_hook()
        if update is not None and shows and self.startup is not None:
            self.startup.painted.set()

    def tell_releases(self, wanted: bool) -> None:
        """Ask the terminal to tell key releases, or no longer."""
        tell_releases(self._driver, wanted)

    def on_resize(self, _event: events.Resize) -> None:
        """Repaint: terminals reflow their content when their size changes, also there and back."""
        self.output.repaint()

    def action_repaint(self) -> None:
        self.output.repaint()


class KeyAnswer:
    """Puts off what would delay the next picture after a key."""

    def __init__(self) -> None:
        self._until = -math.inf

    def asked(self) -> None:
        """Have everything else wait: a key has come."""
        self._until = time.monotonic() + WITHIN
        give_turn()

    def shown(self) -> None:
        """Note that a picture is sent."""
        self._until = -math.inf

    def then(self, app: App[None], tick: Callable[[], None]) -> None:
        """Call a tick now, or once after the answer that is still to come."""
        if time.monotonic() < self._until:
            app.set_timer(WITHIN, partial(_alone, tick))
        else:
            _alone(tick)


def _alone(tick: Callable[[], None]) -> None:
    """Call a tick while messages wait: a key that comes now waits for both."""
    give_turn()
    try:
        tick()
    finally:
        end_turn()

"""The console under Textual's pilot, on the real loopback simulator: what it shows, what it sends."""

import asyncio
import time
import unicodedata
from collections.abc import AsyncIterator, Callable, Iterable
from contextlib import AsyncExitStack, asynccontextmanager
from functools import cache, partial
from pathlib import Path
from typing import Any

from rich.console import RenderableType
from textual import events
from textual.driver import Driver
from textual.keys import REPLACED_KEYS, _character_to_key, _get_unicode_name_from_key
from textual.message_pump import MessagePump
from textual.pilot import Pilot
from textual.screen import Screen

from fleet_tui.cli.session import missing
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.console.app import FleetApp
from fleet_tui.console.open import recorded
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import CommandPath
from fleet_tui.records.recording.recordings import Recordings
from fleet_tui.ui.backend import Backend, LiveBackend, connect_live
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.themes import FleetTheme, load_themes
from fleet_tui.ui.view.map.drawing import Drawing
from tests.support.polling import HANGS
from tests.support.watched_store import WatchedStore
from tests.support.widget_app import screen_rows

LOOK_EVERY = 0.05


class Console:
    """A running console. `until` and `shows` wait for the state and the screen."""

    def __init__(self, app: FleetApp, store: WatchedStore, pilot: Pilot[None]) -> None:
        self.app, self.store, self.pilot = app, store, pilot
        self._key_at = time.monotonic()

    @property
    def text(self) -> str:
        """The whole screen as a person reads it."""
        return "\n".join(screen_rows(self.app))

    @property
    def driver(self) -> Driver:
        assert self.app._driver is not None
        return self.app._driver

    def pane(self, name: str) -> str:
        """The text of one pane, whatever lies over it."""
        widget = self.app.main.query_one(f"#{name}")
        return "\n".join(widget.render_line(y).text for y in range(widget.size.height))

    async def press(self, *keys: str) -> None:
        """Press keys one after the other, each a second later, when all that the one before it led to is
        done."""
        for key in keys:
            self._pause()
            self.send(key)
            await self.settled()

    async def press_after(self, seconds: float, key: str) -> None:
        """Press a key so many seconds after the last one, when all that that one led to is done."""
        self._key_at += seconds
        self.send(key, after=0.0)
        await self.settled()

    async def type(self, text: str) -> None:
        """Type text a second later, as a person or a paste does: every character is already there."""
        self._pause()
        for letter in text:
            self.send("space" if letter == " " else letter)
        await self.settled()

    def packet(self, *keys: str) -> None:
        """Send keys that arrive at the same moment, a second later, without waiting for what they lead to."""
        self._pause()
        for key in keys:
            self.send(key, after=0.0)

    def _pause(self) -> None:
        """A person takes a second, also after what a test has waited for."""
        self._key_at = max(self._key_at, time.monotonic()) + 1.0

    def send(self, key: str, after: float = 0.01) -> None:
        """Send it as Textual's pilot does, which waits for an idle process: with a fleet it never is."""
        named = _character_to_key(key) if len(key) == 1 and not key.isalnum() else key
        name = _get_unicode_name_from_key(REPLACED_KEYS.get(named, named))
        try:
            character: str | None = unicodedata.lookup(name)
        except KeyError:
            character = named if len(named) == 1 else None
        event = events.Key(named, character)
        event.set_sender(self.app)
        self._key_at = event.time = max(event.time, self._key_at + after)
        self.driver.send_message(event)

    async def settled(self) -> None:
        """Wait until no widget has work left and what it changed is painted; not for the next tick.

        Textual's own wait posts a message to every widget and back, and one round misses what came of it.
        """
        ends = time.monotonic() + 30
        idle = 0
        while idle < 3 and not self.app._exception and self.app.is_running:
            assert time.monotonic() < ends, "a widget never comes to rest"
            await asyncio.sleep(0 if idle else 0.0005)
            idle = idle + 1 if self._is_idle() else 0

    def _is_idle(self) -> bool:
        pumps = [
            self.app,
            *(pump for screen in self.app.screen_stack for pump in screen.walk_children(with_self=True)),
        ]
        if any(pump._running and not _waits(pump) for pump in pumps):
            return False
        screen = self.app.screen
        if screen._layout_required or screen._repaint_required or screen._dirty_widgets or screen._callbacks:
            screen._on_timer_update()  # now, instead of at the next sixtieth of a second
            return False
        return True

    async def until(self, holds: Callable[[FleetState], object]) -> FleetState:
        """Wait until the state is as wanted."""
        try:
            return await self.store.until(holds)
        except TimeoutError:
            raise AssertionError(f"never so:\n{self.text}") from None

    async def shows(self, text: str, pane: str = "") -> None:
        """Wait until a text stands on the screen, or in a pane."""
        await self.sees(lambda: text in (self.pane(pane) if pane else self.text), text)

    async def hides(self, text: str, pane: str = "") -> None:
        """Wait until a text has gone from the screen, or from a pane."""
        await self.sees(lambda: text not in (self.pane(pane) if pane else self.text), f"no {text}")

    async def shows_a_label(self) -> None:
        """Wait until the map has labels; a robot's number may cover the end of one of them."""
        labels = ("Base", "Packing", "Dispatch")
        await self.sees(lambda: any(label in self.pane("map") for label in labels), "a label on the map")

    async def sees(self, holds: Callable[[], bool], what: str) -> None:
        """Wait until it is seen: a look is a whole picture, and of what comes at one moment one is enough."""
        ends = time.monotonic() + HANGS
        while not self._sees(holds):
            if time.monotonic() > ends:
                raise AssertionError(f"never seen: {what}\n{self.text}")
            await asyncio.sleep(LOOK_EVERY)

    def _sees(self, holds: Callable[[], bool]) -> bool:
        self.app.main.tick()
        try:
            return holds()
        except (LookupError, StopIteration):  # what is asked about is not there yet
            return False


def _waits(pump: MessagePump) -> bool:
    waiters: Iterable[asyncio.Future[bool]] = pump._message_queue.ready_event._waiters
    return any(not waiter.done() for waiter in waiters)


def _ready(state: FleetState) -> bool:
    robots = state.robots.values()
    waited_for = {"pose", "queue", "cargo", *(f"labels of {floor}" for floor in state.floors)}
    known = all(
        robot.knows_all_graphs() and waited_for.isdisjoint(missing(robot)) and robot.last_received is not None
        for robot in robots
    )
    return known and all(link.command_path is CommandPath.ALIVE for link in state.links.values())


def _paints_nothing(screen: Screen[None]) -> None:
    """Nobody sees what is painted without a terminal, an eighth of a test's time; `text` draws it anew,
    and so does a picture of the screen, which is `full`."""
    compositor, paint = screen._compositor, screen._compositor.render_update

    def update(full: bool = False, **more: Any) -> RenderableType | None:
        if full:
            return paint(full, **more)
        compositor._dirty_regions.clear()
        return None

    setattr(compositor, paint.__name__, update)


@asynccontextmanager
async def console(
    config: Config,
    size: tuple[int, int] = (120, 40),
    wait: bool = True,
    colour: bool = True,
    state_folder: Path | None = None,
    files: ConsoleFiles | None = None,
) -> AsyncIterator[Console]:
    """Run the console until all telemetry has come. With a `state_folder` it records, too."""
    store = WatchedStore(initial_state(config, time.monotonic()))
    recordings = Recordings(config, store, state_folder) if state_folder else None
    opening = partial(recorded, recordings, None) if recordings else connect_live
    backend, files = LiveBackend(config, store, opening), files or ConsoleFiles()
    files.recordings = recordings
    app = console_app(config, store, backend, files, colour)
    async with AsyncExitStack() as stack:
        if recordings:
            stack.callback(recordings.close)
        it = await stack.enter_async_context(running(app, store, size))
        if wait:
            await it.until(_ready)
            await it.shows_a_label()
        yield it


@cache
def _themes() -> dict[str, FleetTheme]:
    return load_themes(None)[0]


def console_app(
    config: Config, store: WatchedStore, backend: Backend, files: ConsoleFiles, colour: bool = True
) -> FleetApp:
    return FleetApp(config, store, _themes(), Drawing.BRAILLE, colour=colour, backend=backend, files=files)


@asynccontextmanager
async def running(app: FleetApp, store: WatchedStore, size: tuple[int, int]) -> AsyncIterator[Console]:
    async with app.run_test(size=size) as pilot:
        it = Console(app, store, pilot)
        _paints_nothing(app.main)
        app.keys.clock = lambda: 0.0  # keys come at times of their own, which no busy machine delays
        yield it

"""The console under Textual's pilot on a planted fleet: no wire, and time passes while it waits."""

import asyncio
import json
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress

from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.model.commands import Command
from fleet_tui.model.events import CommandPathChanged, Event
from fleet_tui.model.link import CommandPath
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.files import ConsoleFiles
from tests.support.console_pilot import Console, console_app, running
from tests.support.desk import CollectingBackend
from tests.support.fleets import LINK, link_lost, link_up
from tests.support.planted_fleet import STEP, Planted
from tests.support.watched_store import WatchedStore, config_of

SITE = "ws://site:9090"


class PlantedBackend(CollectingBackend):
    """Keeps the commands that are handed to it; the planted robots answer them unless they are deaf."""

    def __init__(self, fleet: Planted) -> None:
        super().__init__()
        self.streams, self.reads_logs = fleet.store.streams, False
        self._fleet = fleet

    def submit(self, *commands: Command) -> Message:
        self._fleet.now = time.monotonic()
        self._fleet.give(*commands)
        return super().submit(*commands)

    def post(self, event: Event) -> Message:
        self._fleet.tell(event)
        return super().post(event)

    def show_map(self, robot: str, floor: str) -> None:
        self._fleet.show_map(robot, floor)

    def subscribe_logs(self, on: bool) -> None:
        self.reads_logs = on


class PlantedConsole(Console):
    """A console, its fleet, and the commands that it gave."""

    fleet: Planted
    backend: PlantedBackend

    @property
    def sent(self) -> list[Command]:
        return self.backend.submitted

    def publish(self, topic: str, message: dict[str, object]) -> None:
        """Hear a message of a topic, and no other until the next one."""
        self.fleet.server.bridge.muted.add(topic)
        self.fleet.hear(topic, json.dumps(message))

    def lose_link(self) -> None:
        """Hear nothing any more, and know why."""
        self.fleet.deaf = True
        self.fleet.tell(link_lost(self.fleet.now, next_try=self.fleet.now + 9.0))

    def find_link(self) -> None:
        """Hear the fleet, and reach it, from now on."""
        self.fleet.deaf = False
        self.fleet.tell(link_up(self.fleet.now), CommandPathChanged(LINK, CommandPath.ALIVE, connected=True))


async def _live(fleet: Planted) -> None:
    while True:
        fleet.now = time.monotonic()
        await asyncio.sleep(STEP)
        fleet.run(STEP)


@asynccontextmanager
async def planted(
    robots: int = 1,
    floors: int = 1,
    size: tuple[int, int] = (120, 40),
    faults: str = "",
    config: Config | None = None,
    files: ConsoleFiles | None = None,
) -> AsyncIterator[PlantedConsole]:
    config = config or config_of(SITE, robots, floors)
    at = time.monotonic()
    store = WatchedStore(initial_state(config, at - 1.0))
    fleet = Planted(faults, config=config, store=store, at=at - 1.0, wall=time.time() - at)
    fleet.tell(CommandPathChanged(LINK, CommandPath.ALIVE, connected=True))
    fleet.run(1.0)
    backend = PlantedBackend(fleet)
    app = console_app(config, store, backend, files or ConsoleFiles())
    async with running(app, store, size) as it:
        it = PlantedConsole(app, store, it.pilot)
        it.fleet, it.backend = fleet, backend
        life = asyncio.create_task(_live(fleet))
        await it.until(lambda _: app.main.is_complete)
        app.main.tick()  # the first one asked for the map
        await it.settled()
        yield it
        await it.settled()
        life.cancel()
        with suppress(asyncio.CancelledError):
            await life


@asynccontextmanager
async def in_the_way(*names: str) -> AsyncIterator[PlantedConsole]:
    """A console with two robots on two floors, of which some touch something for 4.2 s."""
    async with planted(2, 2) as it:
        for name in names:
            it.publish(f"/{name}/obstacle", {"data": 44.2})
        await it.shows(f"Alarms {len(names)} new", "alarms")
        yield it

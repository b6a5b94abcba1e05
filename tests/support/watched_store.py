"""A store that tests can wait on: no test sleeps to let something happen."""

import asyncio
from collections.abc import Callable
from contextlib import suppress

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.robots.profile import Profile
from fleet_tui.state.store import Store
from tests.support.polling import HANGS


class WatchedStore(Store):
    """Wakes a waiting test at every event; the writer's clock makes one at least ten times a second."""

    def __init__(self, state: FleetState) -> None:
        super().__init__(state)
        self.events: list[Event] = []
        self._loop = asyncio.get_running_loop()
        self._told = asyncio.Event()

    def apply(self, event: Event) -> None:
        super().apply(event)
        self.events.append(event)
        self._wake()

    def put(self, state: FleetState) -> None:
        super().put(state)
        self._wake()

    def _wake(self) -> None:
        if not self._loop.is_closed():
            self._loop.call_soon_threadsafe(self._told.set)

    async def until(self, holds: Callable[[FleetState], object], within: float = HANGS) -> FleetState:
        """Wait until the state is as wanted; the test fails if it never is."""
        try:
            async with asyncio.timeout(within):
                while not self._holds(holds):
                    self._told.clear()
                    # A screen may change without an event: that of a stopped replay.
                    with suppress(TimeoutError):
                        async with asyncio.timeout(0.1):
                            await self._told.wait()
        except TimeoutError:
            commands = [(one.command, one.stage, one.detail) for one in self.state.commands]
            raise TimeoutError(f"never so: {self.events[-9:]} {commands}") from None
        return self.state

    def _holds(self, holds: Callable[[FleetState], object]) -> bool:
        try:
            return bool(holds(self.state))
        except (LookupError, StopIteration):  # what is asked about is not there yet
            return False

    def told(self, kind: type[Event]) -> list[Event]:
        """The events of a kind, in order."""
        return [event for event in self.events if isinstance(event, kind)]


def config_of(url: str, robots: int = 1, floors: int = 1) -> Config:
    """A config for the simulator, as the demo makes it."""
    return Config(
        rosbridge=Link(url),
        floors=[FloorEntry(f"floor_{n}") for n in range(floors)],
        robots=[RobotEntry(f"robot_{n}") for n in range(robots)],
        profile=Profile(topics={"paused": "/{robot}/paused"}),
    )

"""The backend of the console: a live fleet or a recording of one. Typing it costs no import."""

import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from fleet_tui.config.schema import Config
from fleet_tui.model.commands import Command
from fleet_tui.model.events import Event
from fleet_tui.model.set_up.driving import HandDrive
from fleet_tui.state.store import Store
from fleet_tui.state.streams import Streams
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import EMPTY, Message

if TYPE_CHECKING:
    from fleet_tui.links.tap import Tap
    from fleet_tui.model.counters import LinkCounter


class Backend(Protocol):
    """Feeds the store, and takes the operator's requests. Callable from any thread."""

    @property
    def refusal(self) -> Message:
        """Return the reason that no command may ever be sent, empty if some may."""

    @property
    def counters(self) -> "Mapping[str, LinkCounter]":
        """Return the counters of each link. They change all the time."""

    @property
    def streams(self) -> Streams:
        """Return the newest values of the watched streams."""

    def watch(self, robot: str, key: str) -> None:
        """Subscribe to a stream of a robot, `scan` or `path`; its values are in `streams`."""

    def unwatch(self, robot: str, key: str) -> None:
        """Unsubscribe from a stream."""

    def drive(self, robot: str) -> HandDrive:
        """Begin to drive a robot by hand. Raises CommandError."""

    def open(self) -> None:
        """Start to feed the store. May take long: called in a thread of its own."""

    def submit(self, *commands: Command) -> Message:
        """Send the commands of a request now or not at all. Returns the reason that none can be tried."""

    def post(self, event: Event) -> Message:
        """Apply an event from outside the link. Returns the reason that it is rejected."""

    def show_map(self, robot: str, floor: str) -> None:
        """Subscribe to the live map of one robot's floor."""

    def subscribe_logs(self, on: bool) -> None:
        """Subscribe to or unsubscribe from the log and diagnostics of all robots."""

    def close(self) -> None:
        """Close permanently."""


class OpenLinks(Protocol):
    """All links of a live fleet. Callable from any thread."""

    @property
    def counters(self) -> "Mapping[str, LinkCounter]":
        """Return the counters of each link. They change all the time."""

    def extend(self, config: Config) -> None:
        """Add the robots and floors that a configuration has besides. Not on the loop: it is waited for."""

    def submit_all(self, commands: Sequence[Command]) -> object:
        """Send the commands of a request now or not at all."""

    def drive(self, robot: str) -> HandDrive:
        """Begin to drive a robot by hand. Raises CommandError."""

    def post(self, event: Event) -> None:
        """Apply an event from outside the link."""

    def show_map(self, robot: str, floor: str) -> None:
        """Subscribe to the live map of one robot's floor."""

    def subscribe_logs(self, on: bool) -> None:
        """Subscribe to or unsubscribe from the log and diagnostics of all robots."""

    def close(self) -> None:
        """Close permanently."""


Connect = Callable[[Config, Store, Callable[[OpenLinks], None]], None]
"""Opens the links, and passes them on as soon as they accept commands."""


def connect_live(
    config: Config,
    store: Store,
    on_ready: Callable[[OpenLinks], None],
    tap: "Tap | None" = None,
    folder: Path | None = None,
    owner: str = "",
) -> None:
    """Connect to every bridge, then load the floors' files. `folder` keeps the orders of robots without a
    queue; without it they last as long as this process. Importing the link takes longer than painting."""
    from fleet_tui.links.fleet_link import FleetLink
    from fleet_tui.links.queue_file import QueueFile

    link = FleetLink(config, store, tap, None if config.operator.read_only else QueueFile(folder, owner))
    link.open()
    on_ready(link)
    from fleet_tui.maps.floor_files import load_floors

    for loaded in load_floors(config):
        link.post(loaded)


class LiveBackend:
    """The live fleet. Until its links are open nothing is sent; subscriptions are made then."""

    refusal = EMPTY

    def __init__(self, config: Config, store: Store, connect: Connect = connect_live) -> None:
        self._config = config
        self._store = store
        self._connect = connect
        self.streams = store.streams
        self.links: OpenLinks | None = None
        self._map: tuple[str, str] | None = None
        self._reads_logs = self._closed = False
        self._changing = threading.Lock()
        """Held while the links open or a subscription changes, so that the newest choice is applied last."""

    def open(self) -> None:
        self._connect(self._config, self._store, self._enter)

    def _enter(self, links: OpenLinks) -> None:
        with self._changing:
            self.links = links
            if self._closed:
                links.close()
                return
            if self._map is not None:
                links.show_map(*self._map)
            if self._reads_logs:
                links.subscribe_logs(True)

    @property
    def counters(self) -> "Mapping[str, LinkCounter]":
        """Return the counters of each link, empty before they are open."""
        return self.links.counters if self.links is not None else {}

    def submit(self, *commands: Command) -> Message:
        """Send the commands of a request now, or return the reason not to."""
        if self.links is None:
            return Message("not sent: console starting")
        self.links.submit_all(commands)
        return EMPTY

    def drive(self, robot: str) -> HandDrive:
        """Begin to drive a robot by hand. Raises CommandError."""
        if self.links is None:
            raise CommandError(Message("console starting"))
        return self.links.drive(robot)

    def post(self, event: Event) -> Message:
        """Apply an event, none before the links are open."""
        if self.links is not None:
            self.links.post(event)
        return EMPTY

    def watch(self, robot: str, key: str) -> None:
        """Subscribe to a stream of a robot."""
        self.streams.watch(robot, key)

    def unwatch(self, robot: str, key: str) -> None:
        """Unsubscribe from a stream."""
        self.streams.unwatch(robot, key)

    def show_map(self, robot: str, floor: str) -> None:
        """Subscribe to the live map of one robot's floor."""
        with self._changing:
            self._map = robot, floor
            if self.links is not None:
                self.links.show_map(robot, floor)

    def subscribe_logs(self, on: bool) -> None:
        """Subscribe to or unsubscribe from the log and diagnostics of all robots."""
        if on == self._reads_logs:
            return  # asked at every tick
        with self._changing:
            self._reads_logs = on
            if self.links is not None:
                self.links.subscribe_logs(on)

    def close(self) -> None:
        """Close the links, also those that are still being opened."""
        with self._changing:
            self._closed = True
            if self.links is not None:
                self.links.close()

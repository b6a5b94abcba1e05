"""The backend: what the console talks to, a live fleet or a recording of one. Typing it costs no import."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from fleet_tui.config.schema import Config
from fleet_tui.model.commands import Command
from fleet_tui.model.events import Event
from fleet_tui.state.store import Store

if TYPE_CHECKING:
    from fleet_tui.client.tap import Tap
    from fleet_tui.model.counters import LinkCounter


class Backend(Protocol):
    """Feeds the store, and takes what the operator wants. Any thread may call."""

    @property
    def counters(self) -> "Mapping[str, LinkCounter]":
        """Return what came over each link. It changes all the time."""

    def submit(self, command: Command) -> object:
        """Send a command now or not at all."""

    def tell(self, event: Event) -> None:
        """Take a fact that came from elsewhere into the picture."""

    def show_map(self, robot: str, floor: str) -> None:
        """Ask for the live map of one robot's floor."""

    def overhear(self, on: bool) -> None:
        """Listen to the log and diagnostics of all robots, or no longer."""

    def close(self) -> None:
        """Let nothing more through."""


Connect = Callable[[Config, Store, Callable[[Backend], None]], None]
"""Opens a backend, in a thread of its own, and hands it over as soon as commands can be given to it."""


def connect_live(
    config: Config,
    store: Store,
    stands: Callable[[Backend], None],
    tap: "Tap | None" = None,
    folder: Path | None = None,
    owner: str = "",
) -> None:
    """Connect to every bridge, then load the floors' files. `folder` is where orders are kept for robots that
    have no queue; without one they are for as long as this process lives. Importing the link takes longer
    than painting."""
    from fleet_tui.client.fleet_link import FleetLink
    from fleet_tui.client.queue_file import QueueFile

    link = FleetLink(config, store, tap, None if config.operator.read_only else QueueFile(folder, owner))
    link.open()
    stands(link)
    from fleet_tui.maps.floor_files import load_floors

    for loaded in load_floors(config):
        link.tell(loaded)

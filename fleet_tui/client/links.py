"""Links by the scheme of their address: one folder each, imported on use."""

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import Protocol, cast

from fleet_tui.adapters.adapter import Adapter
from fleet_tui.client.writer import Writer
from fleet_tui.config.schema import Config
from fleet_tui.model.commands import Command
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.set_up.driving import HandDrive

FOLDERS = {"ws": "rosbridge", "wss": "rosbridge", "mqtt": "mqtt", "mqtts": "mqtt"}
"""The folder of each scheme, whose module `link` has a LINK."""


class RobotLink(Protocol):
    """All connections between one server and the store. Callable from any thread unless noted otherwise."""

    @property
    def counter(self) -> LinkCounter:
        """Return its traffic, updated continuously."""

    def open(self) -> None:
        """Connect, and stay connected."""

    def extend(self, config: Config, adapters: Mapping[str, Adapter]) -> None:
        """Add the robots that a configuration has besides, on the loop, once they are in the state."""

    def submit_now(self, command_id: int, command: Command, given_at: float) -> None:
        """Send a command, on the loop; its progress reaches the store as CommandAdvanced."""

    def resend(self, command: Command) -> None:
        """Send a command once more, on the loop: only the first attempt is reported."""

    def request_state(self, robot: str) -> None:
        """Ask a robot of which no state has arrived for one, on the loop."""

    def drive(self, robot: str) -> HandDrive:
        """Begin to drive a robot by hand. Raises CommandError."""

    def show_map(self, robot: str, floor: str) -> None:
        """Subscribe to the live map of one robot's floor only; an empty name for none."""

    def subscribe_logs(self, on: bool) -> None:
        """Subscribe to or unsubscribe from the robots' log and diagnostics."""

    def close(self) -> None:
        """Close every connection."""


MakeLink = Callable[[str, Config, Mapping[str, Adapter], Writer], RobotLink]


def link_of(name: str, config: Config, adapters: Mapping[str, Adapter], writer: Writer) -> RobotLink:
    """Return the link of a name in the configuration, not yet open. `adapters` by robot."""
    folder = FOLDERS[config.bridges[name].scheme]
    make = cast("MakeLink", import_module(f"fleet_tui.client.{folder}.link").LINK)
    return make(name, config, adapters, writer)

"""One broker: the messages of its vehicles, and the commands to them, on one connection."""

from collections.abc import Mapping

from fleet_tui.config.schema import Config
from fleet_tui.links.mqtt.telemetry import VehicleTelemetry
from fleet_tui.links.writer import Writer
from fleet_tui.model.commands import Command
from fleet_tui.model.kind import DRIVE
from fleet_tui.model.set_up.driving import HandDrive
from fleet_tui.robots.adapter import Adapter
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message


class BrokerLink:
    """The connection between one broker and the store. Callable from any thread unless noted otherwise."""

    def __init__(self, name: str, config: Config, adapters: Mapping[str, Adapter], writer: Writer) -> None:
        """`adapters` by robot."""
        self._writer = writer
        self._adapters = adapters
        self._telemetry = VehicleTelemetry(name, config, adapters, writer)
        self.counter = self._telemetry.counter

    def open(self) -> None:
        """Connect, and stay connected."""
        self._writer.loop.call_soon_threadsafe(self._telemetry.connection.connect)

    def extend(self, config: Config, adapters: Mapping[str, Adapter]) -> None:
        """Add the robots that a configuration has besides, on the loop, once they are in the state."""
        self._adapters = adapters
        self._telemetry.extend(config, adapters)

    def submit_now(self, command_id: int, command: Command, given_at: float) -> None:
        """Send a command, on the loop; its progress reaches the store as CommandAdvanced."""
        self._telemetry.commands.submit(command_id, command, given_at)

    def resend(self, command: Command) -> None:
        """Do nothing: these vehicles are paused without cancelling their order."""

    def request_state(self, robot: str) -> None:
        """Ask a vehicle of which no state has arrived for one, on the loop."""
        self._telemetry.commands.request_state(robot)

    def drive(self, robot: str) -> HandDrive:
        """Raise CommandError: no vehicle is driven by hand over a broker."""
        raise CommandError(self._adapters[robot].kind.lack(DRIVE))

    def show_map(self, robot: str, floor: str) -> None:
        """Do nothing: maps are files."""

    def subscribe_logs(self, on: bool) -> None:
        """Do nothing: vehicles send no log."""

    def close(self) -> None:
        self._writer.loop.call_soon_threadsafe(self._close)

    def _close(self) -> None:
        self._telemetry.commands.on_lost(Message("console closed"))
        self._telemetry.connection.shut()


LINK = BrokerLink

"""One bridge: telemetry on one connection, commands on another, so that no map delays a command."""

from collections.abc import Mapping

from fleet_tui.commands.driving.speed import Caps
from fleet_tui.config.fleet import drive_of, publications_of
from fleet_tui.config.schema import Config
from fleet_tui.links.rosbridge.calls import rosapi_places
from fleet_tui.links.rosbridge.command_channel import CommandChannel
from fleet_tui.links.rosbridge.driving.drive import Drive
from fleet_tui.links.rosbridge.managed_nodes import Lifecycle, lifecycle_probes
from fleet_tui.links.rosbridge.telemetry import Telemetry
from fleet_tui.links.writer import Writer
from fleet_tui.model.commands import Command
from fleet_tui.model.kind import DRIVE
from fleet_tui.robots.adapter import Adapter
from fleet_tui.text.errors import CommandError


class BridgeLink:
    """All connections between one bridge and the store. Callable from any thread."""

    def __init__(self, name: str, config: Config, adapters: Mapping[str, Adapter], writer: Writer) -> None:
        """`adapters` by robot."""
        self.name = name
        self.writer = writer
        self._config = config
        self._adapters = adapters
        self._places = rosapi_places()
        self._telemetry = Telemetry(name, config, adapters, writer, self._places)
        timeout = config.alarms.no_answer_after
        bridge = config.bridge(name)
        self.counter = self._telemetry.counter
        advertised = publications_of(config, adapters, name)
        asks_node = not config.operator.read_only
        probes = lifecycle_probes(config, adapters, name) if asks_node else {}
        self._lifecycle = Lifecycle(name, bridge, probes, self._telemetry.services, writer, self._places)
        self._commands = CommandChannel(
            name, bridge, adapters, writer, timeout, self._telemetry, advertised, self._places, asks_node
        )

    def open(self) -> None:
        """Connect, and stay connected; commands first, so that no subscription delays a pause."""
        self.writer.loop.call_soon_threadsafe(self._commands.connection.connect)
        self.writer.loop.call_soon_threadsafe(self._telemetry.connection.connect)
        self.writer.loop.call_soon_threadsafe(self._lifecycle.open)

    def extend(self, config: Config, adapters: Mapping[str, Adapter]) -> None:
        """Do nothing: the robots of a bridge are those of the beginning."""

    def submit_now(self, command_id: int, command: Command, given_at: float) -> None:
        """Send a command, on the loop; its progress reaches the store as CommandAdvanced."""
        self._commands.submit(command_id, command, given_at)

    def resend(self, command: Command) -> None:
        """Send a command once more, on the loop: only the first attempt is reported."""
        self._commands.resend(command)

    def request_state(self, robot: str) -> None:
        """Do nothing: the topics of a bridge come by themselves."""

    def drive(self, robot: str) -> Drive:
        """Begin to drive a robot by hand, on a connection of its own. Raises CommandError."""
        topic = self._adapters[robot].names.topic("drive", robot)
        if not topic:
            raise CommandError(self._adapters[robot].kind.lack(DRIVE))
        entry = next(one for one in self._config.robots if one.name == robot)
        limits = drive_of(self._config, entry)
        caps = Caps(limits.max_linear, limits.max_angular)
        bridge = self._config.bridge(self.name)
        drive = Drive(self.name, bridge, self.writer, topic, caps, self._places)
        drive.open()
        return drive

    def show_map(self, robot: str, floor: str) -> None:
        """Subscribe to the live map of one robot's floor only; an empty name for none."""
        self.writer.loop.call_soon_threadsafe(self._telemetry.show_map, robot, floor)

    def subscribe_logs(self, on: bool) -> None:
        """Subscribe to or unsubscribe from the robots' log and diagnostics."""
        self.writer.loop.call_soon_threadsafe(self._telemetry.subscribe_logs, on)

    def close(self) -> None:
        self.writer.loop.call_soon_threadsafe(self._telemetry.close)
        self.writer.loop.call_soon_threadsafe(self._commands.close)
        self.writer.loop.call_soon_threadsafe(self._lifecycle.close)


LINK = BridgeLink

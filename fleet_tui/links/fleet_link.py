"""All links of a configuration as one: commands go to the robot's own link."""

import asyncio
import itertools
import logging
import secrets
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from importlib import import_module
from typing import Protocol, cast

from fleet_tui.commands.rights import right_for
from fleet_tui.config.access import access_problems
from fleet_tui.config.fleet import adapters_of, watching
from fleet_tui.config.rights import permissions_of
from fleet_tui.config.schema import Config
from fleet_tui.config.start import extended
from fleet_tui.links.queue_file import QueueFile
from fleet_tui.links.tap import Tap
from fleet_tui.links.transports.loop import call_now
from fleet_tui.links.waiting_orders import WaitingOrders
from fleet_tui.links.writer import Writer
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.events import CommandAdvanced, CommandIssued, Event
from fleet_tui.model.problem import Right
from fleet_tui.model.request import given_now
from fleet_tui.model.set_up.driving import HandDrive
from fleet_tui.robots.adapter import Adapter
from fleet_tui.state.store import Store
from fleet_tui.text.errors import CommandError, ConfigError
from fleet_tui.text.language import EMPTY, Message

LOG = logging.getLogger(__name__)

# request_id is an int32 on the wire: each console and each run starts anywhere in its lower half.
ID_SPAN = 2**30
FAILED = Message("internal error: see the log file")
HANDOVER = 0.005
"""Maximum seconds to wait for the network thread to take a request."""


FOLDERS = {"ws": "rosbridge", "wss": "rosbridge", "mqtt": "mqtt", "mqtts": "mqtt"}
"""The folder of each scheme, whose module `link` has a LINK."""


class FleetLink:
    """Feeds the store and takes the commands. Callable from any thread."""

    def __init__(
        self, config: Config, store: Store, tap: Tap | None = None, queue: QueueFile | None = None
    ) -> None:
        """`queue` holds the orders of robots that have no queue; without it none are kept. Raises ConfigError
        for an unusable secret or certificate."""
        problems = access_problems(config)
        if problems:
            raise ConfigError([f"{config.path}: {line}" for line in problems])
        self._store = store
        self._permissions = permissions_of(config)
        if self._permissions.right < Right.DISPATCH:
            config, queue = watching(config), None
        self._writer = Writer(store, tap)
        self._ids = itertools.count(secrets.randbelow(ID_SPAN) + 1)
        adapters = adapters_of(config)
        self.links = {name: link_of(name, config, adapters, self._writer) for name in config.bridges}
        new_id = partial(next, self._ids)
        self._waiting_orders = WaitingOrders(
            queue, store, self._writer.apply, self._send, self._resend, new_id
        )
        self._writer.before_tick.append(self._waiting_orders.tick)
        self._drive: HandDrive | None = None
        self.counters: Mapping[str, LinkCounter] = {name: link.counter for name, link in self.links.items()}
        """Traffic of each link, updated continuously, for the diagnostics screen."""

    def open(self) -> None:
        """Connect, and start the clock ticks."""
        self._writer.start()
        self._writer.loop.call_soon_threadsafe(self._waiting_orders.load)
        for link in self.links.values():
            link.open()

    def extend(self, config: Config) -> None:
        """Add the robots and floors that a configuration has besides. Not on the loop: it is waited for."""
        asyncio.run_coroutine_threadsafe(self._extend(config), self._writer.loop).result()

    async def _extend(self, config: Config) -> None:
        self._store.put(extended(self._store.state, config))
        adapters = adapters_of(config)
        for link in self.links.values():
            link.extend(config, adapters)
        self._waiting_orders.load()

    def post(self, event: Event) -> None:
        """Apply an event from outside the link to the store."""
        self._writer.post(event)

    def submit(self, command: Command) -> int:
        """Send a command now or not at all. Returns its id; its end is reported exactly once."""
        return self.submit_all([command])[0]

    def submit_all(self, commands: Sequence[Command]) -> list[int]:
        """Send the commands of one request, each as `submit` does: given at one moment, and in the audit log
        before the first is sent. Returns their ids."""
        given = [(next(self._ids), command) for command in commands]
        call_now(partial(self._give, given, time.monotonic(), time.time()), HANDOVER)
        return [command_id for command_id, _ in given]

    def _give(self, given: Sequence[tuple[int, Command]], at: float, wall: float) -> None:
        """Record a request, then send it. On the loop."""
        began = time.monotonic()
        with self._store.together():
            for command_id, command in given:
                self._writer.apply(CommandIssued(command_id, command, at, wall))
        with self._store.together():
            for command_id, command in given:
                try:
                    # The time that its own request takes makes no command too old.
                    self._submit_now(command_id, command, at + time.monotonic() - began)
                except Exception:
                    # One that fails must not keep the others from their robots. It may have left.
                    LOG.exception("command %d", command_id)
                    for stage in (Stage.SENT, Stage.UNKNOWN):
                        self._writer.apply(CommandAdvanced(command_id, stage, time.monotonic(), FAILED))

    def _submit_now(self, command_id: int, command: Command, given_at: float) -> None:
        if reason := self._refusal(right_for(command)):
            self._writer.apply(CommandAdvanced(command_id, Stage.NOT_SENT, given_at, reason))
        elif self._store.state.robots[command.robot].kind.keeps_goals:
            self._queue_or_send(command_id, command, given_at)
        else:
            self._send(command_id, command, given_at)

    def _refusal(self, needed: Right) -> Message:
        """Return the reason to send nothing that needs a right: the last gate, whatever asked for it."""
        objection = self._permissions.objection(needed, arms=False)
        return objection.text if objection else EMPTY

    def _queue_or_send(self, command_id: int, command: Command, given_at: float) -> None:
        if not self._waiting_orders.handles(command_id, command, given_at):
            kind = self._store.state.robots[command.robot].kind
            self._send(command_id, given_now(command, kind), given_at)

    def _send(self, command_id: int, command: Command, given_at: float) -> None:
        """Send a command. On the loop."""
        link = self.links[self._store.state.robots[command.robot].link]
        link.submit_now(command_id, command, given_at)

    def _resend(self, command: Command) -> None:
        """Send a command once more. On the loop."""
        self.links[self._store.state.robots[command.robot].link].resend(command)

    def request_states(self, robots: Iterable[str]) -> None:
        """Ask robots of which no state has arrived for one, before they are commanded."""
        if not self._refusal(Right.DISPATCH):
            for robot in robots:
                link = self.links[self._store.state.robots[robot].link]
                self._writer.loop.call_soon_threadsafe(link.request_state, robot)

    def drive(self, robot: str) -> HandDrive:
        """Begin to drive a robot by hand; a drive before it ends. Raises CommandError."""
        if reason := self._refusal(Right.SETUP):
            raise CommandError(reason)
        self._end_drive(Message("another drive"))
        self._drive = self.links[self._store.state.robots[robot].link].drive(robot)
        return self._drive

    def _end_drive(self, reason: Message) -> None:
        if self._drive is not None:
            self._drive.end(reason)

    def show_map(self, robot: str, floor: str) -> None:
        """Subscribe to the live map of one robot's floor only; an empty floor for none."""
        wanted = self._store.state.robots[robot].link
        for name, link in self.links.items():
            link.show_map(robot if name == wanted and floor else "", floor)

    def subscribe_logs(self, on: bool) -> None:
        """Subscribe to or unsubscribe from the log and diagnostics of all robots."""
        for link in self.links.values():
            link.subscribe_logs(on)

    def close(self) -> None:
        """Close every connection, that of a drive first."""
        self._end_drive(Message("console closed"))
        for link in self.links.values():
            link.close()
        self._writer.loop.call_soon_threadsafe(self._waiting_orders.close)
        self._writer.stop()


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
    make = cast("MakeLink", import_module(f"fleet_tui.links.{folder}.link").LINK)
    return make(name, config, adapters, writer)

"""Connections for goals, one per robot: a bridge of Humble handles nothing else on such a connection until
its goal has ended."""

import asyncio
import itertools
import logging
import time
from collections.abc import Callable, Mapping
from contextlib import suppress

from fleet_tui.config.schema import Link
from fleet_tui.links.rosbridge.answers import decoded
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.links.writer import Writer
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.navigation_events import GoalAnswered
from fleet_tui.orders.local_queue import withdrawn
from fleet_tui.robots.adapter import ActionGoal, Adapter
from fleet_tui.robots.ros import operations
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import EMPTY, Message, message_of

LOG = logging.getLogger(__name__)

CONNECT_WITHIN = 1.0
"""Seconds that a goal may wait for its connection; after that it is out of date."""

TakeResult = Callable[[int, operations.GoalResult], None]


class GoalChannel:
    """The connection for goals of one robot, opened with the first one. Runs on the network loop."""

    def __init__(self, link: str, bridge: Link, writer: Writer, take: TakeResult) -> None:
        """`take` receives the end of each goal with the number of its command."""
        self._link = link
        self._writer = writer
        self._take = take
        self.connection = Connection(bridge, self)
        self._opened = asyncio.Event()
        self._reason = ""
        self._commands: dict[str, int] = {}
        self._numbers = itertools.count(1)
        self.connection.connect()

    async def open(self) -> None:
        """Wait for the connection, up to the limit for a goal."""
        with suppress(TimeoutError):
            await asyncio.wait_for(self._opened.wait(), CONNECT_WITHIN)

    def send(self, command_id: int, goal: ActionGoal) -> None:
        """Send a goal now or not at all. Raises LinkError."""
        if not self.connection.is_connected:
            raise LinkError(
                Message("no link for goals: {reason}", reason=self._reason or "bridge not responding")
            )
        # A paused order is sent again: the end of its previous goal is not the end of this one.
        self._commands = {id_: other for id_, other in self._commands.items() if other != command_id}
        goal_id = f"goal:{command_id}:{next(self._numbers)}"
        self._commands[goal_id] = command_id
        self.connection.send(operations.send_action_goal(goal_id, goal.address, goal.type, goal.args))

    def on_connecting(self) -> None:
        """Do nothing: a connection attempt has begun."""

    def on_open(self) -> None:
        """Allow goals to be sent."""
        self._opened.set()

    def on_lost(self, reason: str, next_try_in: float) -> None:
        """Give up the ends of open goals: their states as topics decide."""
        self._opened.clear()
        self._reason = reason
        self._commands.clear()

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """Take a frame: only ends of goals arrive here."""
        operation = decoded(self._writer.tap, self._link, payload, is_binary)
        if isinstance(operation, operations.GoalResult) and operation.id in self._commands:
            self._take(self._commands.pop(operation.id), operation)

    def on_sent(self, payload: bytes) -> None:
        """Report a sent goal to the tap."""
        if self._writer.tap is not None:
            self._writer.tap.on_sent(self._link, "commands", payload)

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        """Ignore it: no end of a goal is that large."""
        LOG.warning("a reply of %d bytes was dropped", size)

    def close(self) -> None:
        """Close permanently; goals go on."""
        self.connection.shut()


class Goals:
    """The goals of one bridge's robots. `advance` reports a stage that a command reached, `adapters` are by
    robot."""

    def __init__(
        self,
        link: str,
        bridge: Link,
        adapters: Mapping[str, Adapter],
        writer: Writer,
        advance: Callable[[int, Stage, Message], None],
    ) -> None:
        self._link = link
        self._bridge = bridge
        self._adapters = adapters
        self._writer = writer
        self._advance = advance
        self._channels: dict[str, GoalChannel] = {}
        self._commands: dict[int, tuple[Command, str]] = {}
        """Each with the action to which its goal went."""
        writer.before_tick.append(self._end_dropped)

    async def give(self, command_id: int, command: Command, goal: ActionGoal, given_at: float) -> None:
        """Send the goal of a command that was given at `given_at` (monotonic), and report that it left, or
        the reason that it did not."""
        if command.robot not in self._channels:
            made = GoalChannel(self._link, self._bridge, self._writer, self._take)
            self._channels[command.robot] = made
        channel = self._channels[command.robot]
        await channel.open()
        # A pause waits for no connection: the order it overtook must not drive the robot on.
        if reason := withdrawn(self._writer.store.state, command_id, given_at):
            self._advance(command_id, Stage.NOT_SENT, reason)
            return
        self._commands[command_id] = (command, goal.address)
        try:
            channel.send(command_id, goal)
        except LinkError as problem:
            self._advance(command_id, Stage.NOT_SENT, message_of(problem))
            return
        self._advance(command_id, Stage.SENT, EMPTY)

    def _take(self, command_id: int, result: operations.GoalResult) -> None:
        """Take the end of a goal: a refusal ends its command, all else is reported beside its state."""
        command, _ = self._commands.pop(command_id)
        adapter = self._adapters[command.robot]
        stage, detail = adapter.outcome(command, result.values, result.result, result.status)
        if stage is Stage.REFUSED:
            self._advance(command_id, stage, detail)
        else:
            self._writer.apply(GoalAnswered(command_id, stage, time.monotonic(), detail))

    def _end_dropped(self, _now: float) -> None:
        """End the commands whose goals an allow-list of the bridge dropped, which its log alone tells."""
        link = self._writer.store.state.links[self._link]
        for command_id, (_, action) in list(self._commands.items()):
            if refusal := link.refusal_of(action):
                del self._commands[command_id]
                self._advance(command_id, Stage.NOT_SENT, refusal)

    def close(self) -> None:
        """Close all connections permanently; goals go on."""
        for channel in self._channels.values():
            channel.close()

"""The connection for commands. It also monitors whether commands would get through."""

import asyncio
import logging
import time
import uuid
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from functools import partial

from fleet_tui.config.schema import Link
from fleet_tui.links.patience import call_awake
from fleet_tui.links.rosbridge.answers import Answers, decoded
from fleet_tui.links.rosbridge.calls import Calls, PendingCall
from fleet_tui.links.rosbridge.goal_channel import Goals
from fleet_tui.links.rosbridge.heartbeat import Heartbeat
from fleet_tui.links.rosbridge.publishing import Publishing
from fleet_tui.links.rosbridge.services import SETTLE_TIME
from fleet_tui.links.rosbridge.set_up.listeners import check_listeners
from fleet_tui.links.rosbridge.set_up.settling import Settling
from fleet_tui.links.rosbridge.telemetry import Telemetry
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.links.writer import Writer
from fleet_tui.model.commands import UNANSWERED, Command, PauseRobot, PlaceOrder, Stage
from fleet_tui.model.events import CommandAdvanced
from fleet_tui.model.link import CommandPath
from fleet_tui.model.set_up.commands import Settle, SetUpCommand
from fleet_tui.orders.local_queue import withdrawn
from fleet_tui.robots.adapter import ActionGoal, Adapter, Outgoing, Publication, ServiceCall
from fleet_tui.robots.ros import operations
from fleet_tui.robots.service_outcome import said
from fleet_tui.text.errors import CommandError, LinkError
from fleet_tui.text.language import EMPTY, Message, message_of
from fleet_tui.text.limits import truncate

LOG = logging.getLogger(__name__)

# Poses arrive ten times a second: a bridge that was active and is silent for this long has a fault.
LONGEST_SILENCE = 2.0
# A pause waits so long for the type of its service, which rosapi tells within 60 ms: then it can only make
# things safer.
TYPE_WITHIN = 1.5
# A command that waited longer for a stalled console is out of date.
LATEST = 1.0


class CommandChannel:
    """Sends commands now or not at all, and reports their progress. Runs on the network loop."""

    def __init__(
        self,
        link: str,
        bridge: Link,
        adapters: Mapping[str, Adapter],
        writer: Writer,
        timeout: float,
        telemetry: Telemetry,
        advertised: Iterable[tuple[str, str]],
        places: asyncio.Semaphore,
        asks_node: bool = True,
    ) -> None:
        """`timeout` of an answer in seconds; `telemetry` of the same bridge, whose silence counts here;
        `advertised`: names and types of topics on which commands may be published; `places` as for Calls,
        `asks_node` as for Pulse."""
        self._link = link
        self._goals = Goals(link, bridge, adapters, writer, self._advance)
        self._adapters = adapters
        self._writer = writer
        self._timeout = timeout
        self._silence = telemetry.silence
        self._services = telemetry.services
        self._under_way: set[asyncio.Task[None]] = set()
        self._pauses = dict[int, tuple[PauseRobot, float]]()
        """Those that wait for the type of their service, and when they were given."""
        self._in_turn = asyncio.Lock()
        self.connection = Connection(bridge, self)
        self._calls = Calls(self.connection, places)
        self._publishing = Publishing(self.connection, advertised)
        self._answers = Answers(link, self._calls, self._services, adapters, writer, timeout, self._advance)
        self._settling = Settling(writer.store, self._answers, self._send_now, self._advance)
        self._heartbeat = Heartbeat(
            link,
            self._calls,
            self._services,
            telemetry.counter.round_trips,
            telemetry.topic_silence,
            writer.apply,
            lambda: writer.store.state.links[link].barred,
            asks_node,
        )

    def on_connecting(self) -> None:
        """Report that a connection attempt has begun."""

    def on_open(self) -> None:
        """Check whether commands get through, now and from now on."""
        self._heartbeat.start()
        self._publishing.start()

    def on_lost(self, reason: Message, next_try_in: float) -> None:
        """End every open command: its answer can't arrive any more."""
        self._calls.on_lost()
        self._settling.on_lost()
        self._publishing.stop()
        self._heartbeat.stop(reason or Message("connection lost"))

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """Take a frame: only answers arrive here."""
        operation = decoded(self._writer.tap, self._link, payload, is_binary)
        if not isinstance(operation, operations.ServiceResponse):
            return
        self._heartbeat.take(operation)
        if not self._calls.on_response(operation):
            LOG.warning("late reply to %s: %s", truncate(operation.id), truncate(said(operation.values)))

    def on_sent(self, payload: bytes) -> None:
        """Report a sent call to the tap."""
        if self._writer.tap is not None:
            self._writer.tap.on_sent(self._link, "commands", payload)

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        """Ignore it: no answer to a command is that large."""
        LOG.warning("a reply of %d bytes was dropped", size)

    def submit(self, command_id: int, command: Command, given_at: float) -> None:
        """Send a command that was given at `given_at` (monotonic), before anything else happens.

        Only on a new connection, while the types of services are being fetched, it waits briefly, with later
        commands behind it; a pause waits only for the type of its own service.
        """
        LOG.info("command %d: %s", command_id, truncate(str(command)))
        is_new = self._services.is_new
        if isinstance(command, PauseRobot) and is_new:
            self._keep(asyncio.ensure_future(self._submit_pause(command_id, command, given_at)))
        elif not isinstance(command, PauseRobot) and (
            is_new or self._in_turn.locked() or isinstance(command, SetUpCommand)
        ):
            self._keep(asyncio.ensure_future(self._submit_in_turn(command_id, command, given_at)))
        else:
            self._submit(command_id, command, given_at)

    async def _submit_pause(self, command_id: int, command: PauseRobot, given_at: float) -> None:
        began = time.monotonic()
        self._pauses[command_id] = command, given_at
        with suppress(CommandError):  # as it is submitted, that is reported
            outgoing = self._made(command, command_id)
            await self._services.learn([one.address for one in outgoing], self._calls, TYPE_WITHIN)
        if self._pauses.pop(command_id, None):
            self._submit(command_id, command, given_at, min(time.monotonic() - began, TYPE_WITHIN))

    async def _submit_in_turn(self, command_id: int, command: Command, given_at: float) -> None:
        began = time.monotonic()
        async with self._in_turn:
            await self._services.settle()
            waited = min(time.monotonic() - began, SETTLE_TIME)  # the rest is a process that stood still
            if isinstance(command, SetUpCommand) and not await self._has_listeners(command_id, command):
                return
            # A pause waits for nothing: the goal that it overtook must not drive the robot on.
            if reason := withdrawn(self._writer.store.state, command_id, given_at):
                self._advance(command_id, Stage.NOT_SENT, reason)
                return
            self._submit(command_id, command, given_at, waited)

    async def _has_listeners(self, command_id: int, command: Command) -> bool:
        """Prepare the topics of a command, and tell whether to send it: a bridge drops silently what no node
        takes."""
        try:
            outgoing = self._outgoing(command, command_id, 0.0)
            waits = [self._publishing.prepare(one) for one in outgoing if isinstance(one, Publication)]
            await asyncio.gather(check_listeners(self._calls, outgoing), asyncio.sleep(max(waits, default=0)))
        except (LinkError, CommandError) as problem:
            self._advance(command_id, Stage.NOT_SENT, message_of(problem))
            return False
        return True

    def _submit(self, command_id: int, command: Command, given_at: float, waited: float = 0.0) -> None:
        """`waited`: seconds for which it was held here on purpose."""
        at = time.monotonic()
        try:
            outgoing = self._outgoing(command, command_id, at - given_at - waited)
            first = outgoing[0] if outgoing else None
            if isinstance(first, ActionGoal):
                self._keep(asyncio.ensure_future(self._goals.give(command_id, command, first, given_at)))
                return
            calls = self._send(outgoing)
        except (LinkError, CommandError) as problem:
            self._advance(command_id, Stage.NOT_SENT, message_of(problem))
            return
        names = [one.name for one in outgoing if isinstance(one, Publication)]
        self._advance(command_id, Stage.SENT, at=at, name=names[0] if names else "")
        if isinstance(command, Settle):
            self._keep(asyncio.ensure_future(self._settling.run(command_id, command, calls, at)))
        elif calls:
            self._keep(asyncio.ensure_future(self._answers.wait(command_id, command, calls, at)))
        elif any(isinstance(one, Publication) and one.is_request for one in outgoing):
            self._keep(call_awake(self._timeout, partial(self._not_answered, command_id)))
        elif not isinstance(command, PlaceOrder):  # which is taken when the robot lists it
            self._advance(command_id, Stage.ACCEPTED, UNANSWERED if outgoing else EMPTY)

    def _not_answered(self, command_id: int) -> None:
        """Report a request whose answer did not arrive in time, on its topic."""
        known = (one for one in self._writer.store.state.commands if one.id == command_id)
        if any(one.stage is Stage.SENT for one in known):
            self._advance(
                command_id,
                Stage.NO_ANSWER,
                Message("no reply within {timeout} s", timeout=f"{self._timeout:g}"),
            )

    def resend(self, command: Command) -> None:
        """Send a command once more; its answers are not reported."""
        with suppress(LinkError, CommandError):
            for _, call in self._send_now(command):
                self._calls.forget(call)

    def _send_now(self, command: Command) -> list[tuple[ServiceCall, PendingCall]]:
        """Send a command without a report. Raises LinkError or CommandError."""
        return self._send(self._outgoing(command, 0, 0.0))

    def _keep(self, task: "asyncio.Task[None]") -> None:
        """Hold a reference to a task, which could otherwise be garbage-collected while it runs."""
        self._under_way.add(task)
        task.add_done_callback(self._under_way.discard)

    def _outgoing(self, command: Command, command_id: int, late: float) -> Sequence[Outgoing]:
        """Return the outgoing calls and publications of a command. Raises CommandError or LinkError if it
        must not be sent."""
        if late > LATEST:
            raise CommandError(
                Message("console busy for {seconds} s: repeat the command", seconds=f"{late:.1f}")
            )
        # A pause is tried even if other commands are held back: it can only make things safer.
        if not isinstance(command, PauseRobot):
            if self._heartbeat.path is CommandPath.DEAD:
                raise LinkError(Message("no link for commands: {reason}", reason=self._heartbeat.reason))
            silent = self._silence()
            if silent > LONGEST_SILENCE:
                # A command sent into a frozen connection may be delivered, and obeyed, much later.
                raise LinkError(
                    Message("no message from the bridge for {seconds} s", seconds=f"{silent:.1f}")
                )
        outgoing = self._made(command, command_id)
        for one in outgoing:
            if not isinstance(command, PauseRobot):
                self._answers.check_allowed(one.address)
            if mismatch := self._services.mismatch(one.address):
                table = self._adapters[command.robot].names.table
                raise CommandError(
                    Message(
                        "{mismatch}: correct [{table}.services], or [{table}.service_types]",
                        mismatch=mismatch,
                        table=table,
                    )
                )
        return [one for one in outgoing if not self._lacks_server(one)]

    def _made(self, command: Command, command_id: int) -> Sequence[Outgoing]:
        """Return what a command is on the wire. Raises CommandError."""
        robot = self._writer.store.state.robots[command.robot]
        return self._adapters[command.robot].outgoing(command, command_id, robot, uuid.uuid4().hex)

    def _lacks_server(self, outgoing: Outgoing) -> bool:
        """Tell whether there is nobody to take a call, which would be an error in the log of the site."""
        server = outgoing.server if isinstance(outgoing, ServiceCall) else ""
        return server != "" and self._services.lacks_server(server)

    def _send(self, outgoing: Sequence[Outgoing]) -> list[tuple[ServiceCall, PendingCall]]:
        """Send calls and publications; the calls wait for answers. Raises LinkError."""
        calls = list[tuple[ServiceCall, PendingCall]]()
        for one in outgoing:
            match one:
                case ServiceCall(address, args=args):
                    calls.append((one, self._calls.start(address, args, self._timeout)))
                case Publication():
                    self._publishing.send(one)
                case ActionGoal():
                    raise CommandError(Message("goals are sent one at a time"))
        return calls

    def _advance(
        self, command_id: int, stage: Stage, detail: Message = EMPTY, at: float | None = None, name: str = ""
    ) -> None:
        level = logging.INFO if stage in (Stage.SENT, Stage.ACCEPTED) else logging.WARNING
        LOG.log(level, "command %d: %s %s", command_id, stage.value, truncate(detail))
        at = time.monotonic() if at is None else at
        self._writer.apply(CommandAdvanced(command_id, stage, at, detail, name))

    def close(self) -> None:
        """Close permanently; open commands end as unknown. A pause that still waits leaves first."""
        for command_id, (pause, given_at) in self._pauses.items():
            self._submit(command_id, pause, given_at, TYPE_WITHIN)
        self._pauses.clear()
        self._heartbeat.close()
        self._calls.on_lost()
        self._publishing.stop()
        self.connection.shut()
        self._goals.close()

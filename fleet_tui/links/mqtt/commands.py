"""Commands to the vehicles of one broker: sent now or not at all, answered by the states that follow."""

import asyncio
import itertools
import logging
import random
import time
import uuid
from collections.abc import Coroutine, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial

import msgspec

from fleet_tui.commands.abilities import unaccepted
from fleet_tui.commands.checks import CHECKS
from fleet_tui.links.patience import call_awake
from fleet_tui.links.transports.mqtt.connection import BrokerConnection
from fleet_tui.links.writer import Writer
from fleet_tui.model.commands import Command, PauseRobot, PlaceOrder, ResumeRobot, Stage
from fleet_tui.model.events import CommandAdvanced
from fleet_tui.model.problem import Problem
from fleet_tui.model.robot import Robot
from fleet_tui.model.vehicles.vehicle import Vehicle, VehicleError
from fleet_tui.orders.masters import VEHICLE_CHECKS, other_master
from fleet_tui.robots.adapter import Adapter, Publication
from fleet_tui.robots.vda5050.adapter import VehicleAdapter
from fleet_tui.robots.vda5050.answers import answer, error_text, failure_of
from fleet_tui.robots.vda5050.orders import NeverSeenError, address_of, is_field_open
from fleet_tui.robots.vda5050.topics import INSTANT_ACTIONS, ORDER
from fleet_tui.text.errors import CommandError, LinkError
from fleet_tui.text.language import EMPTY, Message, in_english, message_of
from fleet_tui.text.limits import truncate

LOG = logging.getLogger(__name__)

LATEST = 1.0
"""Seconds after which a command that waited for a stalled console is out of date."""
LONGEST_SILENCE = 2.5
"""Seconds without an answer of the broker after which a command may be delivered much later, or never."""
SEEN_WITHIN = 1.5
ADDRESSED_WITHIN = 0.2
"""Seconds for which a pause waits for the first message of its vehicle, without and with an address by the
configuration: what the broker has kept comes at once, and has the vehicle's own version."""
LATE_ANSWER = 60.0
"""Seconds after its deadline for which an answer still counts."""
FIRST_NUMBERS = 2**24
"""Header ids begin below this: 32 bits are theirs."""
OWN_KEPT = 1000
"""Number of ids of this console's messages that are remembered: a broker returns them."""


@dataclass
class AwaitedAnswer:
    """A command whose answer is awaited: `number` is the header id of its message; `is_echoed`: the broker
    returned it, or is not asked to; `complaints` are errors that the vehicle has had only since, and that
    name nothing."""

    command_id: int
    command: Command
    number: int
    timer: "asyncio.Task[None]"
    is_echoed: bool
    before: tuple[VehicleError, ...]
    complaints: tuple[VehicleError, ...] = ()
    is_late: bool = False


@dataclass
class HeldOrder:
    """An order that waits for the first state of its vehicle, or until that charges no more: `stop` is the id
    of the action that ends the charging, empty before the first state. `late` are the seconds by which it was
    delayed before; `accepted` are the objections that its operator knew."""

    command_id: int
    command: PlaceOrder
    late: float
    stop: str
    accepted: Mapping[str, Problem]
    timer: "asyncio.Task[None]"


LINK_LOST = Message("link lost")


class VehicleCommands:
    """Sends commands, and reports their progress. Runs on the network loop."""

    def __init__(
        self, connection: BrokerConnection, adapters: Mapping[str, Adapter], writer: Writer, timeout: float
    ) -> None:
        """`timeout` of an answer in seconds."""
        self._connection = connection
        self._writer = writer
        self.extend(adapters)
        self._timeout = timeout
        self._asked: dict[str, AwaitedAnswer] = {}
        """By the id of an order or action."""
        self._numbers: dict[str, itertools.count[int]] = {}
        """By topic: the next header id."""
        self._own: dict[str, None] = {}
        self.returned = set[tuple[str, str]]()
        """Robots and names of their topics that the broker returns to this console."""
        self._unseen: dict[str, asyncio.Event] = {}
        """By robot: set once a message of it has arrived for which a pause waits."""
        self._held: dict[str, HeldOrder] = {}
        """By robot."""
        self._under_way: set[asyncio.Task[None]] = set()

    def extend(self, adapters: Mapping[str, Adapter]) -> None:
        """Command further robots, too: all are given."""
        self._adapters = {name: one for name, one in adapters.items() if isinstance(one, VehicleAdapter)}

    def submit(self, command_id: int, command: Command, given_at: float) -> None:
        """Send a command that was given at `given_at` (monotonic)."""
        LOG.info("command %d: %s", command_id, truncate(str(command)))
        held = self._held.get(command.robot)
        if held is not None and held.command_id == command_id:
            return  # from this console's queue, where it waits as well
        if not isinstance(command, ResumeRobot):
            self._interrupt(command.robot, Message("another command came"))
        if isinstance(command, PauseRobot) and not self._is_seen(command.robot):
            self._start(self._pause_unseen(command_id, command, given_at))
            return
        try:
            late = time.monotonic() - given_at
            if not (isinstance(command, PlaceOrder) and self._holds(command_id, command, late)):
                self._send(command_id, command, given_at)
        except (LinkError, CommandError) as problem:
            self._advance(command_id, Stage.NOT_SENT, message_of(problem))

    def _holds(self, command_id: int, command: PlaceOrder, late: float) -> bool:
        """Ask a vehicle for its first state, or end its charging, if its order needs that; tell whether the
        order waits for it. Raises CommandError or LinkError if it must not be sent."""
        robot = self._writer.store.state.robots[command.robot]
        if not self._is_stated(robot):
            self._check(command, late)
            self._connection.check_open()
            with suppress(NeverSeenError):
                address_of(robot, ORDER)
            self.request_state(robot.name)
            unmet = Message(
                "no state from {name} within {timeout} s: repeat the order once it has sent one",
                name=robot.name,
                timeout=f"{self._timeout:g}",
            )
            self._hold(command_id, command, late, "", unmet, Message("for a state"))
            return True
        freeing = self._adapters[robot.name].stop_charging(robot, uuid.uuid4().hex)
        if freeing is None:
            return False
        self._messages(command, command_id, late)
        self._publish(freeing)
        unmet = Message(
            "{name} is still charging: it did not stop within {timeout} s",
            name=robot.name,
            timeout=f"{self._timeout:g}",
        )
        self._hold(command_id, command, late, freeing.name, unmet, Message("for the end of its charge"))
        return True

    def _is_stated(self, robot: Robot) -> bool:
        """Tell whether a state has arrived on this connection: one from before a loss may be history."""
        since = self._writer.store.state.links[robot.link].since
        return robot.vehicle is not None and robot.vehicle.at >= since

    def _hold(
        self, command_id: int, command: PlaceOrder, late: float, stop: str, unmet: Message, awaited: Message
    ) -> None:
        """Keep an order in this console's queue until `on_state` sends it; not sent in time, it has the
        reason `unmet`."""
        timer = call_awake(self._timeout, partial(self._give_up, command.robot, unmet))
        self._held[command.robot] = HeldOrder(
            command_id, command, late, stop, self._objections(command), timer
        )
        self._writer.apply(CommandAdvanced(command_id, Stage.WAITING, time.monotonic(), awaited))

    def _objections(self, command: PlaceOrder) -> Mapping[str, Problem]:
        """Return what speaks against an order: what is about the vehicle by its text, as two faults are not
        the same, the rest by its check, as its texts have ages and what is not known yet."""
        state = self._writer.store.state
        robot = state.robots[command.robot]
        return {
            problem.text if check in VEHICLE_CHECKS else problem.check: problem
            for check in CHECKS
            for problem in check(state, robot, command)
        }

    def _give_up(self, robot: str, reason: Message) -> None:
        """Do not send the order that is held for a vehicle, if there is one."""
        if (held := self._held.pop(robot, None)) is not None:
            held.timer.cancel()
            self._advance(held.command_id, Stage.NOT_SENT, reason)

    def _interrupt(self, robot: str, why: Message) -> None:
        """Do not send the order that is held for a vehicle, because of what happened meanwhile."""
        if (held := self._held.get(robot)) is not None:
            told = Message("{why} after the command to stop charging", why=why)
            self._give_up(robot, told if held.stop else Message("{why} before its first state", why=why))

    def _release(self, held: HeldOrder) -> None:
        """Send an order that was held, if nothing speaks against it that its operator did not know."""
        del self._held[held.command.robot]
        held.timer.cancel()
        state = self._writer.store.state
        if any(one.id == held.command_id and one.is_decided for one in state.commands):
            return  # it was cancelled in this console's queue
        new = [one for key, one in self._objections(held.command).items() if key not in held.accepted]
        try:
            if reason := state.robots[held.command.robot].held:
                raise CommandError(reason)
            if new:
                raise CommandError(min(new, key=lambda one: not one.blocks).text)
            if held.stop or not self._holds(held.command_id, held.command, held.late):
                # It waited by intent: only what delayed it before counts.
                self._send(held.command_id, held.command, time.monotonic() - held.late)
        except (LinkError, CommandError) as problem:
            self._advance(held.command_id, Stage.NOT_SENT, message_of(problem))

    def _is_seen(self, name: str) -> bool:
        robot = self._writer.store.state.robots[name]
        return robot.vehicle is not None or robot.connection is not None

    def request_state(self, name: str) -> None:
        """Ask a vehicle for its state, if none has arrived on this connection and this console may command
        it."""
        robot = self._writer.store.state.robots[name]
        if not self._is_stated(robot) and robot.kind.accepts:
            self._start(self._request_state(name))

    async def _request_state(self, name: str) -> None:
        arrived = self._unseen.setdefault(name, asyncio.Event())
        if not self._is_seen(name):
            with suppress(TimeoutError):
                await asyncio.wait_for(arrived.wait(), SEEN_WITHIN)
        robot = self._writer.store.state.robots[name]
        if self._is_stated(robot):
            return
        try:
            for message in self._adapters[name].state_request(robot, uuid.uuid4().hex):
                self._publish(message)
        except (LinkError, CommandError) as problem:
            LOG.info("state of %s not requested: %s", name, problem)

    def _start(self, sending: Coroutine[None, None, None]) -> None:
        task = asyncio.ensure_future(sending)
        self._under_way.add(task)
        task.add_done_callback(self._under_way.discard)

    async def _pause_unseen(self, command_id: int, command: PauseRobot, given_at: float) -> None:
        """Pause a vehicle as soon as it is known where it listens."""
        late, reason = time.monotonic() - given_at, EMPTY
        arrived = self._unseen.setdefault(command.robot, asyncio.Event())
        for patience in (ADDRESSED_WITHIN, SEEN_WITHIN - ADDRESSED_WITHIN):
            with suppress(TimeoutError):
                await asyncio.wait_for(arrived.wait(), patience)
            try:
                # It waits by intent: only what delayed it before counts.
                self._send(command_id, command, time.monotonic() - late)
            except NeverSeenError as problem:
                reason = message_of(problem)
            except (LinkError, CommandError) as problem:
                reason = message_of(problem)
                break
            else:
                return
        self._advance(command_id, Stage.NOT_SENT, reason)

    def _send(self, command_id: int, command: Command, given_at: float) -> None:
        """Send a command. Raises CommandError or LinkError if it must not be sent."""
        messages = self._messages(command, command_id, time.monotonic() - given_at)
        numbers = [self._publish(message) for message in messages]
        message, number = messages[0], numbers[0]
        name = message.name if isinstance(command, PlaceOrder) else ""
        self._writer.apply(CommandAdvanced(command_id, Stage.SENT, time.monotonic(), EMPTY, name))
        timer = call_awake(self._timeout, partial(self._overdue, message.name))
        robot = self._writer.store.state.robots[command.robot]
        before = robot.vehicle.value.errors if robot.vehicle is not None else ()
        topic = ORDER if isinstance(command, PlaceOrder) else INSTANT_ACTIONS
        is_echoed = (command.robot, topic) not in self.returned
        self._asked[message.name] = AwaitedAnswer(command_id, command, number, timer, is_echoed, before)

    def _messages(self, command: Command, command_id: int, late: float) -> Sequence[Publication]:
        """Return the messages of a command. Raises CommandError or LinkError if it must not be sent."""
        self._check(command, late)
        robot = self._writer.store.state.robots[command.robot]
        found = self._adapters[robot.name].outgoing(command, command_id, robot, uuid.uuid4().hex)
        messages = [one for one in found if isinstance(one, Publication)]
        if len(messages) != len(found):
            raise CommandError(Message("a broker carries only messages"))
        return messages

    def _check(self, command: Command, late: float) -> None:
        """Raise CommandError or LinkError if a command must not be sent."""
        if late > LATEST:
            raise CommandError(
                Message("console busy for {seconds} s: repeat the command", seconds=f"{late:.1f}")
            )
        # A pause is tried even if other commands are held back: it can only make things safer.
        if not isinstance(command, PauseRobot) and self._connection.silence > LONGEST_SILENCE:
            raise LinkError(
                Message("no reply from the broker for {seconds} s", seconds=f"{self._connection.silence:.1f}")
            )
        state = self._writer.store.state
        robot = state.robots[command.robot]
        if reason := unaccepted(state, command) or other_master(time.monotonic(), robot, command):
            raise CommandError(reason)

    def _publish(self, message: Publication) -> int:
        """Send a message with its header, and return the header's id. Raises LinkError."""
        # A rejection of an earlier console's first message may still be in the states: not of ours.
        start = random.randrange(1, FIRST_NUMBERS)
        number = next(self._numbers.setdefault(message.address, itertools.count(start)))
        stamp = datetime.now(UTC).isoformat(timespec="milliseconds").replace("+00:00", "Z")
        header = {"headerId": number, "timestamp": stamp, "version": message.type}
        self._remember(message.name)
        self._connection.publish(
            message.address, msgspec.json.encode({**header, **message.message}, enc_hook=in_english)
        )
        return number

    def _remember(self, id_: str) -> None:
        self._own[id_] = None
        if len(self._own) > OWN_KEPT:
            del self._own[next(iter(self._own))]

    def is_own(self, ids: tuple[str, ...]) -> bool:
        """Tell whether a message with these ids is one of this console, as the broker returned it."""
        for id_ in ids:
            if (asked := self._asked.get(id_)) is not None:
                asked.is_echoed = True
        return bool(ids) and all(id_ in self._own for id_ in ids)

    def on_message(self, robot: str) -> None:
        """Note that a message of a vehicle has been taken."""
        if robot in self._unseen and self._is_seen(robot):
            self._unseen.pop(robot).set()

    def on_state(self, robot: str, vehicle: Vehicle) -> None:
        """Take a state: it may answer commands to its vehicle."""
        for id_, asked in list(self._asked.items()):
            if asked.command.robot != robot:
                continue
            new = [error for error in vehicle.errors if error not in asked.before and not error.references]
            asked.complaints = tuple(new) or asked.complaints
            found = answer(asked.command, id_, asked.number, vehicle)
            if found is None:
                continue
            if found[0] is Stage.SENT:
                self._wait_again(id_, asked)
            else:
                self._end(id_, *found)
        if (held := self._held.get(robot)) is None:
            return
        if not held.stop or vehicle.charging is False:  # not told is not ended
            self._release(held)
        elif failure := failure_of(held.stop, vehicle):
            self._give_up(
                robot, Message("{robot} is still charging: {failure}", robot=robot, failure=failure)
            )

    def _wait_again(self, id_: str, asked: AwaitedAnswer) -> None:
        """Wait for the end of an action that is being carried out: that is no missing answer."""
        if not asked.is_late:
            asked.timer.cancel()
            asked.timer = call_awake(self._timeout, partial(self._overdue, id_))

    def _end(self, id_: str, stage: Stage, detail: Message) -> None:
        asked = self._asked.pop(id_)
        asked.timer.cancel()
        if isinstance(asked.command, PlaceOrder) and stage is Stage.ACCEPTED:
            return  # its order in the queue confirms it
        if stage is Stage.CONFIRMED:
            self._advance(asked.command_id, Stage.ACCEPTED, detail)
        self._advance(asked.command_id, stage, detail)

    def _overdue(self, id_: str) -> None:
        asked = self._asked[id_]
        if asked.is_late:
            del self._asked[id_]
            return
        asked.is_late = True
        asked.timer = call_awake(LATE_ANSWER, partial(self._overdue, id_))
        why = EMPTY
        if asked.complaints:
            why = Message(", and it reports {error_text}", error_text=error_text(asked.complaints[0]))
        elif not asked.is_echoed:
            why = Message(", and the broker did not pass it on (rights?)")
        elif not isinstance(asked.command, PlaceOrder) and self._is_field_open(asked.command.robot):
            why = Message(', or it needs instant_actions = "instantActions" in [profile.vda5050]')
        detail = Message(
            "from {robot} in {timeout} s{why}: may still be carried out",
            robot=asked.command.robot,
            timeout=f"{self._timeout:g}",
            why=why,
        )
        self._advance(asked.command_id, Stage.NO_ANSWER, detail)

    def _is_field_open(self, name: str) -> bool:
        return is_field_open(self._adapters[name].settings, self._writer.store.state.robots[name])

    def on_lost(self, why: Message = LINK_LOST) -> None:
        """End every open command: its answer may have been missed."""
        for robot in list(self._held):
            self._interrupt(robot, why)
        for id_ in list(self._asked):
            self._end(id_, Stage.UNKNOWN, Message("link lost before the reply: may still be carried out"))

    def _advance(self, command_id: int, stage: Stage, detail: Message) -> None:
        level = logging.INFO if stage in (Stage.ACCEPTED, Stage.CONFIRMED) else logging.WARNING
        LOG.log(level, "command %d: %s %s", command_id, stage.value, truncate(detail))
        self._writer.apply(CommandAdvanced(command_id, stage, time.monotonic(), detail))

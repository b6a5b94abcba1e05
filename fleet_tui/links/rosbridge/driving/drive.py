"""One drive of a robot by hand, on a connection that is opened for it and shut after it."""

import asyncio
import logging
import time

from fleet_tui.commands.driving.session import FOREIGN, DriveSession
from fleet_tui.commands.driving.speed import Caps
from fleet_tui.config.schema import Link
from fleet_tui.links.rosbridge.answers import decoded
from fleet_tui.links.rosbridge.calls import Calls
from fleet_tui.links.rosbridge.set_up.listeners import ask, is_bridge
from fleet_tui.links.transports.loop import call_now
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.links.transports.rosbridge.unsent import unsent
from fleet_tui.links.writer import Writer
from fleet_tui.model.set_up.driving import DrivePhase, DriveState, Speeds, Steering
from fleet_tui.robots.ros import operations
from fleet_tui.robots.ros.set_up.names import STAMPED_TWIST, TWIST
from fleet_tui.robots.ros.set_up.twists import is_stamped, read_twist, twist_message
from fleet_tui.text.errors import CommandError, LinkError, WireError
from fleet_tui.text.language import Message, message_of
from fleet_tui.text.limits import truncate

LOG = logging.getLogger(__name__)

HANDOVER = 0.005
"""Maximum seconds to wait for the network thread to take a key."""
END_WITHIN = 0.05
"""Maximum seconds to wait until the last zeros have left."""
OPEN_WITHIN = 2.0
"""Seconds for the connection."""

WITHIN = 1.0
"""Seconds for the answers of rosapi. Without them no drive begins."""


async def twist_type(calls: Calls, topic: str) -> str:
    """Return the type of a topic on which a robot takes twists. Raises CommandError."""
    type_, nodes = await asyncio.gather(
        ask(calls, "topic_type", {"topic": topic}, "type", WITHIN),
        ask(calls, "subscribers", {"topic": topic}, "subscribers", WITHIN),
    )
    if not isinstance(type_, str) or not isinstance(nodes, list):
        raise CommandError(Message("rosapi does not tell who listens on {topic}", topic=topic))
    if all(is_bridge(node) for node in nodes):
        raise CommandError(Message("nobody listens on {topic}", topic=topic))
    if is_stamped(type_) is None:
        raise CommandError(
            Message(
                "{topic} has type {actual}, not {twist} or {stamped_twist}",
                topic=topic,
                actual=truncate(type_),
                twist=TWIST,
                stamped_twist=STAMPED_TWIST,
            )
        )
    return type_


class Drive:
    """Follows a hand until it ends, for whatever reason: then zeros leave and the connection is shut, so that
    nothing is ever sent after a reconnection. `steer` and `end` from any thread, all else on the network
    loop."""

    def __init__(
        self, link: str, bridge: Link, writer: Writer, topic: str, caps: Caps, places: asyncio.Semaphore
    ) -> None:
        """`places` as for Calls."""
        self._link = link
        self._writer = writer
        self._topic = topic
        self._session = DriveSession(caps, topic)
        self._connection = Connection(bridge, self)
        self._calls = Calls(self._connection, places)
        self._type = ""
        """Empty until the topic is advertised."""
        self._steering = Steering()
        self._timer: asyncio.TimerHandle | None = None
        self._is_shut = False
        self._starting: asyncio.Task[None] | None = None

    @property
    def state(self) -> DriveState:
        """Return the newest state."""
        return self._session.state

    def open(self) -> None:
        """Connect. From any thread."""
        self._writer.loop.call_soon_threadsafe(self._open)

    def _open(self) -> None:
        self._connection.connect()
        self._timer = self._writer.loop.call_later(
            OPEN_WITHIN, self._end, Message("no link: bridge not responding")
        )

    def steer(self, steering: Steering) -> None:
        """Drive as the hand asks; the newest counts."""
        self._steering = steering
        call_now(self._steer, HANDOVER)

    def end(self, reason: Message) -> None:
        """Stop the robot and end; the first reason counts. Returns once the zeros left, or soon after."""
        call_now(lambda: self._end(reason), END_WITHIN)

    def _steer(self) -> None:
        self._send(self._session.steer(self._steering, time.monotonic(), not unsent(self._connection)))

    def _tick(self) -> None:
        self._timer = None
        self._send(self._session.tick(time.monotonic(), not unsent(self._connection)))

    def _send(self, frames: list[Speeds]) -> None:
        """Send frames, and see to the next tick."""
        stamped = bool(is_stamped(self._type))
        try:
            for speeds in frames:
                message = twist_message(speeds, stamped)
                self._connection.send(operations.publish(self._topic, self._type, message))
        except LinkError:
            self._end(Message("link lost"))
        if self.state.phase is DrivePhase.ENDED:
            self._shut()
        elif self._session.is_active and self._timer is None:
            self._timer = self._writer.loop.call_later(self._session.next_in, self._tick)

    def _end(self, reason: Message) -> None:
        """Stop and shut. Before the topic is advertised there is nothing to stop."""
        frames = self._session.end(reason)
        if frames and self._type:
            self._send(frames)
        self._shut()

    def _shut(self) -> None:
        if self._is_shut:
            return
        self._is_shut = True
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        self._connection.shut()

    async def _start(self) -> None:
        """Look at the topic, listen on it ourselves, and begin. Frames of others end it before it began."""
        try:
            type_ = await twist_type(self._calls, self._topic)
            subscription = operations.Subscription(self._topic, type_, queue_length=10)
            self._connection.send(operations.subscribe(subscription))
            self._connection.send(operations.advertise_newest(self._topic, type_))
        except (CommandError, LinkError) as problem:
            self._end(message_of(problem))
            return
        if self.state.phase is DrivePhase.STARTING:
            self._type = type_
            self._send(self._session.begin(time.monotonic()))

    def on_connecting(self) -> None:
        """Do nothing: a connection attempt has begun."""

    def on_open(self) -> None:
        """Look at the topic."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        self._starting = asyncio.ensure_future(self._start())

    def on_lost(self, reason: str, next_try_in: float) -> None:
        """End: the robot must stop by itself."""
        self._calls.on_lost()
        self._end(
            Message(
                "{what}: {reason}",
                what=Message("link lost") if self._type else Message("no link"),
                reason=reason,
            )
        )

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """Take an answer of rosapi, or a frame of the topic."""
        match decoded(self._writer.tap, self._link, payload, is_binary):
            case operations.ServiceResponse() as response:
                self._calls.on_response(response)
            case operations.Publish(topic=topic, msg=msg) if topic == self._topic:
                self._take(msg)

    def _take(self, msg: object) -> None:
        try:
            speeds = read_twist(msg, bool(is_stamped(self._type)))
        except WireError as problem:
            LOG.warning("%s: %s", self._topic, problem)
            self._end(FOREIGN)
            return
        self._send(self._session.received(speeds, time.monotonic()))

    def on_sent(self, payload: bytes) -> None:
        """Report a sent frame to the tap."""
        if self._writer.tap is not None:
            self._writer.tap.on_sent(self._link, "commands", payload)

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        """End: no twist is that large."""
        self._end(FOREIGN)

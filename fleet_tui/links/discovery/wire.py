"""The doctor's own connection. It subscribes, and calls /rosapi/* and the queries named by adapters."""

import asyncio
import re
import time
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.facts import TopicFacts, key_of
from fleet_tui.links.rosbridge.calls import OWN_WORD, TIME, Calls, rosapi_places
from fleet_tui.links.rosbridge.probes import Pulse
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.maps.levels import read_levels
from fleet_tui.model.events import Event, GraphReceived, PoseReported
from fleet_tui.model.fleets.events import MemberReported
from fleet_tui.model.kind import CAMERA
from fleet_tui.model.navigation_events import OdometryReported
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.ros import operations
from fleet_tui.robots.ros.logs import LOG_TYPES, complaint, log_line, not_allowed
from fleet_tui.robots.ros.operations import Subscription
from fleet_tui.robots.ros.reading import ROSOUT
from fleet_tui.text.errors import LinkError, WireError
from fleet_tui.text.language import EMPTY, Message

if TYPE_CHECKING:  # with numpy
    from fleet_tui.model.set_up.streams import StreamValue

LARGE_FRAME = 100_000
LOOKUPS = 100  # more than are asked at once: `places` limits them by the version of ROS
QUEUE = 100  # log lines that the bridge queues for us
NAMED = re.compile(r'"topic":\s*"(?P<topic>[^"]+)"')
FROZEN = Message("accepts connections but does not respond: restart it")


@dataclass(slots=True)
class TopicListening:
    """The messages of a topic so far. Monotonic seconds: `asked` for, and `since` when the bridge has
    certainly subscribed, which it does one by one. `look` reads the pictures of a camera."""

    wanted: Feed
    asked: float
    read: Callable[[Feed, object, float], Iterable[Event]]
    look: "Callable[[Feed, object], StreamValue] | None" = None
    since: float | None = None
    count: int = 0
    faults: int = 0
    first: float = 0.0
    last: float = 0.0
    event: Event | None = None
    problem: str = ""
    lag: float | None = None
    late: float | None = None
    retried: bool = False
    fragmented: int = 0
    held_by: str = ""
    picture: "StreamValue | None" = None
    events: dict[str, Event] = field(default_factory=dict)
    """The last event of each robot, of maps without one of each floor."""
    lags: dict[str, float] = field(default_factory=dict)

    def take(self, msg: object, at: float) -> None:
        """Take one message, still encoded."""
        try:
            found = list(self.read(self.wanted, msg, at))
            self.picture = self.look(self.wanted, msg) if self.look else None
        except WireError as problem:
            self.faults = self.faults + 1
            self.problem = str(problem)
        else:
            for event in found:
                self._keep(event, at)
        # Last: another thread may read the facts while a large map is processed.
        self.first = self.first or at
        self.last = at
        self.count += 1

    def _keep(self, event: Event, at: float) -> None:
        self.event = event
        self.events[key_of(event)] = event
        if isinstance(event, GraphReceived) and event.faults:
            self.faults = self.faults + event.faults
            self.problem = event.fault
        if isinstance(event, PoseReported | OdometryReported | MemberReported) and event.stamp is not None:
            lag = self.lags[event.robot] = time.time() - (time.monotonic() - at) - event.stamp
            self.lag = lag if self.lag is None else min(self.lag, lag)
            self.late = lag - self.lag

    def facts(self, now: float) -> TopicFacts:
        span = self.last - self.first
        return TopicFacts(
            self.wanted,
            subscribed=True,
            waited=now - self.since if self.since else 0.0,
            count=self.count,
            faults=self.faults,
            rate=(self.count - 1) / span if self.count > 1 and span > 0 else None,
            first_after=self.first - self.asked if self.count else None,
            age=now - self.last if self.count else None,
            event=self.event,
            problem=self.problem,
            lag=self.lag,
            late=self.late,
            retried=self.retried,
            fragmented=self.fragmented,
            held_by=self.held_by,
            picture=self.picture,
            events=self.events,
            lags=self.lags,
        )


class BridgeConnection:
    """One bridge, connected once. Everything runs on the network loop."""

    def __init__(
        self,
        bridge: Link,
        adapters: Mapping[str, Adapter] = MappingProxyType({}),
        places: asyncio.Semaphore | None = None,
    ) -> None:
        """`places` for questions to rosapi, if other connections to the bridge share them."""
        self.connection = Connection(bridge, self)
        self.places = places or rosapi_places()
        self.adapters = adapters
        """By robot, for the robots whose topics are subscribed."""
        self.lost = EMPTY
        """The reason that there is no connection."""
        self.listening: dict[str, TopicListening] = {}
        """Received messages, by topic."""
        self.complaints: dict[str, str] = {}
        """Messages of the bridge's log on topics that it did not subscribe to."""
        self.barred: set[str] = set()
        """Services that the bridge does not allow, by its log."""
        self.behind = 0.0
        """Maximum delay in seconds with which this process read messages."""
        self.arrived = asyncio.Event()
        """Set whenever a message has arrived, and when no more will."""
        self._settled = asyncio.Event()
        self._calls = Calls(self.connection, asyncio.Semaphore(LOOKUPS))
        self._decoder = ThreadPoolExecutor(1, thread_name_prefix="fleet-tui-decode")

    async def connect(self, within: float) -> str:
        """Connect; returns the reason for a failure, "" on success."""
        self.connection.connect()
        try:
            await asyncio.wait_for(self._settled.wait(), within)
        except TimeoutError:
            self.lost = FROZEN
        return self.lost

    async def call(self, service: str, args: Mapping[str, object], within: float) -> object:
        """Call a service; returns its answer, a string if it fails. Raises LinkError without an answer."""
        if self.lost:
            raise LinkError(self.lost)
        return (await self._calls.call(service, args, within)).values

    async def beat(self, within: float) -> str:
        """Make the bridge itself answer; returns its text. Raises LinkError without an answer."""
        return str(await self.call(OWN_WORD, {}, within))

    async def allows_nothing(self, within: float) -> bool:
        """Tell whether a bridge that does not answer dropped the call: its log says so. Every bridge writes
        one, so that a subscription with the type of the other ROS does no harm."""
        with suppress(LinkError):
            for type_ in LOG_TYPES:
                self.subscribe_logs(type_)
            await self.beat(within)
        return OWN_WORD in self.barred

    async def is_mute(self, within: float) -> bool:
        """Tell whether the bridge has a node that does not answer, as if its ROS thread had ended. Raises
        LinkError without a connection."""
        pulse = Pulse(self._calls)
        return await pulse.of_ros(within, skip=TIME) is None and pulse.is_mute

    def subscribe(self, wanted: Feed, type_: str, latched: bool) -> None:
        """Subscribe to every message of a topic, to pictures at the rate of the console. Raises LinkError."""
        adapter, is_camera = self.adapters[wanted.robot], wanted.stream_key == CAMERA
        look = adapter.stream if is_camera else None
        read = (lambda _feed, msg, at: read_levels(msg, at)) if wanted.has_pictures else adapter.read
        self.listening[wanted.address] = TopicListening(wanted, time.monotonic(), read, look)
        compression = "cbor" if wanted.large else "none"
        rate = wanted.rate_ms if is_camera else 0  # the pictures of a fleet would fill its network
        subscription = Subscription(wanted.address, type_, rate, compression, wanted.queue_length, latched)
        self.connection.send(operations.subscribe(subscription))

    def unsubscribe(self, topic: str) -> None:
        """Unsubscribe from a topic. Raises LinkError."""
        self.connection.send(operations.unsubscribe(topic))

    def subscribe_plainly(self, wanted: Feed, type_: str) -> None:
        """Subscribe to a topic once more, as JSON and with the bridge's own QoS. Raises LinkError."""
        topic = wanted.address
        self.listening[topic].retried = True
        self.connection.send(operations.subscribe(Subscription(topic, type_)))

    def subscribe_logs(self, type_: str) -> None:
        """Subscribe to the bridge's log for messages on our subscriptions. Raises LinkError."""
        self.connection.send(operations.subscribe(Subscription(ROSOUT, type_, queue_length=QUEUE)))

    def close(self) -> None:
        """Close permanently; subscriptions end with the connection."""
        self.connection.shut()
        self._decoder.shutdown(wait=False, cancel_futures=True)

    def on_connecting(self) -> None:
        """Do nothing: a connection attempt has begun."""

    def on_open(self) -> None:
        """Allow frames to be sent."""
        self._settled.set()

    def on_lost(self, reason: Message, next_try_in: float) -> None:
        """End at the first loss: later measurements would be of another connection."""
        self.lost = self.lost or reason or Message("connection lost")
        self.connection.shut()
        self._calls.on_lost()
        self._settled.set()
        self.arrived.set()

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """Take an answer or a message; long ones are read off the loop."""
        at = time.monotonic()
        if len(payload) < LARGE_FRAME:
            self._answered(self._read(payload, is_binary, at))
            return
        loop = asyncio.get_running_loop()
        reading = loop.run_in_executor(self._decoder, self._read, payload, is_binary, at)
        reading.add_done_callback(lambda done: None if done.cancelled() else self._answered(done.result()))

    def _read(self, payload: bytes, is_binary: bool, at: float) -> operations.ServiceResponse | None:
        try:
            read = operations.decode_cbor(payload) if is_binary else operations.decode(payload)
        except WireError:
            return None
        if isinstance(read, operations.Publish) and read.topic in self.listening:
            self.listening[read.topic].take(read.msg, at)
        elif isinstance(read, operations.Publish) and read.topic == ROSOUT:
            self._read_log(read.msg, at)
        elif isinstance(read, operations.Fragment):
            self._fragment(read)
        return read if isinstance(read, operations.ServiceResponse) else None

    def _read_log(self, msg: object, at: float) -> None:
        with suppress(WireError):
            said = log_line(msg, at)
            self.barred |= {not_allowed(said, "service"), not_allowed(said, "action")} - {""}
            if about := complaint(said):
                self.complaints[about[0]] = about[1]

    def _fragment(self, piece: operations.Fragment) -> None:
        """Record the size of a fragmented message, by its first fragment."""
        named = NAMED.search(piece.data.replace("\\/", "/")) if piece.num == 0 else None
        if named and named["topic"] in self.listening:
            self.listening[named["topic"]].fragmented = len(piece.data) * piece.total

    def _answered(self, response: operations.ServiceResponse | None) -> None:
        self.arrived.set()
        if response is not None:
            self._calls.on_response(response)

    def on_sent(self, payload: bytes) -> None:
        """Ignore a sent frame."""

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        """Record at its topic that a message over the limit of the config was dropped."""
        plain = head.replace(rb"\/", b"/")
        for topic, received in self.listening.items():
            if topic.encode() in plain:
                received.count += 1
                received.faults += 1
                received.problem = f"a message of {size / 1e6:.1f} MB exceeds the limit: raise max_message_mb"

"""The connection for pictures of cameras, open only while one is watched: they delay no telemetry."""

import asyncio
import time
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress

from msgspec.structs import replace

from fleet_tui.config.schema import Link
from fleet_tui.links.rosbridge.calls import Calls
from fleet_tui.links.rosbridge.set_up.listeners import ask
from fleet_tui.links.rosbridge.subscriber import Subscriber
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.model.events import MessageRejected
from fleet_tui.model.kind import CAMERA
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.ros import operations
from fleet_tui.robots.ros.reading import FrameReader, Read, StreamSink
from fleet_tui.robots.ros.type_names import type_problem
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import Message, verbatim
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

LARGEST_MB = 6.0
"""Megabytes of a message: those of the largest picture, as base64."""
LARGE_FRAME = 100_000
"""Bytes of a message above which it is read off the loop."""
CBOR_PATIENCE = 8.0
"""Seconds without a picture after which it is requested as JSON: an old bridge knows no CBOR."""


PUBLISHERS_WITHIN = 2.0
"""Seconds for rosapi to tell who publishes a topic."""


class CameraChannel:
    """Subscribes to the cameras that are watched, over a connection of its own. Runs on the network loop."""

    def __init__(
        self,
        bridge: Link,
        feeds: Iterable[Feed],
        adapters: Mapping[str, Adapter],
        subscriber: Subscriber,
        reading: FrameReader,
        sink: StreamSink,
        places: asyncio.Semaphore,
    ) -> None:
        """`adapters` by robot; `subscriber` of the same bridge knows the types of topics; `places` as for
        Calls."""
        self._places = places
        self._bridge = replace(bridge, max_message_mb=min(bridge.max_message_mb, LARGEST_MB))
        self._cameras = [feed for feed in feeds if feed.stream_key == CAMERA]
        self._adapters = adapters
        self._subscriber = subscriber
        self._reading = reading
        self._sink = sink
        self._connection: Connection | None = None
        self._calls: Calls | None = None
        self._questions: set[asyncio.Task[None]] = set()
        self._wanted: frozenset[Feed] = frozenset()
        self._timers: dict[Feed, asyncio.TimerHandle] = {}
        self._reader = ThreadPoolExecutor(1, thread_name_prefix="fleet-tui-camera")
        self._is_reading = False

    def look(self) -> None:
        """Subscribe to the cameras that are watched by now, and unsubscribe from the others."""
        wants = self._sink.wants
        self._watch(feed for feed in self._cameras if any(wants(robot, CAMERA) for robot in feed.robots))

    def _watch(self, feeds: Iterable[Feed]) -> None:
        """Connect for the first camera, and disconnect after the last."""
        wanted, before = frozenset(feeds), self._wanted
        self._wanted = wanted
        for feed in before - wanted:
            self._unsubscribe(feed)
        if not wanted:
            self._disconnect()
        elif self._connection is None:
            self._connection = Connection(self._bridge, self)
            self._calls = Calls(self._connection, self._places)
            self._connection.connect()
        elif self._connection.is_connected:
            for feed in wanted - before:
                self._subscribe(feed, "cbor")

    def on_connecting(self) -> None:
        """Do nothing: a connection attempt has begun."""

    def on_open(self) -> None:
        """Subscribe to what is watched."""
        for feed in self._wanted:
            self._subscribe(feed, "cbor")

    def on_lost(self, reason: Message, next_try_in: float) -> None:
        """Report that no pictures come."""
        self._cancel_timers()
        if self._calls is not None:
            self._calls.on_lost()
        for feed in self._wanted:
            self._report(feed, Message("no link for pictures: {reason}", reason=reason))

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """Read a picture, off the loop if it is large; those that arrive meanwhile are dropped."""
        at = time.monotonic()
        if len(payload) < LARGE_FRAME:
            self._take(self._reading.read(payload, is_binary, at))
        elif not self._is_reading:
            self._is_reading = True
            loop = asyncio.get_running_loop()
            work = loop.run_in_executor(self._reader, self._reading.read, payload, is_binary, at)
            work.add_done_callback(self._has_read)

    def _has_read(self, done: "asyncio.Future[Read]") -> None:
        self._is_reading = False
        if not done.cancelled():
            self._take(done.result())

    def _take(self, read: Read) -> None:
        """Take an answer of rosapi, or report an unreadable picture; a readable one is in the sink."""
        if isinstance(read, operations.ServiceResponse) and self._calls is not None:
            self._calls.on_response(read)
        elif isinstance(read, Sequence):
            for event in read:
                if isinstance(event, MessageRejected):
                    self._report_to(event.robot, Message("unreadable: {text}", text=event.text))

    def on_sent(self, payload: bytes) -> None:
        """Do nothing: pictures are not recorded, nor that they were requested."""

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        """Report a picture that was dropped on arrival."""
        self._reading.too_large(head, is_binary, size, time.monotonic())
        for feed in self._wanted:
            self._report(
                feed,
                Message("{size} MB a picture: lower its quality or size", size=f"{size / 1000000.0:.1f}"),
            )

    def _subscribe(self, feed: Feed, compression: str) -> None:
        connection, types = self._connection, self._subscriber.types
        problem = type_problem(feed, types, self._adapters[feed.robot].names.table)
        self._reading.counter.topics[feed.address].not_subscribed = problem
        if problem:
            self._report(feed, problem)
        if problem or connection is None:
            return
        type_ = types.get(feed.address, feed.type)
        asked = operations.Subscription(feed.address, type_, feed.rate_ms, compression, feed.queue_length)
        with suppress(LinkError):
            connection.send(operations.subscribe(asked))
            came = _pictures(self._reading, feed)
            question = asyncio.ensure_future(self._look_for_publisher(feed, came))
            self._questions.add(question)
            question.add_done_callback(self._questions.discard)
            if compression == "cbor":
                later = asyncio.get_running_loop().call_later
                self._timers[feed] = later(CBOR_PATIENCE, self._request_as_json, feed, came)

    def _request_as_json(self, feed: Feed, came: int) -> None:
        if feed in self._wanted and _pictures(self._reading, feed) == came:
            self._unsubscribe(feed)
            self._subscribe(feed, "none")

    async def _look_for_publisher(self, feed: Feed, came: int) -> None:
        """Report a topic without a publisher: its kind names a camera that this robot need not have."""
        assert self._calls is not None
        nodes = await ask(self._calls, "publishers", {"topic": feed.address}, "publishers", PUBLISHERS_WITHIN)
        if nodes == [] and feed in self._wanted and _pictures(self._reading, feed) == came:
            self._report(feed, Message("no camera: nothing publishes {address}", address=feed.address))

    def _unsubscribe(self, feed: Feed) -> None:
        if timer := self._timers.pop(feed, None):
            timer.cancel()
        if self._connection is not None:
            with suppress(LinkError):
                self._connection.send(operations.unsubscribe(feed.address))

    def _report(self, feed: Feed, reason: str) -> None:
        """Put the reason for the missing picture in its place."""
        for robot in feed.robots:
            self._report_to(robot, reason)

    def _report_to(self, robot: str, reason: str) -> None:
        from fleet_tui.model.set_up.streams import CameraImage  # with numpy: only who watches waits for it

        self._sink.put(
            robot, CAMERA, CameraImage(b"", None, sanitize(verbatim(truncate(reason)))), time.monotonic()
        )

    def _cancel_timers(self) -> None:
        for timer in self._timers.values():
            timer.cancel()
        self._timers.clear()

    def _disconnect(self) -> None:
        self._cancel_timers()
        if self._connection is not None:
            self._connection.shut()
            self._connection = self._calls = None
        for question in self._questions:
            question.cancel()

    def close(self) -> None:
        self._watch(())
        self._reader.shutdown(wait=False, cancel_futures=True)


def _pictures(reading: FrameReader, feed: Feed) -> int:
    """Return the number of pictures that have come."""
    return reading.counter.topics[feed.address].count

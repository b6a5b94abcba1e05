"""Reads frames into events. Callable from any thread: only counters change here."""

import math
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol

from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.counters import LinkCounter, Raw, TopicCounter
from fleet_tui.model.link import ACTIONS_GLOB, SERVICES_GLOB
from fleet_tui.model.navigation_events import OdometryReported, OriginReported
from fleet_tui.robots.adapter import Adapter, Feed, Limit
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros import logs, operations
from fleet_tui.robots.ros.operations import topic_of
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import StreamValue

ROSOUT = "/rosout"
DIAGNOSTICS = "/diagnostics"
WORTH_A_PROCESS = 4 * 2**20
"""Bytes of a JSON map above which it is decoded in a separate process: smaller ones take less time than
starting one."""


class StreamTaken:
    """A message of a stream: its value went to the sink of streams."""


class StreamSink(Protocol):
    """Takes the values of watched streams."""

    def wants(self, robot: str, key: str) -> bool:
        """Tell whether a stream is watched."""

    def put(self, robot: str, key: str, value: "StreamValue", at: float) -> None:
        """Take a value that arrived at a monotonic second."""


Read = Sequence[events.Event] | operations.ServiceResponse | operations.Fragment | StreamTaken
DecodePictures = Callable[[object, float], Sequence[events.GridReceived]]
DecodePng = Callable[[str, Limit], bytes]
DecodeApart = Callable[[Profile, Feed, bytes], events.GridReceived]

# The start of a CBOR map: the key, then its text, shorter than 24 bytes or than 256.
_CBOR_TOPIC = re.compile(rb"\x65topic(?:([\x60-\x77])|\x78(.))", re.DOTALL)
# Events read element by element: they include the errors of single elements.
_IN_PARTS = events.QueueReported, events.GraphReceived, events.LabelsReceived


class FrameReader:
    """Reads the frames of one bridge."""

    def __init__(
        self,
        link: str,
        limit: Limit,
        adapters: Mapping[str, Adapter],
        feeds: Iterable[Feed],
        decode_apart: DecodeApart,
        warn: Callable[[str], None] = lambda _text: None,
        streams: StreamSink | None = None,
        decode_pictures: DecodePictures = lambda _msg, _at: (),
        called: Collection[str] = (),
        decode_png: DecodePng = lambda _data, _limit: b"",
    ) -> None:
        """`adapters` by robot; `decode_apart` decodes a large map in another process, `decode_pictures` maps
        that are pictures, `decode_png` the text in a picture; all raise WireError.
        `warn` logs a line; without `streams` none is read.
        `called` are the services and actions that this console calls: the log of a bridge tells of other
        clients' too."""
        self._called = called
        self._streams = streams
        self._link = link
        self._limit = limit
        self._adapters = adapters
        self._feeds = {feed.address: feed for feed in feeds}
        self._names = logs.RobotNames(adapters)
        self.complete = {
            ROSOUT,
            DIAGNOSTICS,
            *(one.address for one in self._feeds.values() if one.queue_length > 1),
        }
        """Topics of which every message counts, not only the newest."""
        self.poses = {one.address: one.robot for one in self._feeds.values() if one.fast}
        """The robot by each topic of poses, of which a newer one replaces the older."""
        self._decode_apart = decode_apart
        self._decode_pictures = decode_pictures
        self._decode_png = decode_png
        self._warn = warn
        self._taken: dict[tuple[type, str], float] = {}
        """When the last place of each robot was taken from a topic that several publishers share."""
        self.maps_received: set[str] = set()
        """Topics of maps of which one has come on this connection."""
        self.recount()

    def recount(self) -> None:
        """Reset the counters."""
        asked = [
            TopicCounter(topic, one.robot, one.key, one.latched and not one.silent, one.on_demand, one.silent)
            for topic, one in self._feeds.items()
        ]
        # Large frames are read off the loop: one count in a million may be lost, but no thread waits.
        self.counter = LinkCounter(self._link, [*asked, TopicCounter(ROSOUT), TopicCounter(DIAGNOSTICS)])

    def read(self, payload: bytes, is_binary: bool, at: float) -> Read:
        """Read one frame that arrived at a monotonic second."""
        self.counter.all.take(len(payload), at)
        try:
            if not is_binary and operations.is_png(payload):
                payload = self._decode_png(operations.png_of(payload), self._limit)
            if len(payload) > WORTH_A_PROCESS and not is_binary:
                feed = self._feeds.get(topic_of(payload))
                if feed is not None and feed.large:
                    return self._read_apart(feed, payload, at)
            operation = operations.decode_cbor(payload) if is_binary else operations.decode(payload)
        except WireError as problem:
            self.counter.failed(str(problem), payload, is_binary, at)
            return (events.FrameRejected(self._link, str(problem)),)
        match operation:
            case operations.Publish(topic, msg):
                counter = self.counter.topics.get(topic)
                if counter is None:
                    return ()
                counter.count_frame(payload, is_binary, at)
                found = self._translate(counter, msg, at)
                feed = self._feeds.get(topic)
                is_stream = feed is not None and feed.wanted_for in ("place", "stream")
                return StreamTaken() if is_stream and not found else found
            case operations.Status(level, text):
                self._warn(f"bridge ({truncate(level)}): {truncate(text)}")
                return (events.FrameRejected(self._link, f"bridge: {text}"),)
            case operations.GoalResult() | None:
                return ()
        return operation

    def _read_apart(self, feed: Feed, payload: bytes, at: float) -> Sequence[events.Event]:
        counter = self.counter.topics[feed.address]
        counter.count_frame(payload, False, at)
        profile = self._adapters[feed.robot].names.profile
        try:
            event = replace(self._decode_apart(profile, feed, payload), at=at)
        except WireError as problem:
            counter.failed(str(problem))
            return _rejected(feed, str(problem))
        self.maps_received.add(feed.address)
        return _of_none((event,)) if feed.is_shared else (event,)

    def _translate(self, counter: TopicCounter, msg: object, at: float) -> Sequence[events.Event]:
        feed = self._feeds.get(counter.topic)
        try:
            if feed is None:
                return tuple(self._read_log(counter.topic, msg, at))
            self._stream(feed, msg, at)
            adapter = self._adapters[feed.robot]
            found = tuple(
                self._decode_pictures(msg, at) if feed.has_pictures else adapter.read(feed, msg, at)
            )
            if feed.wanted_for == "place":
                found = tuple(event for event in found if self._is_due(feed, event, at))
        except WireError as problem:
            counter.failed(str(problem))
            return _rejected(feed, str(problem)) if feed else ()
        for event in found:
            if isinstance(event, _IN_PARTS) and event.fault:
                counter.failed(event.fault)
        if feed.large:
            self.counter.keep_one_map(counter)
            self.maps_received.add(feed.address)
        return _of_none(found) if feed.is_shared and feed.wanted_for == "map" else found

    def _is_due(self, feed: Feed, event: events.Event, at: float) -> bool:
        """Tell whether to take a value of a topic that several publishers share: each of them as often as the
        console draws. All the others would fill recordings, too."""
        if not isinstance(event, OdometryReported | OriginReported):
            return True
        value = type(event), event.robot
        if 0.0 <= at - self._taken.get(value, -math.inf) < feed.rate_ms / 1000.0:
            return False
        self._taken[value] = at
        return True

    def _stream(self, feed: Feed, msg: object, at: float) -> None:
        """Pass on the value of a watched stream. Raises WireError."""
        key = feed.stream_key
        sink = self._streams
        robots = [robot for robot in feed.robots if sink.wants(robot, key)] if key and sink else []
        if sink is not None and robots:
            value = self._adapters[feed.robot].stream(feed, msg)
            for robot in robots:
                sink.put(robot, key, value, at)

    def _read_log(self, topic: str, msg: object, at: float) -> Iterator[events.Event]:
        """Keep messages of logs and diagnostics, and yield the errors of robots in them."""
        if topic == ROSOUT:
            line = logs.log_line(msg, at)
            if self.counter.take_log(line):
                yield from logs.logged_errors(line, self._names)
            if (about := logs.complaint(line)) and about[0] in self.counter.topics:
                self._warn(f"bridge did not subscribe {truncate(about[0])}: {about[1]}")
                self.counter.topics[about[0]].not_subscribed = f"bridge: {about[1]}"
            if (feed := self._feeds.get(logs.not_allowed(line, "topic"))) is not None:
                yield events.TopicNotAllowed(self._link, feed.address, feed.robots)
            for what, glob in (("service", SERVICES_GLOB), ("action", ACTIONS_GLOB)):
                if (name := logs.not_allowed(line, what)) in self._called:
                    yield events.CallNotAllowed(self._link, name, glob)
        else:
            found = logs.diagnoses(msg, at)
            self.counter.take_health(found)
            yield from logs.diagnosed_errors(found, self._names)

    def too_large(self, head: bytes, is_binary: bool, size: int, at: float) -> Sequence[events.Event]:
        """Name a message that was dropped, with its size and the config key of the limit."""
        topic = _cbor_topic(head) if is_binary else topic_of(head)
        self.counter.dropped += 1
        limit, key = self._limit
        text = f"a message of {size / 1e6:.1f} MB exceeds the limit of {limit:g} MB: raise {key}"
        feed = self._feeds.get(topic)
        if feed is None:
            return (events.FrameRejected(self._link, text),)
        self.counter.topics[topic].failed(text, Raw(head, is_binary, at, size))
        self.maps_received.add(topic)
        return _rejected(feed, text)


def _rejected(feed: Feed, text: str) -> Sequence[events.Event]:
    return tuple(
        events.MessageRejected(robot, Message("{address}: {text}", address=feed.address, text=text))
        for robot in feed.robots
    )


def _of_none(found: Iterable[Any]) -> Sequence[events.Event]:
    """Change an event of several robots into one of no robot."""
    return tuple(replace(event, robot="") for event in found)


def _cbor_topic(head: bytes) -> str:
    found = _CBOR_TOPIC.search(head)
    if found is None:
        return ""
    length = found.group(1)[0] - 0x60 if found.group(1) else found.group(2)[0]
    return head[found.end() : found.end() + length].decode(errors="replace")

"""The connection for all incoming data: subscribed each time, decoded, turned into events."""

import asyncio
import logging
import time
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import partial

from fleet_tui.config.fleet import feeds_of, limit_of, services_of
from fleet_tui.config.schema import Config
from fleet_tui.links.memory import trim
from fleet_tui.links.rosbridge.backlog import Backlog, Frame
from fleet_tui.links.rosbridge.calls import Calls
from fleet_tui.links.rosbridge.lateness import Soundings
from fleet_tui.links.rosbridge.managed_nodes import ReadLifecycle, lifecycle_probes
from fleet_tui.links.rosbridge.missing_packages import Sourcing
from fleet_tui.links.rosbridge.pacing import Pacing
from fleet_tui.links.rosbridge.probes import EVERY_QUESTION, Pulse
from fleet_tui.links.rosbridge.renewals import PER_TOPIC
from fleet_tui.links.rosbridge.services import Services
from fleet_tui.links.rosbridge.set_up.camera_channel import CameraChannel
from fleet_tui.links.rosbridge.set_up.stream_writer import StreamWriter
from fleet_tui.links.rosbridge.subscriber import Subscriber
from fleet_tui.links.transports.loop import wait_for_turn
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.links.writer import Writer
from fleet_tui.maps.levels import read_levels
from fleet_tui.maps.map_process import decode_apart
from fleet_tui.maps.png_text import text_of_png
from fleet_tui.model import events
from fleet_tui.model.fleets.events import MemberReported, StatusReported
from fleet_tui.model.kind import CAMERA
from fleet_tui.model.link import Phase
from fleet_tui.model.navigation_events import Live, Place
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.ros import operations
from fleet_tui.robots.ros.fragments import Fragments
from fleet_tui.robots.ros.names import cancel_service
from fleet_tui.robots.ros.operations import topic_of
from fleet_tui.robots.ros.reading import WORTH_A_PROCESS, FrameReader, Read, StreamTaken
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate

LOG = logging.getLogger(__name__)

# Larger frames are decoded off the loop, so that small ones don't wait.
LARGE_FRAME = 100_000
# Seconds until the frame of a large map and the map before it are unreferenced.
TRIM_AFTER = 1.0
# Bytes of frames that wait to be decoded: more are dropped.
MOST_WAITING = 64 * 2**20
_SIGNS = events.Telemetry | Live | MemberReported | StatusReported
_PLACES = events.PoseReported | Place
# Seconds within which the last localised pose of a robot arrives on a new connection, without a rosapi that
# lists its topic.
LOCALISED_WITHIN = 3.0
# Seconds between checks for silent robots.
CHECK_EVERY = 0.2


class Telemetry:
    """Receives a bridge's topics. Everything runs on the network loop unless noted otherwise."""

    def __init__(
        self,
        link: str,
        config: Config,
        adapters: Mapping[str, Adapter],
        writer: Writer,
        places: asyncio.Semaphore,
    ) -> None:
        """`places` as for Calls."""
        self._link = link
        self._writer = writer
        self._logged = set[str]()
        self._waiting = 0
        self._received_at = self._reported_at = self._active_at = self._next_check = self._opened_at = 0.0
        self._last_messages = dict[str, float]()
        self._jumps = dict[str, object]()
        self._decoder = ThreadPoolExecutor(1, thread_name_prefix="fleet-tui-decode")
        bridge, feeds = config.bridge(link), feeds_of(config, adapters, link)
        self.connection = Connection(bridge, self)
        self._calls = Calls(self.connection, places)
        self._streams, limit = writer.store.streams, limit_of(config, link)
        self._sink = StreamWriter(writer.store)
        services = services_of(config, adapters, link)
        served = {robot for feed in feeds for robot in feed.robots}
        actions = {name for robot in served for name in adapters[robot].names.actions(robot)}
        called = {*services, *actions, *map(cancel_service, actions), *EVERY_QUESTION}
        self._reading = FrameReader(
            link,
            limit,
            adapters,
            feeds,
            decode_apart,
            LOG.warning,
            self._sink,
            read_levels,
            called,
            text_of_png,
        )
        pacing = Pacing(config, adapters, feeds, writer.store)
        asks_node = not config.operator.read_only
        read = {} if asks_node else lifecycle_probes(config, adapters, link)
        self._subscriber = Subscriber(
            self.connection, self._calls, feeds, adapters, self._reading, pacing, self._take, bool(read)
        )
        self._on_demand = [feed for feed in feeds if feed.wanted_for in ("target", "place", "stream")]
        self._adapters = adapters
        self._own_topics: dict[str, set[str]] = {robot: set() for robot in adapters}
        for feed in feeds:
            if len(feed.robots) == 1:
                self._own_topics[feed.robot].add(feed.address)
        self._pictures = CameraChannel(
            bridge, feeds, adapters, self._subscriber, self._reading, self._sink, places
        )
        self.services = Services(self._calls, services, has_actions=bool(actions))
        self._sourcing = Sourcing(
            link, self._calls, feeds, self._reading, lambda: self._subscriber.types, writer.apply
        )
        self._soundings = Soundings(
            link, Pulse(self._calls, asks_node), self._calls, self._subscriber.is_handled, writer.apply
        )
        self._lifecycle = ReadLifecycle(read, self.services, self._reading.counter, writer.apply)
        self.show_map = self._subscriber.show_map
        self.subscribe_logs = self._subscriber.log_subscription.listen
        self.counter = self._reading.counter
        self._fragments = Fragments(int(bridge.max_message_mb * 1e6))
        self._backlog = Backlog(self.connection, self._reading, self._read_frame)
        writer.before_tick.append(self._tick)
        writer.backlogs.append(self._backlog.age)

    def _tick(self, now: float) -> None:
        if self._received_at > self._reported_at:
            self._reported_at = self._received_at
            self._writer.apply(events.MessageArrived(self._link, self._received_at))
        if now > self._next_check:
            self._next_check = now + CHECK_EVERY
            self._subscriber.check(now, self._last_messages, self._writer.store.state.robots)
            self.services.note_active(self._last_messages)
            self._subscriber.watch(self._wanted_feeds())
            self._pictures.look()

    def _wanted_feeds(self) -> Iterator[Feed]:
        for feed in self._on_demand:
            if feed.stream_key == CAMERA:
                continue  # over a connection of their own
            if any(self._sink.wants(robot, feed.stream_key) for robot in feed.robots):
                yield feed._replace(wanted_for="stream")
            elif feed.wanted_for == "target":
                if self._wants_target(feed.robot):
                    yield feed
            elif feed.key in ("tf", "tf_static") and any(map(self._lacks_localisation, feed.robots)):
                yield feed

    def _wants_target(self, robot: str) -> bool:
        """Tell whether a robot drives a goal with an unknown target."""
        known = self._writer.store.state.robots.get(robot)
        current = known.orders.current if known else None
        return current is not None and not current.stops and not current.label

    def _lacks_localisation(self, robot: str) -> bool:
        """Tell whether a robot is there, and no localisation tells where on its map: its transforms may. A
        topic that rosapi lists may be waiting for a first pose."""
        known, types = self._writer.store.state.robots.get(robot), self._subscriber.types
        names = self._adapters[robot].names
        if known is None or "tf" not in names.vocabulary.topics or known.located_by == "topic":
            return False
        topic = names.topic("pose", robot)
        is_there = known.last_received is not None or not types.keys().isdisjoint(self._own_topics[robot])
        is_late = time.monotonic() - self._opened_at > LOCALISED_WITHIN
        return not topic or (is_there and topic not in types and (bool(types) or is_late))

    def silence(self) -> float:
        """Seconds since the last message on this connection, 0 before the first."""
        return time.monotonic() - self._active_at if self._active_at else 0.0

    def topic_silence(self) -> float:
        """Seconds since the last message on a topic, or since the bridge has subscribed them all."""
        if not self._subscriber.is_handled():
            return 0.0
        handled_at = self._opened_at + PER_TOPIC * self._subscriber.topics
        return time.monotonic() - max(self._active_at, handled_at)

    def on_connecting(self) -> None:
        """Report that a connection attempt has begun."""
        self._writer.apply(events.LinkChanged(self._link, time.monotonic(), Phase.CONNECTING))

    def on_open(self) -> None:
        """Subscribe to all topics."""
        now = self._opened_at = time.monotonic()
        self.counter.opened()
        self._writer.apply(events.LinkChanged(self._link, now, Phase.UP))
        self._active_at = 0.0
        self._subscriber.start(now)
        self.services.recheck_types()
        self._sourcing.start()
        self._soundings.start()
        self._lifecycle.start()

    def on_lost(self, reason: Message, next_try_in: float) -> None:
        """Report the loss, and stop open work."""
        self._subscriber.stop()
        self.services.stop()
        self._sourcing.stop()
        self._soundings.stop()
        self._lifecycle.stop()
        self._backlog.clear()
        self._fragments.clear()
        self._calls.on_lost()
        now = time.monotonic()
        self.counter.lost(reason, now)
        self._writer.apply(events.LinkChanged(self._link, now, Phase.WAITING, reason, now + next_try_in))

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """Decode a frame here, or off the loop if it is large."""
        wait_for_turn()
        at = time.monotonic()
        is_png = not is_binary and operations.is_png(payload)
        if len(payload) < LARGE_FRAME and not is_png:
            frame = payload, is_binary, at
            topic = "" if is_binary else topic_of(payload)
            if topic in self._reading.counter.topics and topic not in self._reading.complete:
                self._backlog.put(topic, frame)
            else:
                self._read_frame(frame)
            return
        self._received_at = self._active_at = at
        if self._waiting > MOST_WAITING:
            self.counter.dropped += 1
            behind = Message("{size} MB still being decoded", size=f"{self._waiting / 1000000.0:.0f}")
            self._take(
                events.FrameRejected(
                    self._link,
                    Message("{payload} bytes dropped: {behind}", payload=f"{len(payload):,}", behind=behind),
                )
            )
            return
        self._waiting += len(payload)
        loop = asyncio.get_running_loop()
        work = loop.run_in_executor(self._decoder, self._reading.read, payload, is_binary, at)
        work.add_done_callback(partial(self._take_late, payload, is_binary, at))
        if is_png or len(payload) > WORTH_A_PROCESS:
            work.add_done_callback(lambda _: loop.call_later(TRIM_AFTER, trim))

    def _read_frame(self, frame: Frame) -> None:
        read = self._reading.read(*frame)
        if not isinstance(read, operations.ServiceResponse):  # an answer is no word of a robot
            self._received_at = self._active_at = frame[2]
        self._take_frame(*frame, read)

    def _take_late(self, payload: bytes, is_binary: bool, at: float, done: "asyncio.Future[Read]") -> None:
        self._waiting -= len(payload)
        if not done.cancelled():
            self._take_frame(payload, is_binary, at, done.result())

    def on_sent(self, payload: bytes) -> None:
        """Report a sent frame to the tap."""
        if self._writer.tap is not None:
            self._writer.tap.on_sent(self._link, "topics", payload)

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        """Report the message that is too large, its size, and the setting that lets it in."""
        self._received_at = self._active_at = time.monotonic()
        for event in self._reading.too_large(head, is_binary, size, self._received_at):
            self._take(event)

    def _take_frame(self, payload: bytes, is_binary: bool, at: float, read: Read) -> None:
        """Apply the events of a frame that arrived at `at`. Only whole messages are recorded, not
        fragments."""
        if isinstance(read, StreamTaken):
            return  # not recorded: ten minutes of scans are larger than a day of everything else
        if self._writer.tap is not None and not isinstance(read, operations.Fragment):
            self._writer.tap.on_received(self._link, "topics", payload, is_binary, at)
        if isinstance(read, operations.ServiceResponse):
            self._calls.on_response(read)
        elif isinstance(read, operations.Fragment):
            self._put_together(read)
        else:
            for event in read:
                self._apply(event)

    def _apply(self, event: events.Event) -> None:
        if isinstance(event, events.MessageRejected | events.FrameRejected):
            self._log_once(event.text)
        elif isinstance(event, _SIGNS):
            self._last_messages[event.robot] = event.at
        self._writer.store.apply(event)
        robots = self._writer.store.state.robots
        if isinstance(event, _PLACES) and event.robot in robots:
            robot = robots[event.robot]
            self._streams.note(robot)
            if robot.relocated is not None and robot.relocated is not self._jumps.get(robot.name):
                self._jumps[robot.name] = robot.relocated
                LOG.warning("%s: pose jumped by %s", robot.name, robot.relocated.value)

    def _put_together(self, piece: operations.Fragment) -> None:
        try:
            whole = self._fragments.add(piece)
        except WireError as problem:
            self.counter.dropped += 1
            self._take(events.FrameRejected(self._link, str(problem)))
            return
        if whole is not None:
            self.on_frame(whole, False)

    def _take(self, rejected: events.Event) -> None:
        """Apply the events of a message; report an unreadable or unrequested one."""
        if isinstance(rejected, events.MessageRejected | events.FrameRejected):
            self._log_once(rejected.text)
        self._writer.apply(rejected)

    def _log_once(self, text: str) -> None:
        text = truncate(text)
        if text not in self._logged and len(self._logged) < 1000:
            self._logged.add(text)
            LOG.warning("%s", text)

    def close(self) -> None:
        self._pictures.close()
        self._subscriber.stop()
        self.services.stop()
        self._sourcing.stop()
        self._soundings.stop()
        self._lifecycle.stop()
        self._decoder.shutdown(wait=False, cancel_futures=True)
        self.connection.shut()

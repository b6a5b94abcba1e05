"""Subscriptions of one bridge: all topics on each connection, the open map, and again all topics that stay
silent. Everything runs on the network loop."""

import asyncio
import logging
import random
from collections.abc import Callable, Iterable, Mapping, Set
from contextlib import suppress

from fleet_tui.adapters.adapter import Adapter, Feed
from fleet_tui.adapters.ros import operations
from fleet_tui.adapters.ros.reading import FrameReader
from fleet_tui.adapters.ros.type_names import type_problem
from fleet_tui.client.rosbridge.calls import Calls
from fleet_tui.client.rosbridge.latched import Latched
from fleet_tui.client.rosbridge.log_subscription import LogSubscription
from fleet_tui.errors import LinkError
from fleet_tui.model import events
from fleet_tui.transports.rosbridge.connection import Connection

LOG = logging.getLogger(__name__)

ROSAPI_TIMEOUT = 2.0
# A bridge too old for CBOR sends nothing: after this many seconds the map is requested as JSON.
CBOR_PATIENCE = 20.0
# A bridge of ROS 2 is never too old, but sends no CBOR larger than its max_message_size: only pieces of JSON.
CBOR_PATIENCE_ROS2 = 8.0
# A bridge behind which roscore was restarted stays silent until subscribed again. A robot that is only
# switched off is subscribed again repeatedly, at doubling intervals. Seconds; a real bridge takes
# 20 ms for each topic, and has not finished before that.
FIRST_RENEWAL, PER_TOPIC, LONGEST_INTERVAL = 8.0, 0.03, 64.0
# The bridge subscribes in ROS again only when no client holds the topic. Consoles notice a silence at about
# the same time, and unsubscribe for a quarter of the time they waited, up to this many seconds: together.
LONGEST_RELEASE = 8.0


class Subscriber:
    """Subscribes on one connection, and again for robots that stay silent."""

    def __init__(
        self,
        connection: Connection,
        calls: Calls,
        feeds: Iterable[Feed],
        adapters: Mapping[str, Adapter],
        reading: FrameReader,
        report: Callable[[events.Event], None],
    ) -> None:
        self._connection, self._calls, self._reading, self._report = connection, calls, reading, report
        self._feeds, self._adapters = tuple(feeds), adapters
        self._robots = {robot for feed in self._feeds for robot in feed.robots}
        self._first_renewal = FIRST_RENEWAL + PER_TOPIC * len(self._feeds)
        self.types: dict[str, str] = {}
        """Type by topic, as last listed by rosapi; empty if it does not answer."""
        self._refused: set[str] = set()
        self._as_json: set[str] = set()
        """Maps that never arrived as CBOR."""
        self._json_timer: asyncio.TimerHandle | None = None
        self._map: Feed | None = None
        self._watched: frozenset[Feed] = frozenset()
        self.log_subscription = LogSubscription(connection, self._ask_types)
        self._latched = Latched(reading, self._of_latched, self._subscribe, self._unsubscribe)
        self._subscribed_at: dict[str, float] = {}
        self._patience: dict[str, float] = {}
        self._task: asyncio.Task[None] | None = None

    def start(self, now: float) -> None:
        """Subscribe to all topics: the bridge keeps nothing from before. `now` is monotonic, in seconds."""
        self._reading.maps_received.clear()
        self._refused.clear()
        self._patience.clear()
        self._subscribed_at = dict.fromkeys(self._robots, now)
        self._task = asyncio.ensure_future(self._begin())

    async def _begin(self) -> None:
        self.types = await self._ask_types()
        # First, to receive the bridge's warnings about the others.
        self.log_subscription.subscribe(self.types)
        for wanted in self._of(self._robots):
            self._subscribe(wanted)
        if self._is_ros2:
            self._latched.start(self._of_latched(), PER_TOPIC)

    @property
    def _is_ros2(self) -> bool:
        """Tell whether the bridge may be one of ROS 2, by the types if rosapi lists them."""
        return not self.types or any("/msg/" in type_ for type_ in self.types.values())

    def _of_latched(self) -> list[Feed]:
        """The requested latched topics that exist as far as rosapi knows."""
        return [
            one
            for one in self._of(self._robots)
            if one.latched
            and not one.silent
            and one.address not in self._refused
            and (not self.types or one.address in self.types)
        ]

    def stop(self) -> None:
        """Cancel pending requests after the connection is lost."""
        self._latched.stop()
        if self._json_timer is not None:
            self._json_timer.cancel()
        if self._task is not None:
            self._task.cancel()

    def check(self, now: float, last_message: Mapping[str, float]) -> None:
        """Subscribe again for robots that have been silent for long; `last_message` is by robot, in monotonic
        seconds."""
        if self._task is None or not self._task.done() or not self._connection.is_connected:
            return
        silent = {
            robot for robot in self._robots if self._is_silent(robot, now, last_message.get(robot, 0.0))
        }
        if not silent:
            return
        LOG.info("silent, subscribing again: %s", " ".join(sorted(silent)))
        release_time = min(LONGEST_RELEASE, max(map(self._interval, silent)) / 4)
        for robot in silent:
            self._subscribed_at[robot] = now
            # A random delay brings consoles together that did not start to wait together.
            self._patience[robot] = min(LONGEST_INTERVAL, self._interval(robot) * random.uniform(1.8, 2.2))
        self._task = asyncio.ensure_future(self._renew(silent, release_time))

    def _interval(self, robot: str) -> float:
        return self._patience.get(robot, self._first_renewal)

    def _is_silent(self, robot: str, now: float, last_message: float) -> bool:
        subscribed_at = self._subscribed_at[robot]
        if last_message > subscribed_at:
            self._patience.pop(robot, None)
        return now - max(last_message, subscribed_at) > self._interval(robot)

    async def _renew(self, robots: Set[str], release_time: float) -> None:
        # A topic of several robots is fine if any of them sends: the others would lose messages meanwhile.
        renewed = [one for one in self._of(robots) if robots >= set(one.robots)]
        for wanted in renewed:
            self._unsubscribe(wanted)
        await asyncio.sleep(release_time)
        self.types = await self._ask_types()
        for wanted in renewed:
            self._subscribe(wanted)

    def _of(self, robots: Set[str]) -> list[Feed]:
        return [
            one
            for one in self._feeds
            if any(robot in robots for robot in one.robots) and (not one.on_demand or one is self._map)
        ] + [one for one in self._watched if one.robot in robots]

    async def _ask_types(self) -> dict[str, str]:
        """Return type by topic, as rosapi lists them; empty if it doesn't."""
        try:
            response = await self._calls.call("/rosapi/topics", {}, ROSAPI_TIMEOUT)
        except LinkError as problem:
            LOG.info("types not checked: %s", problem)
            return {}
        values = response.values
        if not response.result or not isinstance(values, dict):
            LOG.info("types not checked: %s", values)
            return {}
        topics, types = values.get("topics"), values.get("types")
        if not isinstance(topics, list) or not isinstance(types, list):
            return {}
        return {str(topic): str(type_) for topic, type_ in zip(topics, types, strict=False)}

    def _subscribe(self, wanted: Feed) -> None:
        problem = type_problem(wanted, self.types, self._adapters[wanted.robot].names.table)
        if problem:
            if wanted.address not in self._refused:
                self._refused.add(wanted.address)
                self._reading.counter.topics[wanted.address].not_subscribed = problem
                self._report(events.MessageRejected(wanted.robot, problem))
            return
        self._reading.counter.topics[wanted.address].not_subscribed = ""
        topic, is_stream = wanted.address, wanted.wanted_for == "stream" and not wanted.latched
        asked = operations.Subscription(
            topic,
            # ROS 2 writes the same type with a middle part: the bridge expects its own spelling.
            self.types.get(topic, wanted.type),
            wanted.rate_ms,
            "cbor" if (wanted.large or is_stream) and topic not in self._as_json else "none",
            queue_length=wanted.queue_length,
            latched=wanted.latched and self._is_ros2 and self._latched.wants_qos(topic),
        )
        try:
            self._connection.send(operations.subscribe(asked))
        except LinkError:
            return
        # If rosapi answers, it shows whether there is a map at all.
        if asked.compression == "cbor" and (topic in self.types or not self.types):
            patience = CBOR_PATIENCE_ROS2 if self._is_ros2 and self.types else CBOR_PATIENCE
            count, loop = self._reading.counter.topics[topic].count, asyncio.get_running_loop()
            timer = loop.call_later(patience, self._request_as_json, wanted, count)
            self._json_timer = timer if wanted.large else self._json_timer

    def _request_as_json(self, wanted: Feed, count: int) -> None:
        has_come = self._reading.counter.topics[wanted.address].count > count
        if wanted.large:
            has_come = wanted.address in self._reading.maps_received
        if (self._map is wanted or wanted in self._watched) and not has_come:
            self._unsubscribe(wanted)
            self._as_json.add(wanted.address)
            self._subscribe(wanted)

    def _unsubscribe(self, wanted: Feed) -> None:
        with suppress(LinkError):
            self._connection.send(operations.unsubscribe(wanted.address))

    def watch(self, feeds: Iterable[Feed]) -> None:
        """Subscribe to these on-demand feeds, and unsubscribe from the earlier ones."""
        wanted, before = frozenset(feeds), self._watched
        self._watched = wanted
        if self._connection.is_connected:
            for feed in before - wanted:
                self._unsubscribe(feed)
            for feed in wanted - before:
                self._subscribe(feed)

    def show_map(self, robot: str, floor: str) -> None:
        """Subscribe to one robot's live map of a floor, and unsubscribe from the earlier one; "" for none."""
        maps = (feed for feed in self._feeds if feed.wanted_for == "map" and feed.floor in ("", floor))
        wanted = next((feed for feed in maps if robot in feed.robots), None)
        if wanted is self._map:
            return
        if self._map is not None:
            self._unsubscribe(self._map)
        self._map = wanted
        if wanted is not None and self._connection.is_connected:
            self._subscribe(wanted)
            if self._is_ros2:
                self._latched.start([wanted], PER_TOPIC)

"""Subscriptions of one bridge: all topics on each connection, by attention, the open map, and again all
topics that stay silent. Everything runs on the network loop."""

import asyncio
import logging
import math
import time
from collections.abc import Callable, Iterable, Mapping, Sequence, Set
from contextlib import suppress

from fleet_tui.links.rosbridge.calls import OWN_WORD, Calls
from fleet_tui.links.rosbridge.latched import Latched
from fleet_tui.links.rosbridge.log_subscription import LogSubscription
from fleet_tui.links.rosbridge.pacing import Pacing
from fleet_tui.links.rosbridge.renewals import PER_TOPIC, Renewals
from fleet_tui.links.rosbridge.rosapi import ROSAPI_TIMEOUT, lacks_bridge, topic_types
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.model import events
from fleet_tui.model.order import OrderState
from fleet_tui.model.robot import Robot
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.ros import operations
from fleet_tui.robots.ros.names import is_hidden
from fleet_tui.robots.ros.reading import FrameReader
from fleet_tui.robots.ros.type_names import type_problem
from fleet_tui.text.errors import LinkError

LOG = logging.getLogger(__name__)

# Topics that are subscribed at once: a bridge handles one after the other, and then answers a call behind
# them.
AT_ONCE = 50
# A bridge too old for CBOR sends nothing: after this many seconds the topic is requested as JSON.
CBOR_PATIENCE = 20.0
SETTLES_WITHIN = 1.0
"""Seconds in which the subscriptions of a bridge are known to ROS."""
MOST_ASKED = 3
"""Topics of which rosapi is asked who subscribes to them: the cause is the same for all."""


class Subscriber:
    """Subscribes on one connection, and again to topics that stay silent."""

    def __init__(
        self,
        connection: Connection,
        calls: Calls,
        feeds: Iterable[Feed],
        adapters: Mapping[str, Adapter],
        reading: FrameReader,
        pacing: Pacing,
        report: Callable[[events.Event], None],
        reads_health: bool = False,
    ) -> None:
        """`reads_health`: diagnostics are read all the time."""
        self._connection = connection
        self._calls = calls
        self._reading = reading
        self._report = report
        self._feeds = tuple(feeds)
        self._adapters = adapters
        self._pacing = pacing
        self._robots = {robot for feed in self._feeds for robot in feed.robots}
        regular = {feed.address for feed in self._feeds if _is_regular(feed)}
        self._at_times = [
            feed
            for feed in self._feeds
            if not _is_regular(feed) and (feed.key in ("pose", "tf") or feed.action)
        ]
        """Those of a localisation, which is silent while its robot stands, and of goals that are driven."""
        at_times = {feed.address for feed in self._at_times}
        self._renewals = Renewals({*regular, *at_times, *self._robots}, len(self._feeds))
        self.types: dict[str, str] = {}
        self._lists_ros2 = False
        """Some of these types are ones of ROS 2: asked for each of thousands of topics."""
        """Type by topic, as last listed by rosapi; empty if it does not answer."""
        self._refused: set[str] = set()
        self._renewed: dict[str, float] = {}
        """By topic, when it was subscribed again because it was silent."""
        self._dropped: Set[str] = frozenset()
        self._as_json: set[str] = set()
        """Topics that never arrived as CBOR on this connection."""
        self._json_timer: asyncio.TimerHandle | None = None
        self._map: Feed | None = None
        self._watched: frozenset[Feed] = frozenset()
        self._subscribed: set[str] = set()
        self.log_subscription = LogSubscription(connection, lambda: topic_types(calls), reads_health)
        self._latched = Latched(calls, reading, self._of_latched, self._subscribe, self._unsubscribe)
        self._task: asyncio.Task[None] | None = None

    def start(self, now: float) -> None:
        """Subscribe to all topics: the bridge keeps nothing from before. `now` is monotonic, in seconds."""
        self._reading.maps_received.clear()
        self._refused.clear()
        self._as_json.clear()
        self._renewals.start(now)
        self._renewed.clear()
        self._dropped = frozenset()
        self._subscribed.clear()
        self._latched.begin()
        self._pacing.begin(now)
        self._task = asyncio.ensure_future(self._begin())

    async def _begin(self) -> None:
        await self._list_types()
        # First, to receive the bridge's warnings about the others.
        # A bridge without rosapi, or that does not allow it, is of the ROS that is configured.
        self.log_subscription.subscribe(self.types or {feed.address: feed.type for feed in self._feeds})
        waiting = self._of(self._robots)
        total, at_once = len(waiting), AT_ONCE
        while waiting:
            self._report_progress(total - len(waiting), total)
            # Again for each part: by now it is known which robots are on the shown floor.
            waiting = self._pacing.sorted(waiting)
            for wanted in waiting[:at_once]:
                self._subscribe(wanted)
            waiting = waiting[at_once:]
            if waiting and not await self._are_handled():
                at_once = len(waiting)
        self._report_progress(total, total)
        if self._is_ros2:
            self._latched.start(PER_TOPIC * len(self._of_latched()))

    async def _list_types(self) -> None:
        self.types = await topic_types(self._calls)
        self._lists_ros2 = any("/msg/" in type_ for type_ in self.types.values())

    @property
    def topics(self) -> int:
        """Return the number of topics that are subscribed."""
        return len(self._subscribed)

    def is_handled(self) -> bool:
        """Tell whether the bridge has handled all subscriptions so far, and none are under way."""
        return self._task is None or self._task.done()

    async def _are_handled(self) -> bool:
        """Wait until the bridge has handled all subscriptions. Tell whether it shows that."""
        with suppress(LinkError):
            await self._calls.call(OWN_WORD, {}, ROSAPI_TIMEOUT + PER_TOPIC * AT_ONCE)
            return True
        return False

    def _report_progress(self, done: int, total: int) -> None:
        if total > AT_ONCE:
            link, now = self._reading.counter.name, time.monotonic()
            self._report(events.SubscriptionsAdvanced(link, now, done, total))

    @property
    def _is_ros2(self) -> bool:
        """Tell whether the bridge may be one of ROS 2, by the types if rosapi lists them."""
        return not self.types or self._lists_ros2

    def _of_latched(self) -> list[Feed]:
        """The requested latched topics that may come without the right QoS: not those of actions, which all
        are latched, nor those that rosapi does not list. One that is sent on change may begin later."""
        return [
            one
            for one in self._of(self._robots)
            if one.latched
            and one.address not in self._refused
            and not is_hidden(one.address)
            and (one.silent or not self.types or one.address in self.types)
        ]

    def stop(self) -> None:
        """Cancel pending requests after the connection is lost."""
        self._latched.stop()
        if self._json_timer is not None:
            self._json_timer.cancel()
        if self._task is not None:
            self._task.cancel()

    def check(self, now: float, last_message: Mapping[str, float], robots: Mapping[str, Robot]) -> None:
        """Subscribe again to topics that should come faster or slower by now, of the same id, which replaces
        the earlier one, and to topics that have been silent for long; `last_message` is by robot, in
        monotonic seconds."""
        if self._task is None or not self._connection.is_connected:
            return
        for feed in self._pacing.due(now):
            if feed.address in self._subscribed:
                self._subscribe(feed)
        if not self._task.done():
            return
        counters = self._reading.counter.topics.items()
        heard = {topic: one.at for topic, one in counters if one.at is not None}
        back = {topic for topic, at in self._renewed.items() if heard.get(topic, 0.0) > at}
        for topic in back:
            del self._renewed[topic]
        if self._dropped & back:
            self._report_dropped(self._dropped - back)
        owed = {
            feed.address: max(heard.get(feed.address, 0.0), min(_owes_since(feed, robots), now))
            for feed in self._at_times
        }
        silent, release_time = self._renewals.due(now, {**heard, **owed, **last_message})
        if silent:
            LOG.info("silent, subscribing again: %s", " ".join(sorted(silent)))
            self._task = asyncio.ensure_future(self._renew(silent, release_time))

    async def _renew(self, silent: Set[str], release_time: float) -> None:
        """`silent` are topics, and robots of which nothing came: of what a topic sends on a change nobody
        else knows whether it should have come, and one of several robots is fine if any of them sends."""
        renewed = [
            one
            for one in self._of(self._robots)
            if one.address in silent or (not _is_regular(one) and silent >= set(one.robots))
        ]
        for wanted in renewed:
            self._unsubscribe(wanted)
        await asyncio.sleep(release_time)
        await self._list_types()
        for wanted in renewed:
            self._subscribe(wanted)
        awaited = [one.address for one in renewed if _is_regular(one) or one.address in silent]
        again = [topic for topic in awaited if topic in self._renewed]
        self._renewed.update(dict.fromkeys(awaited, time.monotonic()))
        await self._look_for_lost(again)

    async def _look_for_lost(self, topics: Sequence[str]) -> None:
        """Report the topics that stayed silent though they were subscribed again, if the bridge is not
        subscribed to them in ROS: another client may hold them as they are. On ROS 2, which has no master,
        the bridge itself did not subscribe, and its log says why."""
        if self._is_ros2:
            return
        await asyncio.sleep(SETTLES_WITHIN)
        silent = [topic for topic in topics if topic in self._renewed]
        if silent and all([await lacks_bridge(self._calls, topic) for topic in silent[:MOST_ASKED]]):
            self._report_dropped(self._dropped | {*silent})

    def _report_dropped(self, topics: Set[str]) -> None:
        self._dropped = frozenset(topics)
        robots = {robot for feed in self._feeds if feed.address in topics for robot in feed.robots}
        self._report(events.TopicsDropped(self._reading.counter.name, tuple(sorted(robots))))

    def _of(self, robots: Set[str]) -> list[Feed]:
        return [
            one
            for one in self._feeds
            if any(robot in robots for robot in one.robots) and (not one.on_demand or one is self._map)
        ] + [one for one in self._watched if one.robot in robots]

    def _subscribe(self, wanted: Feed) -> None:
        problem = type_problem(wanted, self.types, self._adapters[wanted.robot].names.table)
        if problem:
            if wanted.address not in self._refused:
                self._refused.add(wanted.address)
                self._reading.counter.topics[wanted.address].not_subscribed = problem
                self._report(events.MessageRejected(wanted.robot, problem))
            return
        self._reading.counter.topics[wanted.address].not_subscribed = ""
        self._latched.note(wanted)
        topic = wanted.address
        asked = operations.Subscription(
            topic,
            # ROS 2 writes the same type with a middle part: the bridge expects its own spelling.
            self.types.get(topic, wanted.type),
            self._pacing.interval(wanted),
            self._compression(wanted),
            queue_length=0 if self._may_lose(wanted) else wanted.queue_length,
            latched=wanted.latched and self._is_ros2 and self._latched.wants_qos(topic),
        )
        try:
            self._connection.send(operations.subscribe(asked))
        except LinkError:
            return
        self._subscribed.add(topic)
        self._reading.counter.topics[topic].asked_ms = asked.throttle_rate
        # If rosapi answers, it shows whether there is a map at all.
        if asked.compression == "cbor" and (topic in self.types or not self.types):
            self._expect_cbor(wanted)

    def _compression(self, wanted: Feed) -> str:
        """Arrays as JSON choke a bridge. One of ROS 2 sends no CBOR above its max_message_size, but writes
        it into its log: it sends maps as PNG, in fragments if need be."""
        if wanted.large and self._is_ros2:
            return "png"
        is_array = wanted.wanted_for in ("target", "place", "stream") and not wanted.latched
        return "cbor" if (wanted.large or is_array) and wanted.address not in self._as_json else "none"

    def _may_lose(self, wanted: Feed) -> bool:
        """Tell whether the bridge need keep no message of a topic: a next one follows, and the bridge is
        certainly of ROS 2, on which a client that does not read hurts nobody. It has a thread less then."""
        return self._lists_ros2 and _is_regular(wanted) and wanted.queue_length == 1

    def _expect_cbor(self, wanted: Feed) -> None:
        """Request a topic as JSON if it does not come as CBOR."""
        count, loop = self._reading.counter.topics[wanted.address].count, asyncio.get_running_loop()
        timer = loop.call_later(CBOR_PATIENCE, self._request_as_json, wanted, count)
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
        self._subscribed.discard(wanted.address)
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
                self._latched.start(PER_TOPIC)


def _owes_since(feed: Feed, robots: Mapping[str, Robot]) -> float:
    """Return the monotonic second from which a topic that may be silent must send, infinite if it need not:
    once only the wheels of a robot tell where it is, or while a goal is driven."""
    reported = [robots[name] for name in feed.robots]
    if feed.action:
        goals = (goal for robot in reported for goal in robot.goals.get(feed.action, ()))
        since = (goal.begun_at for goal in goals if goal.state is OrderState.IN_PROCESS)
    else:
        since = (robot.adrift_at for robot in reported)
    return min((at for at in since if at is not None), default=math.inf)


def _is_regular(feed: Feed) -> bool:
    """Tell whether the messages of a topic come one after the other, so that its silence is a fault."""
    return not (feed.silent or feed.latched or feed.on_demand)

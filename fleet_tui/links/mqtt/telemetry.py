"""The messages of one broker's vehicles: subscribed on each connection, turned into events."""

import logging
import time
from collections.abc import Iterable, Mapping
from contextlib import suppress

from fleet_tui.config.fleet import feeds_of, limit_of
from fleet_tui.config.schema import Config
from fleet_tui.links.mqtt.commands import VehicleCommands
from fleet_tui.links.rates.plan import RatePlan
from fleet_tui.links.rates.wanted import FULL, intervals
from fleet_tui.links.transports.loop import wait_for_turn
from fleet_tui.links.transports.mqtt.connection import BrokerConnection
from fleet_tui.links.writer import Writer
from fleet_tui.model import events
from fleet_tui.model.attention import Intervals
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.vehicles.events import ConnectionReported, MasterSeen, VehicleReported
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.vda5050.broker_reader import MessageReader
from fleet_tui.robots.vda5050.frames import BrokerMessage, frame_of
from fleet_tui.robots.vda5050.topics import OF_MASTERS
from fleet_tui.state.store import Store
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.limits import truncate

LOG = logging.getLogger(__name__)

MOST_LOGGED = 1000
LOOK_EVERY = 0.2
"""Seconds between looks at what the operator looks at."""
REFUSED = "broker refuses the subscription: grant the user read access"


class VehicleTelemetry:
    """Receives a broker's messages. Everything runs on the network loop."""

    def __init__(self, link: str, config: Config, adapters: Mapping[str, Adapter], writer: Writer) -> None:
        """`adapters` by robot."""
        self._link = link
        self._writer = writer
        self._feeds = {feed.address: feed for feed in feeds_of(config, adapters, link)}
        self._reading = MessageReader(link, limit_of(config, link), adapters, self._feeds.values())
        self._pacing = VehiclePacing(config, self._feeds.values(), writer.store)
        self.counter = self._reading.counter
        self.connection = BrokerConnection(config.bridge(link), self)
        timeout = config.alarms.no_answer_after
        self.commands = VehicleCommands(self.connection, adapters, writer, timeout)
        self._logged = set[str]()
        self._received_at = self._reported_at = self._next_look = 0.0
        self._is_open = False
        self._path: tuple[CommandPath, str, bool] | None = None
        writer.before_tick.append(self._tick)

    def _tick(self, now: float) -> None:
        if self._received_at > self._reported_at:
            self._reported_at = self._received_at
            self._writer.apply(events.MessageArrived(self._link, self._received_at))
        if self._is_open and now > self._next_look:
            self._next_look = now + LOOK_EVERY
            self._pace(now)

    def _pace(self, now: float) -> None:
        """Subscribe to the frequent positions of vehicles that are looked at, and leave those of others."""
        changes = self._pacing.due(now)
        entered, left = [[name for name, on in changes.items() if on is wanted] for wanted in (True, False)]
        with suppress(LinkError):
            if entered:
                self.connection.subscribe(entered)
            if left:
                self.connection.unsubscribe(left)

    def on_connecting(self) -> None:
        """Report that a connection attempt has begun."""
        self._writer.apply(events.LinkChanged(self._link, time.monotonic(), Phase.CONNECTING))

    def on_open(self) -> None:
        """Subscribe to the topics of all vehicles, one vehicle after the other: some brokers limit the number
        of topics in a request."""
        self.counter.opened()
        self._pacing.begin(time.monotonic())
        self._is_open = True
        self._writer.apply(events.LinkChanged(self._link, time.monotonic(), Phase.UP))
        self._set_path(CommandPath.UNTRIED, EMPTY, True)
        self._subscribe(filter(self._pacing.is_wanted, self._feeds.values()))

    def extend(self, config: Config, adapters: Mapping[str, Adapter]) -> None:
        """Add the robots that a configuration has besides, which are in the state already."""
        known = self._feeds
        self._feeds = {feed.address: feed for feed in feeds_of(config, adapters, self._link)}
        self._reading.extend(adapters, self._feeds.values())
        self.commands.extend(adapters)
        added = [feed for address, feed in self._feeds.items() if address not in known]
        self._pacing.extend(added, time.monotonic())
        if self._is_open:
            self._subscribe(added)

    def _subscribe(self, feeds: Iterable[Feed]) -> None:
        by_robot = dict[str, list[str]]()
        for feed in feeds:
            by_robot.setdefault(feed.robot, []).append(feed.address)
        try:
            for patterns in by_robot.values():
                self.connection.subscribe(patterns)
        except LinkError as problem:
            LOG.info("subscribing: %s", problem)

    def on_lost(self, reason: Message, next_try_in: float) -> None:
        """Report the loss, and end open commands."""
        now = time.monotonic()
        self._is_open = False
        self.commands.on_lost()
        self.counter.lost(reason, now)
        self._set_path(CommandPath.DEAD, reason, False)
        self._writer.apply(events.LinkChanged(self._link, now, Phase.WAITING, reason, now + next_try_in))

    def on_subscribed(self, pattern: str, granted: bool) -> None:
        """Name a topic that this user must not read. Those of master controls are only a help."""
        self.counter.topics[pattern].not_subscribed = "" if granted else REFUSED
        feed = self._feeds[pattern]
        returned, topic = self.commands.returned, (feed.robot, feed.key)
        (returned.add if granted else returned.discard)(topic)
        if not granted and feed.key not in OF_MASTERS:
            self._take(
                events.MessageRejected(
                    feed.robot, Message("{pattern}: {refused}", pattern=pattern, refused=REFUSED)
                )
            )

    def on_answer(self, seconds: float) -> None:
        """Take the broker's answer to a sign of life."""
        now = time.monotonic()
        self.counter.round_trips.take(seconds, now)
        self._writer.apply(events.BridgeAnswered(self._link, now, seconds))
        self._set_path(CommandPath.ALIVE, EMPTY, True)

    def on_message(self, topic: str, payload: bytes, retained: bool) -> None:
        """Read a message, and apply its events."""
        wait_for_turn()
        at = self._received_at = time.monotonic()
        message = BrokerMessage(topic, payload, retained)
        found = self._reading.read_message(message, at)
        if any(isinstance(one, MasterSeen) for one in found):
            self._take_of_master(message, found, at)
            return
        if self._writer.tap is not None:
            self._writer.tap.on_received(self._link, "topics", *frame_of(message), at)
        for event in found:
            if isinstance(event, events.MessageRejected | events.FrameRejected):
                self._log_once(event.text)
            self._writer.store.apply(event)
            if isinstance(event, VehicleReported | ConnectionReported):
                self.commands.on_message(event.robot)
        # Only once all of a state is known: an order that waited for it begins where it says.
        for event in found:
            if isinstance(event, VehicleReported) and event.at == at:  # an old state answers no command
                self.commands.on_state(event.robot, event.vehicle)

    def _take_of_master(self, message: BrokerMessage, found: "tuple[events.Event, ...]", at: float) -> None:
        """Apply the events of a message to a vehicle. Those of this console come back, too: a recording tells
        them apart by its events alone."""
        if self._writer.tap is not None:
            self._writer.tap.on_received(self._link, "commands", *frame_of(message), at)
        for event in found:
            if not (isinstance(event, MasterSeen) and self.commands.is_own(event.ids)):
                self._writer.apply(event)

    def on_sent(self, topic: str, payload: bytes) -> None:
        """Report a sent message to the tap."""
        self._reading.take_sent(BrokerMessage(topic, payload), time.monotonic())
        if self._writer.tap is not None:
            frame, _ = frame_of(BrokerMessage(topic, payload))
            self._writer.tap.on_sent(self._link, "commands", frame)

    def on_too_large(self, topic: str, size: int) -> None:
        """Report a message that is too large, its size, and the setting that lets it in."""
        for event in self._reading.too_large(topic, size):
            self._take(event)

    def _take(self, rejected: events.Event) -> None:
        if isinstance(rejected, events.MessageRejected | events.FrameRejected):
            self._log_once(rejected.text)
        self._writer.apply(rejected)

    def _log_once(self, text: str) -> None:
        text = truncate(text)
        if text not in self._logged and len(self._logged) < MOST_LOGGED:
            self._logged.add(text)
            LOG.warning("%s", text)

    def _set_path(self, path: CommandPath, reason: Message, connected: bool) -> None:
        if self._path != (path, reason, connected):
            self._path = path, reason, connected
            self._writer.apply(events.CommandPathChanged(self._link, path, reason, connected))


class VehiclePacing:
    """A broker has no rates: the frequent positions of vehicles that nobody looks at are not subscribed to;
    their states tell the position, too, less often. Runs on the network loop. Times are monotonic seconds."""

    def __init__(self, config: Config, feeds: Iterable[Feed], store: Store) -> None:
        self._rates = config.rates
        self._store = store
        self._frequent = dict[str, str]()
        self._plan = RatePlan(
            config.rates.changes_per_s, lambda _, before, after: int(before.unseen != after.unseen)
        )
        self.extend(feeds, 0.0)

    def extend(self, feeds: Iterable[Feed], now: float) -> None:
        """Pace these topics, too, which are subscribed."""
        added = {feed.robot: feed.address for feed in feeds if feed.fast}
        self._frequent |= added
        self._plan.extend(dict.fromkeys(added, FULL), now)

    def begin(self, now: float) -> None:
        """Take the wishes for new subscriptions from the attention."""
        self._plan.begin(self._wanted(), now)

    def is_wanted(self, feed: Feed) -> bool:
        """Tell whether to subscribe to a topic."""
        return not feed.fast or not self._plan.asked.get(feed.robot, FULL).unseen

    def due(self, now: float) -> Mapping[str, bool]:
        """Return the topics to subscribe to (True) or to leave by now."""
        return {
            self._frequent[robot]: not self._plan.asked[robot].unseen
            for robot, before in self._plan.due(self._wanted(), now)
            if before.unseen != self._plan.asked[robot].unseen
        }

    def _wanted(self) -> Mapping[str, Intervals]:
        return intervals(self._store.state, self._frequent, self._store.attention, self._rates)

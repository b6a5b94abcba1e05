"""Reads the messages of one broker into events. Only counters change here."""

from collections.abc import Iterable, Iterator, Mapping
from math import inf
from typing import cast

from fleet_tui.model import events
from fleet_tui.model.counters import LinkCounter, TopicCounter
from fleet_tui.model.vehicles.events import ConnectionReported, MessageKept
from fleet_tui.model.vehicles.vehicle import REMOVED, VehicleConnection
from fleet_tui.robots.adapter import Adapter, Feed, Limit
from fleet_tui.robots.vda5050.adapter import VehicleAdapter
from fleet_tui.robots.vda5050.fields import Fields
from fleet_tui.robots.vda5050.frames import BrokerMessage, message_of
from fleet_tui.robots.vda5050.memory import StateMemory
from fleet_tui.robots.vda5050.messages import READERS, MessageOrigin, stamp_of
from fleet_tui.robots.vda5050.topics import VehicleAddress
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate

MOST_KNOWN = 20_000
"""Maximum topics that are remembered: a hostile client may make up versions without end."""
KEPT_TEXT = "retained by the broker, of unknown age: not shown; the sender must not retain it"
KEPT = ("connection", "factsheet")
"""Topics whose kept message counts, whatever its age."""
DATED = ("state", "visualization")
"""Topics whose kept message is as old as its timestamp: by the clock of the other vehicles."""
AHEAD = 1.0
"""Seconds by which a timestamp may be ahead of that clock: beyond, its own clock is wrong."""


class MessageReader:
    """Reads the messages of one broker's vehicles."""

    def __init__(
        self, link: str, limit: Limit, adapters: Mapping[str, Adapter], feeds: Iterable[Feed]
    ) -> None:
        """`adapters` by robot; `feeds` are those of this link."""
        self._link = link
        self._limit = limit
        self._known: dict[str, tuple[str, VehicleAddress]] = {}
        """Topics that were parsed before: there are a few for each vehicle."""
        self._name(adapters, feeds)
        self.recount()

    def _name(self, adapters: Mapping[str, Adapter], feeds: Iterable[Feed]) -> None:
        """Take the vehicles whose messages are read."""
        self._feeds = {(feed.robot, feed.key): feed for feed in feeds}
        known = {feed.robot: cast("VehicleAdapter", adapters[feed.robot]) for feed in self._feeds.values()}
        self._topics = list(dict.fromkeys(adapter.topics for adapter in known.values()))
        self._owns = {robot: adapter.owns for robot, adapter in known.items()}
        self._robots = {adapter.vehicle(robot): robot for robot, adapter in known.items()}

    def extend(self, adapters: Mapping[str, Adapter], feeds: Iterable[Feed]) -> None:
        """Read the messages of further vehicles, too: all are given."""
        self._name(adapters, feeds)
        self.counter.topics = {**_counters(self._feeds.values()), **self.counter.topics}

    def recount(self) -> None:
        """Reset the counters."""
        self.counter = LinkCounter(self._link, _counters(self._feeds.values()).values())
        self._memory = StateMemory()  # the state may be an earlier one now
        self._site: float | None = None
        """The least (arrival - timestamp) of the vehicles' messages that were not kept, in seconds."""
        self._undated: dict[str, tuple[BrokerMessage, float]] = {}
        """By topic: kept messages and their arrival, until another vehicle tells the clock."""
        self._heard: dict[tuple[str, str], float] = {}
        """By robot and topic name: the arrival of the last message that was not kept."""
        self._connections: dict[str, tuple[events.Event, ...]] = {}
        """By robot: the kept connection, as long as nothing but kept messages has come from it."""

    def whose(self, topic: str) -> tuple[str, VehicleAddress] | None:
        """Return the robot and the address of a topic, None if it is none of a configured vehicle."""
        if (known := self._known.get(topic)) is not None:
            return known
        for topics in self._topics:
            address = topics.parse(topic)
            if address is not None:
                robot = self._robots.get(address[:2]) or self._robots.get(("", address.serial))
                if robot is None or address.name not in READERS:
                    return None
                if len(self._known) < MOST_KNOWN:
                    self._known[topic] = robot, address
                return robot, address
        return None

    def read(self, payload: bytes, _is_binary: bool, at: float) -> tuple[events.Event, ...]:
        """Read a recorded frame that arrived at a monotonic second."""
        try:
            return self.read_message(message_of(payload), at)
        except WireError as problem:
            return (events.FrameRejected(self._link, str(problem)),)

    def read_message(self, message: BrokerMessage, at: float) -> tuple[events.Event, ...]:
        """Read a message that arrived at a monotonic second."""
        self.counter.all.take(len(message.payload), at)
        found = self.whose(message.topic)
        if found is None:
            return ()
        robot, address = found
        counter = self.counter.topics[self._feeds[robot, address.name].address]
        counter.count_frame(message.payload, False, at)
        if message.kept and address.name not in KEPT:
            if address.name in DATED and (dated := self._sent_at(message, at)) is not None:
                return self._read_kept(message, robot, address, dated)
            # Its age is unknown: the sender's clock may be any.
            if address.name in DATED:
                self._undated[message.topic] = message, at
            counter.failed(KEPT_TEXT)
            return (MessageKept(robot, at, f"{address.name}: {KEPT_TEXT}"),)
        self._undated.pop(message.topic, None)
        if address.name in DATED:
            self._heard[robot, address.name] = at
        if not message.payload:  # so a kept message is removed
            removed = ConnectionReported(robot, at, VehicleConnection(REMOVED, address.base, ""))
            return (removed,) if address.name == "connection" else ()
        read = self._read(message, robot, address, at)
        if not message.kept:
            self._connections.pop(robot, None)
        elif address.name == "connection":
            self._connections[robot] = tuple(one for one in read if isinstance(one, ConnectionReported))
        return *self._dated_by(read, at), *read

    def _dated_by(self, read: Iterable[events.Event], at: float) -> Iterator[events.Event]:
        """Yield the events of kept messages, once the clock of another vehicle dates them."""
        for event in read:
            if isinstance(event, events.PoseReported) and event.stamp is not None:
                lag = at - event.stamp
                self._site = lag if self._site is None else min(self._site, lag)
        if self._site is None:
            return
        for topic, (message, arrived) in list(self._undated.items()):
            dated, found = self._sent_at(message, arrived), self.whose(topic)
            if dated is not None and found is not None:
                del self._undated[topic]
                yield from self._read_kept(message, *found, dated)

    def _read_kept(
        self, message: BrokerMessage, robot: str, address: VehicleAddress, dated: float
    ) -> tuple[events.Event, ...]:
        """Read a kept message, unless its vehicle has sent a newer one: each new link brings it again. It is
        no sign of life beside a connection that the broker has kept."""
        if dated <= self._heard.get((robot, address.name), -inf):
            return ()
        return *self._read(message, robot, address, dated), *self._connections.get(robot, ())

    def _sent_at(self, message: BrokerMessage, arrived: float) -> float | None:
        """Return the monotonic second at which a kept message was sent, None if nothing tells."""
        try:
            stamp = stamp_of(Fields.of(message.payload))
        except (WireError, RecursionError):
            return None
        if stamp is None or self._site is None or stamp + self._site > arrived + AHEAD:
            return None
        return min(arrived, stamp + self._site)

    def _read(
        self, message: BrokerMessage, robot: str, address: VehicleAddress, at: float
    ) -> tuple[events.Event, ...]:
        counter = self.counter.topics[self._feeds[robot, address.name].address]
        origin = MessageOrigin(robot, address.base, at, message.kept, self._owns[robot], self._memory)
        try:
            fields = Fields.of(message.payload)
            read = tuple(READERS[address.name](origin, fields))
        except (WireError, RecursionError) as problem:  # a value may be too deep to be named or compared
            counter.failed(str(problem))
            return (
                events.MessageRejected(
                    robot, Message("{topic}: {problem}", topic=truncate(message.topic), problem=problem)
                ),
            )
        if not fields.faults:
            return read
        text = "; ".join(fields.faults[:3])
        counter.failed(text)
        return *read, events.MessageRejected(
            robot, Message("{name}: {text}", name=address.name, text=truncate(text))
        )

    def take_sent(self, message: BrokerMessage, at: float) -> None:
        """Remember what this console sent: not each broker returns it."""
        if (found := self.whose(message.topic)) is not None:
            self._read(message, *found, at)

    def too_large(self, topic: str, size: int) -> tuple[events.Event, ...]:
        """Name a message that was dropped, with its size and the config key of the limit."""
        self.counter.dropped += 1
        limit, key = self._limit
        text = Message(
            "a message of {size} MB exceeds the limit of {limit} MB: raise {key}",
            size=f"{size / 1000000.0:.1f}",
            limit=f"{limit:g}",
            key=key,
        )
        found = self.whose(topic)
        if found is None:
            return (events.FrameRejected(self._link, text),)
        return (
            events.MessageRejected(found[0], Message("{topic}: {text}", topic=truncate(topic), text=text)),
        )


def _counters(feeds: Iterable[Feed]) -> dict[str, TopicCounter]:
    """Return a new counter of each topic."""
    return {
        one.address: TopicCounter(
            one.address, one.robot, one.key, one.latched and not one.silent, False, one.silent
        )
        for one in feeds
    }

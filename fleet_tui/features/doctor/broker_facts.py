"""Facts of a broker: its session, the subscriptions that it grants, and the messages of some seconds."""

import asyncio
import time
from collections.abc import Sequence
from dataclasses import dataclass, field

from fleet_tui.config.fleet import adapters_of, feeds_of, limit_of
from fleet_tui.config.schema import Config
from fleet_tui.links.transports.mqtt.connection import BrokerConnection
from fleet_tui.model.events import Event, MessageRejected, PoseReported
from fleet_tui.model.vehicles.events import ConnectionReported, MessageKept, VehicleReported
from fleet_tui.model.vehicles.vehicle import Vehicle, VehicleConnection
from fleet_tui.robots.vda5050.broker_reader import MessageReader
from fleet_tui.robots.vda5050.discovery import has_header
from fleet_tui.robots.vda5050.fields import Fields
from fleet_tui.robots.vda5050.frames import BrokerMessage
from fleet_tui.robots.vda5050.topics import Topics
from fleet_tui.text.errors import WireError

LISTEN_FOR = 5.0
"""Seconds for which messages are collected, unless every vehicle was heard twice before."""
AT_LEAST = 1.5


@dataclass
class VehicleFacts:
    """Measurements of one vehicle: `is_kept` tells whether the broker keeps its connection; `arrivals` of its
    messages by topic name (monotonic), `lags` of their stamps behind our clock in seconds."""

    connection: VehicleConnection | None = None
    is_kept: bool = False
    vehicle: Vehicle | None = None
    pose: PoseReported | None = None
    arrivals: dict[str, list[float]] = field(default_factory=dict)
    lags: list[float] = field(default_factory=list)
    problem: str = ""

    @property
    def is_heard(self) -> bool:
        """Tell whether its state came twice, so that its rate is known."""
        return len(self.arrivals.get("state", ())) > 1


@dataclass
class BrokerFacts:
    """Everything about one broker: `reason` why there is no session, empty if there is one; `opened_in` and
    `round_trips` in seconds, `heard_for` the seconds of listening, `strangers` vehicles on it that are not
    configured."""

    name: str
    reason: str = ""
    opened_in: float = 0.0
    heard_for: float = 0.0
    round_trips: list[float] = field(default_factory=list)
    granted: dict[str, bool] = field(default_factory=dict)
    robots: dict[str, VehicleFacts] = field(default_factory=dict)
    strangers: set[tuple[str, str]] = field(default_factory=set)


class BrokerObserver:
    """Collects the facts of one broker. Runs on the network loop; sends nothing but subscriptions."""

    def __init__(self, config: Config, name: str) -> None:
        adapters = adapters_of(config)
        feeds = feeds_of(config, adapters, name)
        self._reader = MessageReader(name, limit_of(config, name), adapters, feeds)
        self._patterns = [feed.address for feed in feeds]
        self._everyone = Topics().filter("connection")
        self.facts = BrokerFacts(name)
        self.facts.robots = {robot.name: VehicleFacts() for robot in config.robots if robot.link == name}
        self.connection = BrokerConnection(config.bridge(name), self)
        self.decided = asyncio.Event()
        self._began = time.monotonic()

    def on_connecting(self) -> None:
        """Do nothing: an attempt has begun."""

    def on_open(self) -> None:
        """Subscribe to the configured topics, and to the connections of all vehicles."""
        self.facts.opened_in = time.monotonic() - self._began
        for pattern in (*self._patterns, self._everyone):
            self.connection.subscribe([pattern])
        self.decided.set()

    def on_lost(self, reason: str, next_try_in: float) -> None:
        """Take the reason that there is no session."""
        self.facts.reason = reason or "connection lost"
        self.decided.set()

    def on_subscribed(self, pattern: str, granted: bool) -> None:
        """Note what this user may read."""
        if pattern != self._everyone:
            self.facts.granted[pattern] = granted

    def on_answer(self, seconds: float) -> None:
        """Note a round trip."""
        self.facts.round_trips.append(seconds)

    def on_sent(self, topic: str, payload: bytes) -> None:
        """Do nothing: nothing is sent."""

    def on_too_large(self, topic: str, size: int) -> None:
        """Do nothing: the message counts as missing."""

    def on_message(self, topic: str, payload: bytes, retained: bool) -> None:
        """Note a message of a configured vehicle, or another vehicle."""
        found = self._reader.whose(topic)
        if found is None:
            address = Topics().parse(topic)
            if address is not None and address.name == "connection" and _is_of_vehicle(payload):
                self.facts.strangers.add((address.manufacturer, address.serial))
            return
        robot, address = found
        now, facts = time.monotonic(), self.facts.robots[robot]
        for event in self._reader.read_message(BrokerMessage(topic, payload, retained), now):
            _note(facts, event)
        if not retained:
            facts.arrivals.setdefault(address.name, []).append(now)


def _is_of_vehicle(payload: bytes) -> bool:
    try:
        return has_header(Fields.of(payload))
    except WireError:
        return False


def _note(facts: VehicleFacts, event: Event) -> None:
    if isinstance(event, VehicleReported):
        facts.vehicle = event.vehicle
    elif isinstance(event, ConnectionReported):
        facts.connection = event.connection
        facts.is_kept = facts.is_kept or event.is_kept
    elif isinstance(event, PoseReported):
        facts.pose = event
        if event.stamp is not None:
            facts.lags.append(time.time() - event.stamp)
    elif isinstance(event, MessageRejected | MessageKept):
        facts.problem = event.text


async def facts_of_broker(config: Config, name: str, until: float) -> BrokerFacts:
    """Return the facts of a broker, by `until` (monotonic)."""
    listener = BrokerObserver(config, name)
    listener.connection.connect()
    try:
        async with asyncio.timeout(max(0.1, until - time.monotonic())):
            await listener.decided.wait()
        if not listener.facts.reason:
            await _listen(listener, list(listener.facts.robots.values()), until)
    except TimeoutError:
        listener.facts.reason = "out of time before it responded"
    finally:
        listener.connection.shut()
    return listener.facts


async def _listen(listener: BrokerObserver, robots: Sequence[VehicleFacts], until: float) -> None:
    began = time.monotonic()
    while time.monotonic() < min(until, began + LISTEN_FOR):
        await asyncio.sleep(0.05)
        if time.monotonic() > began + AT_LEAST and all(one.is_heard for one in robots):
            break
    listener.facts.heard_for = time.monotonic() - began

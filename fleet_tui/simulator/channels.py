"""The bridge's own subscriptions: one per topic, shared by all clients that subscribed to it."""

import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.errors import BridgeError
from fleet_tui.simulator.rosapi import OF_THE_BRIDGE
from fleet_tui.simulator.sessions.client import Client
from fleet_tui.simulator.sessions.operations import Operation

# seconds after the bridge's start between which it discovers publishers on ROS 2
FIRST = 0.3
LAST = 0.95


def resolve(name: str) -> str:
    """The full name of a topic or service that a client may have named without the first slash."""
    return name if name.startswith("/") else f"/{name}"


@dataclass(eq=False)
class Channel:
    """One subscription of the bridge; type and quality of service stay what they were at first.

    `durable`: latched values are asked for; `demanding`: by a client, so that a publisher without them
    does not match at all.
    """

    type: str
    durable: bool
    demanding: bool = False
    clients: set[Client] = field(default_factory=set)

    def receives(self, topic: Topic, dialect: Dialect) -> bool:
        return self.type == dialect.short(topic.type) and (topic.latched or not self.demanding)


class Channels:
    """All subscriptions of one life of the bridge, by the topic's name as it was asked for.

    `topics` are those that are published, and may change; `unsourced` names packages that the bridge doesn't
    have.
    """

    def __init__(self, dialect: Dialect, topics: Mapping[str, Topic], unsourced: set[str]) -> None:
        self._dialect = dialect
        self._topics = topics
        self._unsourced = unsourced
        self._channels: dict[str, Channel] = {}
        self._released: dict[str, tuple[Channel, float]] = {}

    def __iter__(self) -> Iterator[str]:
        return iter(self._channels)

    def __getitem__(self, name: str) -> Channel:
        return self._channels[name]

    def clients(self, name: str) -> set[Client]:
        """The clients that hold a topic under this name."""
        channel = self._channels.get(name)
        return channel.clients if channel else set()

    def types(self) -> Mapping[str, str]:
        message = self._dialect.message_type
        return {resolve(name): message(channel.type) for name, channel in self._channels.items()}

    def join(self, client: Client, operation: Operation, age: float) -> None:
        """Subscribe a client, `age` seconds after the bridge's start. Raises BridgeError."""
        name = operation["topic"]
        wanted = operation.get("type")
        topic = self._topics.get(resolve(name))
        if topic is not None and age < self.delay(topic):
            topic = None
        type_ = self._type(name, wanted, topic)
        channel = self._channels.get(name)
        if channel is None:
            released, at = self._released.pop(name, (None, age))
            if released is not None and age - at < self._dialect.lingers:
                channel = released
            else:
                channel = self._open(type_, topic, operation.get("qos"))
            self._channels[name] = channel
        channel.clients.add(client)

    def leave(self, client: Client, name: str, age: float) -> bool:
        """Unsubscribe a client; return whether it was the last."""
        channel = self._channels[name]
        channel.clients.discard(client)
        if not channel.clients:
            del self._channels[name]
            if self._dialect.lingers:
                self._released[name] = channel, age
        return not channel.clients

    def delay(self, topic: Topic) -> float:
        """Seconds after the bridge's start at which it discovers the topic's publisher."""
        if not self._dialect.discovers or topic.name in OF_THE_BRIDGE:
            return 0.0
        return FIRST + (LAST - FIRST) * (zlib.crc32(topic.name.encode()) % 100) / 100

    def _type(self, name: str, wanted: str | None, topic: Topic | None) -> str:
        published = None if topic is None else self._dialect.short(topic.type)
        asked = published if wanted is None else self._dialect.short(wanted)
        if asked is None:
            raise BridgeError(f"Cannot infer topic type for topic {name} as it is not yet advertised")
        package = asked.partition("/")[0]
        if package in self._unsourced or not (asked == published or self._dialect.importable(asked)):
            raise BridgeError(self._dialect.unknown_package(package, "msg"))
        channel = self._channels.get(name)
        established = channel.type if channel is not None and self._settled(channel, topic) else published
        if established is not None and asked != established:
            raise BridgeError(
                f"Tried to subscribe to topic {name} with type {wanted}, established is {established}"
            )
        return asked

    def _settled(self, channel: Channel, topic: Topic | None) -> bool:
        published = None if topic is None else self._dialect.short(topic.type)
        return not self._dialect.joins_wrong_types or published in (None, channel.type)

    def _open(self, type_: str, topic: Topic | None, qos: object) -> Channel:
        if not self._dialect.discovers:
            return Channel(type_, durable=True)
        if isinstance(qos, dict):
            durable = qos.get("durability") == "transient_local"
            return Channel(type_, durable, demanding=durable)
        return Channel(type_, durable=topic is not None and topic.latched)

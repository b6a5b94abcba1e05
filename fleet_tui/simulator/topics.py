"""Publishes topics to their subscribers, with switches for tests to make them fail."""

import asyncio
import time
from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase
from functools import partial
from typing import Any

from fleet_tui.simulator.channels import Channels, resolve
from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.frames import OutgoingFrame, Payload
from fleet_tui.simulator.logs import ERROR, INFO, ROSOUT, WARN, Talk
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.rosapi import BRIDGE
from fleet_tui.simulator.services import REMEMBERED, ServiceDesk
from fleet_tui.simulator.sessions.client import Client
from fleet_tui.simulator.sessions.operations import Operation

CANCELLED = {"topic": "subscription to", "service": "service call for", "action": "sending action goal for"}
"""What a bridge cancels of a name that its allow-list lacks, as it logs that."""


class TopicDesk:
    """The topics of a bridge, beside its `services`. Its attributes are for tests to read and change."""

    one_by_one = False
    """True: a client's call or goal must end before its next operation is handled."""

    def __init__(
        self,
        fleets: Sequence[Fleet],
        dialect: Dialect,
        topics: Iterable[Topic],
        talk: Talk,
        subscribe_delay: float = 0.0,
    ) -> None:
        """`subscribe_delay`: seconds every subscribe takes (the real bridge needs 0.02)."""
        self.fleets = fleets
        self.dialect = dialect
        self._talk = talk
        self.subscribe_delay = subscribe_delay
        self.topics = {topic.name: topic for topic in topics}
        self.orphaned: set[str] = set()
        """Topics that are silent, as after a restart of roscore, until no client is subscribed."""
        self.services = ServiceDesk(fleets, dialect, self.topics, self._known)
        self.received: deque[Operation] = deque(maxlen=REMEMBERED)
        """Every operation that arrived; the newest last."""
        self.max_message_size = dialect.max_message_size
        """Maximum bytes of a message to a client, None: no limit."""
        self.muted: set[str] = set()
        """Topics that are not published."""
        self.allowed: dict[str, Sequence[str]] = {}
        """Patterns of the topics and of the services that clients may use, by these words; without: all."""
        self.started = time.monotonic()
        """The start time of the bridge, monotonic."""
        self.forget_subscriptions()

    def forget_subscriptions(self) -> None:
        """Reset the bridge to one that has just started: without subscriptions, and lines of its own."""
        self._talk.forget(BRIDGE)
        self.channels = Channels(self.dialect, self.topics, self.services.unsourced)

    def subscribed(self) -> set[str]:
        """Return the topics with at least one subscriber."""
        return set(self.channels.types())

    def subscribers(self, topic: str) -> int:
        return sum(len(self.channels.clients(name)) for name in _spellings(topic))

    def publish_raw(self, topic: str, msg: dict[str, Any] | str | bytes) -> int:
        """Send a message, or as it is a text or binary frame, to the topic's subscribers, past throttle
        and queue. Returns how many there are."""
        publication = OutgoingFrame(topic, Payload(msg))
        for client in self.channels.clients(topic):
            compression = client.subscriptions[topic].compression
            client.reply(publication.frame(compression) if isinstance(msg, dict) else msg)
        return self.subscribers(topic)

    def publish(self, name: str, payload: Payload | None = None) -> None:
        """Publish a message on a topic, its current one by default; on a withdrawn one none."""
        topic = self.topics.get(name)
        if topic is None:
            return
        for asked in _spellings(name):
            if self.channels.clients(asked) and self._flows(asked, topic):
                payload = payload or topic.payload(time.time())
                self.services.in_turn(partial(self._send, asked, topic, OutgoingFrame(asked, payload)))

    def advertise(self, topic: Topic) -> None:
        self.topics[topic.name], self.services.types[topic.name] = topic, topic.type

    def withdraw(self, name: str) -> None:
        """End a topic's publisher: rosapi does not list it any more."""
        del self.topics[name], self.services.types[name]

    def publish_for(self, client: Client, operation: Operation) -> None:
        """Publish a client's message, to robots too. Raises BridgeError."""
        name, payload = self.services.guests.published(client, operation)
        if not self.services.guests.connected(client, name):
            return
        self.publish(name, payload)
        if name in self.services.subscriptions:
            self.services.subscriptions[name](payload.msg)
            self.spread()

    def spread(self) -> None:
        """Publish the changes in the fleets since the last call."""
        for fleet in self.fleets:
            for name, payload in fleet.news(self.dialect):
                self.publish(name, payload)
        self.services.actions.send_results()

    def complain(self, client: Client, operation: Operation, text: str) -> None:
        id_ = f"[id: {operation['id']}] " if "id" in operation else ""
        self._log(client, ERROR, f"{id_}{operation.get('op')}: {text}")

    def refuses(self, client: Client, what: str, name: str) -> bool:
        """Tell whether an allow-list does not admit a `topic`, `service` or `action`: only the log tells."""
        patterns = self.allowed.get(what)
        if patterns is None or any(fnmatchcase(resolve(name), pattern) for pattern in patterns):
            return False
        self._log(client, WARN, f"No match found for {what}, cancelling {CANCELLED[what]}: {name}")
        return True

    def _log(self, client: Client, level: int, text: str) -> None:
        line = self._talk.say(time.time(), level, BRIDGE, f"[Client {client.id}] {text}")
        self.publish(ROSOUT, Payload(line))

    def join(self, client: Client, operation: Operation) -> None:
        """Subscribe a client to a topic, perhaps once more. Raises ServiceError."""
        self.channels.join(client, operation, self._age)

    def welcome(self, client: Client, topic: str) -> None:
        """Send the topic's latched value to a subscriber, once the bridge has discovered the publisher."""
        known = self.topics.get(resolve(topic))
        if known is not None and known.latched:
            wait = self.channels.delay(known) - self._age
            if wait <= 0.0:
                self._tell(client, topic, self.channels)
            else:
                asyncio.get_running_loop().call_later(wait, self._tell, client, topic, self.channels)
        self._log(client, INFO, f"Subscribed to {topic}")

    def leave(self, client: Client, topic: str) -> None:
        if self.channels.leave(client, topic, self._age):
            self.orphaned.discard(topic)
        self._log(client, INFO, f"Unsubscribed from {topic}")

    @property
    def _age(self) -> float:
        return time.monotonic() - self.started

    def _known(self) -> Mapping[str, str]:
        """Return the subscriptions that ROS knows of, with the types that were asked for."""
        return {name: type_ for name, type_ in self.channels.types().items() if name not in self.orphaned}

    def _send(self, asked: str, topic: Topic, publication: OutgoingFrame) -> None:
        never = self.dialect.short(topic.type) in self.dialect.never_cbor
        for client in self.channels.clients(asked):
            if not (never and client.subscriptions[asked].compression == "cbor"):
                self._offer(client, asked, publication)

    def _offer(self, client: Client, asked: str, publication: OutgoingFrame) -> None:
        frame = publication.frame(client.subscriptions[asked].compression)
        limit = self.max_message_size
        if isinstance(frame, bytes) and limit is not None and len(frame) > limit:
            text = f"Message of {len(frame)} bytes is longer than max_message_size {limit}: {frame!r}"
            self.complain(client, {"op": "publish", "topic": asked}, text)
            return
        client.offer(asked, frame)

    def _flows(self, asked: str, topic: Topic) -> bool:
        if topic.name in self.muted or topic.name in self.orphaned:
            return False
        return self.channels[asked].receives(topic, self.dialect) and self._age >= self.channels.delay(topic)

    def _tell(self, client: Client, asked: str, channels: Channels) -> None:
        topic = self.topics.get(resolve(asked))
        if topic is None or channels is not self.channels or client not in channels.clients(asked):
            return
        if topic.name in self.muted or topic.name in self.orphaned:
            return
        if channels[asked].durable and channels[asked].receives(topic, self.dialect):
            now = time.time()
            for payload in topic.history() if topic.history else (topic.payload(now),):
                self._offer(client, asked, OutgoingFrame(asked, payload))


def _spellings(topic: str) -> tuple[str, ...]:
    return topic, topic.removeprefix("/")

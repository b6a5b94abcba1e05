"""A peer on a broker, in a thread of its own, as vehicles and other consoles are."""

import threading
from collections.abc import Callable
from typing import Any, NamedTuple

import paho.mqtt.client as mqtt
from paho.mqtt.enums import CallbackAPIVersion

from tests.support.polling import eventually

PEERS = dict[int, list["Peer"]]()
"""The peers on the broker of each port: one that outlives it would seek it for ever, and slow other tests."""


class Told(NamedTuple):
    topic: str
    payload: bytes
    retained: bool


class Peer:
    """Publishes, and keeps what it is subscribed to; `will`: topic and payload of a retained last will."""

    def __init__(
        self,
        port: int,
        *patterns: str,
        will: tuple[str, bytes] | None = None,
        login: tuple[str, str] | None = None,
    ) -> None:
        self.told: list[Told] = []
        self.on_told: Callable[[Told], None] = lambda _told: None
        self._subscribed = threading.Event()
        self._client = mqtt.Client(CallbackAPIVersion.VERSION2, protocol=mqtt.MQTTv311)
        self._client.on_message = self._on_message
        self._client.on_subscribe = lambda *_: self._subscribed.set()
        if will is not None:
            self._client.will_set(*will, qos=1, retain=True)
        if login is not None:
            self._client.username_pw_set(*login)
        self._client.connect("127.0.0.1", port)
        self._client.loop_start()
        PEERS.setdefault(port, []).append(self)
        eventually(self._client.is_connected)
        if patterns:
            self._client.subscribe([(pattern, 0) for pattern in patterns])
            assert self._subscribed.wait(10)

    def _on_message(self, _client: Any, _data: Any, message: mqtt.MQTTMessage) -> None:
        told = Told(message.topic, bytes(message.payload), message.retain)
        self.told.append(told)
        self.on_told(told)

    def publish(self, topic: str, payload: bytes, retain: bool = False, qos: int = 0) -> None:
        """Publish; with `qos` it has arrived."""
        sent = self._client.publish(topic, payload, qos, retain)
        if qos:
            eventually(sent.is_published)

    def told_on(self, topic: str) -> list[bytes]:
        return [one.payload for one in self.told if one.topic == topic]

    def drop(self) -> None:
        """Lose the connection, so that the broker publishes the last will."""
        sock = self._client.socket()
        self._client.loop_stop()
        if sock is not None:
            sock.close()

    def close(self) -> None:
        sleeps = not self._client.is_connected()  # before its next attempt: in seconds that stand for us
        self._client.disconnect()
        if not sleeps:
            self._client.loop_stop()

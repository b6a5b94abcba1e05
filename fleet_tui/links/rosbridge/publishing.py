"""Publications of commands on one connection: advertised in advance, repeated if that was too late."""

import asyncio
import time
from collections.abc import Iterable
from contextlib import suppress

from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.robots.adapter import Publication
from fleet_tui.robots.ros import operations
from fleet_tui.text.errors import LinkError

KNOWN_AFTER = 0.3
"""Seconds until subscribers have connected to an advertised topic: earlier messages may be lost."""

AT_ONCE = 20
BETWEEN = 0.2
"""Topics advertised per batch (a real bridge needs up to 10 ms for each), and the seconds between batches."""


class Publishing:
    """Runs on the network loop. `usual` are names and types of topics advertised on each connection."""

    def __init__(self, connection: Connection, usual: Iterable[tuple[str, str]]) -> None:
        self._connection = connection
        self._usual = tuple(usual)
        self._advertised: dict[str, float] = {}
        self._repeats: list[bytes] = []
        self._timer: asyncio.TimerHandle | None = None
        self._next: asyncio.TimerHandle | None = None

    def start(self) -> None:
        """Advertise the usual topics: the bridge keeps nothing from an earlier connection."""
        self._advertise_next(list(self._usual))

    def _advertise_next(self, left: list[tuple[str, str]]) -> None:
        """Advertise one batch, then the next: all topics of a large fleet at once would delay a pause."""
        for topic, type_ in left[:AT_ONCE]:
            if topic not in self._advertised:
                with suppress(LinkError):
                    self._advertise(topic, type_)
        if left := left[AT_ONCE:]:
            loop = asyncio.get_running_loop()
            self._next = loop.call_later(BETWEEN, self._advertise_next, left)

    def _advertise(self, topic: str, type_: str) -> None:
        self._connection.send(operations.advertise(topic, type_))
        self._advertised[topic] = time.monotonic()

    def prepare(self, one: Publication) -> float:
        """Advertise a topic, and return the seconds until its subscribers are connected. Raises LinkError."""
        if one.address not in self._advertised:
            self._advertise(one.address, one.type)
        return max(0.0, self._advertised[one.address] + KNOWN_AFTER - time.monotonic())

    def send(self, one: Publication) -> None:
        """Publish now, and once more if the first message may be lost. Raises LinkError."""
        self.prepare(one)
        frame = operations.publish(one.address, one.type, one.message)
        self._connection.send(frame)
        if one.is_request:
            return  # carried out twice; a bridge of ROS 2 keeps it for late subscribers for a second
        known_at = self._advertised[one.address] + KNOWN_AFTER
        # A message after a repeated one is repeated after it, too: a pause must be the last message.
        if self._repeats or known_at > time.monotonic():
            self._repeats.append(frame)
            self._repeat_at(known_at)

    def _repeat_at(self, at: float) -> None:
        loop = asyncio.get_running_loop()
        when = loop.time() + at - time.monotonic()
        if self._timer is not None:
            when = max(when, self._timer.when())
            self._timer.cancel()
        self._timer = loop.call_at(when, self._repeat)

    def _repeat(self) -> None:
        frames, self._repeats, self._timer = self._repeats, [], None
        with suppress(LinkError):
            for frame in frames:
                self._connection.send(frame)

    def stop(self) -> None:
        """Cancel repeats and forget the advertisements of a lost connection."""
        for timer in (self._timer, self._next):
            if timer is not None:
                timer.cancel()
        self._repeats = []
        self._timer = None
        self._next = None
        self._advertised.clear()

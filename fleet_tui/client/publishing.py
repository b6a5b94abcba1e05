"""Publications of commands on one connection: advertised before they are needed, repeated where that was too
late."""

import asyncio
import time
from collections.abc import Iterable
from contextlib import suppress

from fleet_tui.adapters.adapter import Publication
from fleet_tui.adapters.ros import operations
from fleet_tui.errors import LinkError
from fleet_tui.transports.rosbridge.connection import Connection

KNOWN_AFTER = 0.3
"""Seconds until subscribers have come to a topic that was advertised: what leaves before may be lost."""


class Publishing:
    """Runs on the network loop. `usual` are names and types of topics that are advertised on each
    connection."""

    def __init__(self, connection: Connection, usual: Iterable[tuple[str, str]]) -> None:
        self._connection, self._usual = connection, tuple(usual)
        self._advertised: dict[str, float] = {}
        self._repeats: set[asyncio.TimerHandle] = set()

    def start(self) -> None:
        """Advertise: the bridge remembers nothing of us."""
        for topic, type_ in self._usual:
            with suppress(LinkError):
                self._advertise(topic, type_)

    def _advertise(self, topic: str, type_: str) -> None:
        self._connection.send(operations.advertise(topic, type_))
        self._advertised[topic] = time.monotonic()

    def send(self, one: Publication) -> None:
        """Publish now, and once more where the first message may be lost. Raises LinkError."""
        if one.address not in self._advertised:
            self._advertise(one.address, one.type)
        frame = operations.publish(one.address, one.type, one.message)
        self._connection.send(frame)
        wait = self._advertised[one.address] + KNOWN_AFTER - time.monotonic()
        if wait > 0.0:
            loop = asyncio.get_running_loop()
            self._repeats = {one for one in self._repeats if one.when() > loop.time()}
            self._repeats.add(loop.call_later(wait, self._connection.send, frame))

    def stop(self) -> None:
        """Cancel repeats and forget the advertisements of a lost connection."""
        for repeat in self._repeats:
            repeat.cancel()
        self._repeats.clear()
        self._advertised.clear()

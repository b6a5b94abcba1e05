"""Connections to an MQTT broker: opened, watched, and opened again after a loss, for ever."""

import asyncio
import logging
import random
import secrets
from collections.abc import Sequence

from fleet_tui.config.schema import Link
from fleet_tui.links.transports.mqtt.listener import BrokerListener
from fleet_tui.links.transports.mqtt.session import BrokerSession
from fleet_tui.links.transports.reasons import refusal
from fleet_tui.text.errors import FleetError, LinkError
from fleet_tui.text.language import Message

LOG = logging.getLogger(__name__)

FIRST_DELAY = 1.0
LONGEST_DELAY = 5.0
JITTER = 0.25
# After a connection of this length the next loss is retried quickly.
SETTLED_AFTER = 5.0


class BrokerConnection:
    """One connection to a broker that sends now or not at all. Everything runs on the network loop."""

    def __init__(self, link: Link, listener: BrokerListener) -> None:
        self._link = link
        self._listener = listener
        # Two clients of one id would throw each other out; the same one after a loss throws out the lost one.
        self._client_id = f"fleet-tui-{secrets.token_hex(6)}"
        self._session: BrokerSession | None = None
        self._running: asyncio.Task[None] | None = None

    def connect(self) -> None:
        self._running = asyncio.ensure_future(self._run())

    @property
    def is_connected(self) -> bool:
        """Tell whether messages can be sent."""
        return self._session is not None

    @property
    def silence(self) -> float:
        """Seconds for which the broker owes us an answer, 0 if it owes none."""
        return self._session.silence if self._session else 0.0

    def subscribe(self, patterns: Sequence[str]) -> None:
        """Subscribe to topics in one request. Raises LinkError without a connection."""
        self._open_session().subscribe(patterns)

    def unsubscribe(self, patterns: Sequence[str]) -> None:
        """Unsubscribe from topics in one request. Raises LinkError without a connection."""
        self._open_session().unsubscribe(patterns)

    def publish(self, topic: str, payload: bytes) -> None:
        """Send a message with QoS 0, not retained. Raises LinkError without a connection."""
        self._open_session().publish(topic, payload)

    def check_open(self) -> None:
        """Raise LinkError without a connection."""
        self._open_session()

    def _open_session(self) -> BrokerSession:
        if self._session is None:
            raise LinkError(Message("no link"))
        return self._session

    async def _run(self) -> None:
        delay, loop = FIRST_DELAY, asyncio.get_running_loop()
        while True:
            self._listener.on_connecting()
            began = loop.time()
            reason = await self._attempt()
            if loop.time() - began > SETTLED_AFTER:
                delay = FIRST_DELAY
            wait = delay * (1 + random.random() * JITTER)
            delay = min(delay * 1.7, LONGEST_DELAY / (1 + JITTER))
            self._listener.on_lost(reason, wait)
            await asyncio.sleep(wait)

    async def _attempt(self) -> Message:
        """Connect once, and return the reason of the end of the connection."""
        session = BrokerSession(self._link, self._client_id, self._listener)
        try:
            await session.open()
            self._session = session
            self._listener.on_open()
            return await session.ended()
        except (OSError, ValueError, FleetError) as problem:
            return refusal(problem, self._link)
        finally:
            self._session = None
            session.close()

    def shut(self) -> None:
        """Close permanently."""
        if self._running is not None:
            self._running.cancel()

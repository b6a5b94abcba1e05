"""A console on a real broker, and a simple vehicle that a test speaks for."""

import asyncio
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from fleet_tui.config.load import from_text
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.link import CommandPath
from tests.support.broker import RealBroker
from tests.support.links import linked
from tests.support.mqtt_peer import Peer, Told
from tests.support.polling import until
from tests.support.vda_fleet import config_text
from tests.support.vda_messages import BASE, message, state
from tests.support.watched_store import WatchedStore


class SpokenFor:
    """Vehicle KIT 0001: sends what a test says, and keeps what it is told."""

    def __init__(self, broker: RealBroker) -> None:
        will = f"{BASE}/connection", message(connectionState="CONNECTIONBROKEN")
        self.peer = Peer(broker.port, f"{BASE}/order", f"{BASE}/instantActions", will=will)
        self.peer.publish(f"{BASE}/connection", message(connectionState="ONLINE"), retain=True, qos=1)

    def say(self, **fields: Any) -> None:
        self.peer.publish(f"{BASE}/state", state(**fields))

    @property
    def told(self) -> list[Told]:
        return self.peer.told

    @property
    def actions(self) -> list[dict[str, Any]]:
        """The instant actions that it was sent."""
        return [json.loads(one) for one in self.peer.told_on(f"{BASE}/instantActions")]

    async def next(self, name: str, count: int = 1) -> dict[str, Any]:
        """The newest of so many messages of a topic, once whoever sent it has done all else as well."""
        topic = f"{BASE}/{name}"
        await until(lambda: len(self.peer.told_on(topic)) >= count)
        await asyncio.sleep(0.001)  # it passes when all wait
        found: dict[str, Any] = json.loads(self.peer.told_on(topic)[count - 1])
        return found


@asynccontextmanager
async def console_on(
    broker: RealBroker, role: str = "master", settings: str = ""
) -> AsyncIterator[tuple[FleetLink, WatchedStore]]:
    config = from_text(config_text(broker.url, role, settings))
    async with linked(config) as (link, store):
        await store.until(lambda state: state.links["broker"].command_path is CommandPath.ALIVE)
        yield link, store

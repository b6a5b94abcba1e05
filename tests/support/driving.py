"""A drive over a real loopback bridge, and the frames that arrive there."""

import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from typing import Any

from msgspec.structs import replace

from fleet_tui.model.link import CommandPath
from fleet_tui.model.set_up.driving import STILL, DrivePhase, HandDrive, Speeds, Steering
from fleet_tui.robots.profile import DriveConfig
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.links import linked, path
from tests.support.watched_store import WatchedStore, config_of

R0 = "robot_0"
TOPIC = f"/{R0}/cmd_vel"
AHEAD = Speeds(0.3)


class LiveDrive:
    """A drive of the first robot of a server."""

    def __init__(self, drive: HandDrive, store: WatchedStore, server: RosbridgeServer, topic: str) -> None:
        self.drive, self.store, self.server, self._topic = drive, store, server, topic

    @property
    def frames(self) -> list[Speeds]:
        """The twists that the bridge received from clients."""
        found = [one["msg"] for one in self.server.bridge.received if self._is_frame(one)]
        twists: list[Any] = [one.get("twist", one) for one in found]
        return [Speeds(one["linear"]["x"], one["linear"]["y"], one["angular"]["z"]) for one in twists]

    def _is_frame(self, operation: dict[str, Any]) -> bool:
        return operation.get("op") == "publish" and operation.get("topic") == self._topic

    async def ready(self) -> None:
        await self.store.until(lambda _: self.drive.state.phase is not DrivePhase.STARTING)
        assert self.drive.state.phase is DrivePhase.READY, self.drive.state.reason

    async def ended(self) -> str:
        """Wait for its end, and return the reason."""
        await self.store.until(lambda _: self.drive.state.phase is DrivePhase.ENDED)
        return self.drive.state.reason

    async def moving(self, seconds: float = 30.0) -> None:
        """Hold a key until some frames have moved the robot."""
        self.drive.steer(Steering(AHEAD, time.monotonic() + seconds))
        await self.store.until(lambda _: len([one for one in self.frames if one != STILL]) >= 3)


@asynccontextmanager
async def driving(
    server: RosbridgeServer, url: str = "", topic: str = "/{robot}/cmd_vel", limits: DriveConfig | None = None
) -> AsyncIterator[LiveDrive]:
    """Begin to drive the first robot of a server, perhaps through a proxy before it; `limits`: those of its
    profile."""
    config = config_of(url or server.url)
    named = replace(config.profile, topics={**config.profile.topics, "drive": topic}, drive=limits)
    async with linked(replace(config, profile=named)) as (link, store):
        await store.until(path(CommandPath.ALIVE))
        yield LiveDrive(link.drive(R0), store, server, topic.replace("{robot}", R0))

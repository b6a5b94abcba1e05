"""The frames of the robots' poses, read from their messages."""

import asyncio
import time
from collections.abc import Mapping
from contextlib import suppress

from fleet_tui.config.entries import DEFAULT_LINK, RobotEntry
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config
from fleet_tui.links.discovery.recognition import Found
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.model.events import PoseReported
from fleet_tui.robots.adapter import Feed
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.errors import LinkError

WITHIN = 2.0
"""Seconds within which a robot that is online sends its pose."""
MOST = 100
BATCH = 20
"""Maximum number of robots to listen to; subscriptions at once, of which a real bridge needs 20 ms for
each."""


async def collect_frames(
    wire: BridgeConnection, found: Found, types: Mapping[str, str], until: float
) -> dict[str, str]:
    """Return the frame_id of each robot's poses, of those that are online and whose frames mean floors.
    `types` of the existing topics: a wrong type would make one unusable for every client."""
    poses = [feed for feed in _poses(wire, found) if same_type(types.get(feed.address, ""), feed.type)][:MOST]
    try:
        for first in range(0, len(poses), BATCH):
            for feed in poses[first : first + BATCH]:
                wire.subscribe(feed, types[feed.address], latched=False)
            await wire.beat(max(0.1, until - time.monotonic()))
    except LinkError:
        return {}
    with suppress(TimeoutError):
        async with asyncio.timeout(min(WITHIN, until - time.monotonic())):
            while not all(one.count for one in wire.listening.values()) and not wire.lost:
                wire.arrived.clear()
                await wire.arrived.wait()
    events = [one.event for one in wire.listening.values()]
    return {one.robot: one.frame_id.lstrip("/") for one in events if isinstance(one, PoseReported)}


def _poses(wire: BridgeConnection, found: Found) -> list[Feed]:
    """Return the topics of poses, and register their readers."""
    profiles = {kind: Profile(kind=kind, topics=one.topics) for kind, one in found.items()}
    robots = [RobotEntry(robot, profile=kind) for kind, one in found.items() for robot in one.robots]
    config = Config(robots=robots, profiles=profiles)
    wire.adapters = adapters = adapters_of(config)
    feeds = feeds_of(config, adapters, DEFAULT_LINK)
    return [one for one in feeds if one.fast and adapters[one.robot].kind.frames_are_floors]

"""Lasers placed by the static frames of a real loopback bridge of either ROS: read once, and left."""

import math
from collections.abc import AsyncIterator
from functools import partial
from typing import Any

import numpy as np
import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Config
from fleet_tui.links.rosbridge.set_up.stream_writer import Mounts
from fleet_tui.model.geometry import Pose
from fleet_tui.model.set_up.frames import Mount, Transform
from fleet_tui.model.set_up.streams import Beams, LaserScan, beams_of
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.senses.laser import BEAMS, MOUNT, RANGE, ranges
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.state.streams import Streams
from fleet_tui.text.limits import MOST_FRAMES
from tests.support.fleets import R0, fleet
from tests.support.links import linked
from tests.support.nav2_site import LONG_AGO
from tests.support.watched_store import WatchedStore, config_of

TOPIC = "/tf_static"
NO_TURN = (0.0, 0.0, 0.0, 1.0)
SCAN = LaserScan(np.ones(1, np.float32), 0.0, 0.1, 0.1, 9.0, "laser", None)


@pytest.fixture(params=[ROS1, ROS2], ids=["ros1", "ros2"])
async def site(request: pytest.FixtureRequest) -> AsyncIterator[RosbridgeServer]:
    dialect: Dialect = request.param
    running = RosbridgeServer(OhFleet(robots=2, floors=1, seed=1, quiet=True), dialect=dialect)
    await running.start()
    running.bridge.started -= LONG_AGO
    yield running
    await running.stop()


def named(server: RosbridgeServer, **robot: Any) -> Config:
    config = config_of(server.url, robots=2)
    profile = replace(config.profile, topics={"scan": "/{robot}/scan"})
    robots = [replace(one, **robot) for one in config.robots]
    return replace(config, profile=profile, robots=robots)


def beams(store: WatchedStore, robot: str = R0) -> Beams | None:
    found = store.streams.get(robot, "scan")
    return found.value if found is not None and isinstance(found.value, Beams) else None


def is_mounted(store: WatchedStore, robot: str, _: object) -> bool:
    found = beams(store, robot)
    return found is not None and found.is_mounted


def operations(server: RosbridgeServer) -> list[dict[str, Any]]:
    return [dict(one) for one in server.bridge.received if one.get("topic") == TOPIC]


async def test_a_scan_is_placed_by_frames_that_are_subscribed_until_then(site: RosbridgeServer) -> None:
    async with linked(named(site)) as (_, store):
        await store.until(lambda state: all(robot.pose for robot in state.robots.values()))
        assert operations(site) == []
        for name in ("robot_1", R0):
            store.streams.watch(name, "scan")
            await store.until(partial(is_mounted, store, name))
        robot = site.world.robots[R0]
        true = ranges(robot.floor.cells, robot.pose.after(MOUNT))
        scan = LaserScan(true, -math.pi, 2 * math.pi / BEAMS, 0.1, RANGE, "", None)
        found = beams(store)
        assert found and np.allclose(found.points, beams_of(scan, MOUNT).points, atol=0.01)
        await store.until(lambda _: not site.bridge.subscribers(TOPIC))
    asked = operations(site)
    assert [one["op"] for one in asked][:2] == ["subscribe", "unsubscribe"]
    assert asked[0]["queue_length"] >= 10 and asked[0]["throttle_rate"] == 0


async def test_without_frames_it_is_sought_for_a_while_and_then_unknown(site: RosbridgeServer) -> None:
    site.bridge.muted.add(TOPIC)
    async with linked(named(site)) as (_, store):
        await store.until(lambda state: state.robots[R0].pose)
        store.streams.watch(R0, "scan")
        await store.until(lambda _: (it := beams(store)) and it.is_sought and site.bridge.subscribers(TOPIC))
        await store.until(lambda _: (it := beams(store)) and not it.is_sought)
        found = beams(store)
        assert found and not found.is_mounted
        await store.until(lambda _: not site.bridge.subscribers(TOPIC))


async def test_a_configured_laser_needs_no_frames(site: RosbridgeServer) -> None:
    async with linked(named(site, laser=(0.5, 0.0, 0.0), laser_flipped=True)) as (_, store):
        await store.until(lambda state: state.robots[R0].pose)
        store.streams.watch(R0, "scan")
        await store.until(partial(is_mounted, store, R0))
    assert operations(site) == []


def test_frames_of_several_publishers_add_up_and_their_number_is_limited() -> None:
    it, robot = Mounts(Streams()), fleet().robots[R0]
    it.take(R0, {"laser": Transform("mast", (1.0, 0.0, 0.0), NO_TURN)})
    assert it.of(robot, SCAN, 1.0) is None
    it.take(R0, {"mast": Transform("base_link", (0.0, 2.0, 0.0), NO_TURN)})
    assert it.of(robot, SCAN, 1.0) == Mount(Pose(1.0, 2.0))
    assert it.of(replace(robot, base_frame="mast"), SCAN, 1.0) == Mount(Pose(1.0, 0.0))
    it.take(R0, {f"f{n}": Transform("base_link", (0.0, 0.0, 0.0), NO_TURN) for n in range(MOST_FRAMES)})
    assert it.of(robot, SCAN, 1.0) is None

"""Set-up over a real loopback bridge: scans and paths on demand, poses, goals and mapping, with and without
rosapi."""

from collections.abc import AsyncIterator
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.commands.set_up.checks import map_of
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.set_up.commands import CancelGoal, SendGoal, SetMapping, SetPose, SetUpCommand
from fleet_tui.model.set_up.streams import Beams, PlannedPath
from fleet_tui.simulator.kinds import KINDS, play
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.view.set_up.scan_match import scan_match
from tests.support.links import finished, linked
from tests.support.nav2_site import Site, nav2_ready, nav2_site
from tests.support.watched_store import WatchedStore, config_of

R0, F0 = "robot_0", "floor_0"
SCAN = f"/{R0}/scan"


@pytest.fixture
async def slow_site(tmp_path: Path) -> AsyncIterator[Site]:
    """A site whose robots take their time."""
    async with nav2_site(tmp_path, robots=1, speed=1.0, rate=10.0) as running:
        yield running


def subscribed(server: RosbridgeServer, topic: str) -> list[str]:
    """The compressions in which clients are subscribed to a topic."""
    sessions = server.bridge.channels.clients(topic)
    return [session.subscriptions[topic].compression for session in sessions]


async def test_a_scan_is_subscribed_while_it_is_watched(slow_site: Site) -> None:
    async with linked(slow_site.config) as (_, store):
        await store.until(nav2_ready)
        assert subscribed(slow_site.server, SCAN) == []
        store.streams.watch(R0, "scan")
        await store.until(lambda _: store.streams.get(R0, "scan"))
        assert subscribed(slow_site.server, SCAN) == ["cbor"]
        found = store.streams.get(R0, "scan")
        assert found is not None and isinstance(found.value, Beams) and found.taken_at <= found.at
        store.streams.unwatch(R0, "scan")
        await store.until(lambda _: not subscribed(slow_site.server, SCAN))


async def test_a_scan_comes_again_after_the_link(slow_site: Site) -> None:
    async with linked(slow_site.config) as (_, store):
        await store.until(nav2_ready)
        store.streams.watch(R0, "scan")
        await store.until(lambda _: store.streams.get(R0, "scan"))
        before = store.streams.get(R0, "scan")
        await slow_site.server.restart_bridge()
        await store.until(lambda _: store.streams.get(R0, "scan") is not before)


async def test_a_path_comes_with_the_plan_of_a_goal(slow_site: Site) -> None:
    async with linked(slow_site.config) as (_, store):
        await store.until(nav2_ready)
        store.streams.watch(R0, "path")
        slow_site.navigation().give(20.0, 7.0)
        await store.until(lambda _: store.streams.get(R0, "path"))
        found = store.streams.get(R0, "path")
        assert found is not None and isinstance(found.value, PlannedPath)
        assert found.value.points[-1].tolist() == [20.0, 7.0]


async def test_a_mislocalised_robot_is_put_right_by_its_scan(slow_site: Site) -> None:
    play(slow_site.server, [("mislocalised", R0)])
    true = slow_site.navigation().robot.pose
    async with linked(slow_site.config) as (link, store):
        link.show_map(R0, F0)
        store.streams.watch(R0, "scan")

        def share(state: FleetState) -> float | None:
            found = scan_match(state, state.robots[R0], F0, store.streams)
            return found.share if found else None

        await store.until(nav2_ready)
        await store.until(lambda state: share(state) is not None)
        assert (share(store.state) or 0.0) < 0.3
        record = await finished(link, store, SetPose(R0, F0, true))
        assert record.stage is Stage.CONFIRMED
        await store.until(lambda state: (share(state) or 0.0) > 0.9)


@pytest.mark.parametrize("fault", ["frozen-rosapi", "dead-rosapi"])
async def test_without_rosapi_a_pose_is_set_all_the_same(slow_site: Site, fault: str) -> None:
    play(slow_site.server, [(fault, R0)])
    async with linked(slow_site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, SetPose(R0, F0, Pose(3.0, 4.0, 1.0)))
        assert record.stage is Stage.CONFIRMED
        believed = slow_site.navigation().robot.belief.misplaced
        assert believed is not None and (round(believed.x, 6), round(believed.yaw, 6)) == (3.0, 1.0)


async def test_nothing_is_published_where_nobody_listens(slow_site: Site) -> None:
    topic = f"/{R0}/nowhere"
    named = replace(slow_site.config.profile, topics={"initial_pose": "/{robot}/nowhere"})
    async with linked(replace(slow_site.config, profile=named)) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, SetPose(R0, F0, Pose(3.0, 4.0, 1.0)))
        assert (record.stage, record.detail) == (Stage.NOT_SENT, f"nobody listens on {topic}")
    sent = [one for one in slow_site.server.bridge.received if one.get("topic") == topic]
    assert "publish" not in {one["op"] for one in sent}


async def told(server: RosbridgeServer, command: SetUpCommand) -> tuple[Stage, WatchedStore]:
    """The end of a command to one of the source's robots whose profile names everything."""
    config = config_of(server.url)
    names = KINDS["oh_ressources"].profile(1)
    named = replace(config.profile, topics=dict(names["topics"]), services=dict(names["services"]))
    async with linked(replace(config, profile=named)) as (link, store):
        link.show_map(R0, F0)
        await store.until(lambda state: state.robots[R0].pose and map_of(state, state.robots[R0], F0))
        record = await finished(link, store, command)  # type: ignore[arg-type]  # each is one of the union
        if isinstance(command, SetMapping):
            before = map_of(store.state, store.state.robots[R0], F0)
            await store.until(lambda state: map_of(state, state.robots[R0], F0) is not before)
        return record.stage, store


async def test_the_sources_robots_are_set_up_where_their_profile_says_how(server: RosbridgeServer) -> None:
    at = server.world.robots[R0].pose
    stage, _ = await told(server, SetPose(R0, F0, at.after(Pose(5.0, 0.0))))
    assert stage is Stage.CONFIRMED and server.world.robots[R0].belief.misplaced is not None
    server.world.robots[R0].belief.place(at, at)
    stage, _ = await told(server, SendGoal(R0, F0, at.after(Pose(9.0, 0.0))))
    assert stage is Stage.CONFIRMED
    stage, store = await told(server, CancelGoal(R0))
    assert stage is Stage.CONFIRMED and store.state.commands[-1].detail == "the robot stopped"


async def test_mapping_is_confirmed_by_the_robot_and_its_map_grows(server: RosbridgeServer) -> None:
    stage, store = await told(server, SetMapping(R0, True))
    assert stage is Stage.CONFIRMED
    robot = store.state.robots[R0]
    assert robot.mode is not None and robot.mode.value == "mapping"
    grid = map_of(store.state, robot, F0)
    assert grid is not None and grid.frame.width < 800 and robot.maps[F0].grid_at is not None

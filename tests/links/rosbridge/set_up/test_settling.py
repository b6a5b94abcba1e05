"""The calls of `settle` over a real loopback bridge: how many leave, and what is said of them."""

from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from fleet_tui.model.commands import CommandRecord, Stage
from fleet_tui.model.geometry import Pose
from fleet_tui.model.set_up.commands import Settle
from fleet_tui.robots.profile import Profile
from fleet_tui.simulator.ros.errors import ServiceError
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.links import finished, linked
from tests.support.nav2_site import Site, nav2_ready, nav2_site
from tests.support.watched_store import config_of

R0 = "robot_0"
SERVICE = f"/{R0}/request_nomotion_update"


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[Site]:
    """A site whose robot refines its pose by half with each call, from 8 m off."""
    async with nav2_site(tmp_path, robots=1, speed=1.0, rate=10.0) as running:
        robot = running.navigation().robot
        robot.place(robot.pose.after(Pose(8.0, 0.0)))
        running.server.bridge.services.answers[SERVICE] = lambda _: halved(running)
        yield running


def halved(site: Site) -> dict[str, Any]:
    robot = site.navigation().robot
    off = robot.pose.inverse.after(robot.belief.of(robot.pose))
    robot.place(robot.pose.after(Pose(off.x / 2, 0.0)))
    return {}


def called(site: Site) -> int:
    return sum(service == SERVICE for service, _ in site.server.bridge.services.calls)


async def settled(site: Site, command: Settle) -> CommandRecord:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        await store.until(lambda state: state.robots[R0].located)
        return await finished(link, store, command)


async def test_it_goes_on_until_the_pose_no_longer_changes(site: Site) -> None:
    robot = site.navigation().robot
    robot.place(robot.pose.after(Pose(2.0, 0.0)))
    record = await settled(site, Settle(R0))
    # 2 m off, then 1 m, then so near that the filter finds the true pose.
    assert (called(site), record.stage) == (3, Stage.CONFIRMED)
    assert record.detail == "3 calls, pose changed by 2.00 m and 0°, by 0.00 m and 0° at the last"


async def test_an_unchanged_pose_ends_it(site: Site) -> None:
    robot = site.navigation().robot
    robot.place(robot.pose)
    record = await settled(site, Settle(R0))
    assert (called(site), record.stage) == (1, Stage.CONFIRMED)
    assert record.detail == "1 call, pose changed by 0.00 m and 0°"


async def test_the_count_is_the_limit(site: Site) -> None:
    record = await settled(site, Settle(R0, 2))
    assert called(site) == 2
    assert record.detail == "2 calls, pose changed by 6.00 m and 0°, still by 2.00 m and 0° at the last"


async def test_without_a_pose_no_topic_shows_it(site: Site) -> None:
    site.server.bridge.services.answers[SERVICE] = lambda _: {}
    record = await settled(site, Settle(R0, 2))
    assert (called(site), record.stage) == (2, Stage.UNVERIFIABLE)
    assert record.detail == "2 calls, no pose reported since"


async def test_a_call_that_fails_is_the_last(site: Site) -> None:
    def once(_: dict[str, Any]) -> dict[str, Any]:
        if called(site) > 1:
            raise ServiceError(f"Service {SERVICE} does not exist")
        return halved(site)

    site.server.bridge.services.answers[SERVICE] = once
    record = await settled(site, Settle(R0))
    assert (called(site), record.stage) == (2, Stage.REFUSED)
    assert record.detail == f"call 2 of at most 5: Service {SERVICE} does not exist"


async def test_nothing_is_called_after_the_link_was_lost(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        await store.until(lambda state: state.robots[R0].located)
        before = store.state.robots[R0].located
        command_id = link.submit(Settle(R0))
        # The first call is answered, and the next one waits for the pose.
        await store.until(lambda state: state.robots[R0].located != before)
        await site.server.restart_bridge()
        state = await store.until(
            lambda state: any(one.id == command_id and one.is_decided for one in state.commands)
        )
        (record,) = state.commands
        assert record.stage is Stage.NOT_CONFIRMED and "call 2 of at most 5: not sent: " in record.detail
        await store.until(nav2_ready)
        again = await finished(link, store, Settle(R0, 1))
        assert again.stage is Stage.CONFIRMED and called(site) == 2


async def test_a_robot_whose_poses_come_all_the_time_proves_nothing(server: RosbridgeServer) -> None:
    config = config_of(server.url)
    server.bridge.services.answers["/robot_0/Application_layout/Pause"] = lambda _: {}
    services, types = {"settle": "/{robot}/Application_layout/Pause"}, {"settle": "std_srvs/Trigger"}
    named = Profile(services=services, service_types=types)
    async with linked(replace(config, profile=named)) as (link, store):
        await store.until(lambda state: state.robots[R0].pose)
        record = await finished(link, store, Settle(R0))
    assert record.stage is Stage.UNVERIFIABLE and record.detail.startswith("1 call, pose changed by 0.00 m")

"""Whether the servers of Nav2 are active, asked beside all else."""

from pathlib import Path

import pytest

from fleet_tui.config.fleet import watching
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.nav2.faults import FAULTS
from fleet_tui.situation.navigation import inactive
from tests.support.links import finished, linked
from tests.support.nav2_site import keeping, nav2_ready, nav2_site

R0 = "robot_0"


def told(state: FleetState) -> str:
    fact = inactive(state, state.robots[R0])
    return fact.text if fact is not None else ""


@pytest.mark.parametrize(
    ("fault", "text"),
    [
        ("inactive", "Nav2 inactive: paused or not started"),
        ("node-down", "Nav2 inactive: controller_server down"),
        ("bring-up", "Nav2 inactive: no pose yet: set one"),
    ],
)
async def test_why_a_navigation_is_not_active(tmp_path: Path, fault: str, text: str) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(site.config) as (_, store):
        FAULTS[fault][1](site.server, R0)
        await store.until(lambda state: told(state) == text)


async def test_a_manager_that_hangs_delays_no_command_and_its_robot_starts_with_a_pose(
    tmp_path: Path,
) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site:
        FAULTS["humble"][1](site.server, R0)
        FAULTS["bring-up"][1](site.server, R0)
        async with linked(site.config, queue=keeping()) as (link, store):
            await store.until(told)
            assert (await finished(link, store, PauseRobot(R0))).stage is Stage.CONFIRMED
            site.navigation().robot.place(Pose(1.0, 1.0))
            await store.until(lambda state: nav2_ready(state) and not told(state))


async def test_a_console_that_may_only_read_asks_no_manager(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(watching(site.config)) as (_, store):
        FAULTS["inactive"][1](site.server, R0)
        await store.until(nav2_ready)
        later = store.state.now + 20.0
        await store.until(lambda state: state.now > later)
        assert site.server.bridge.services.calls == [] and not told(store.state)

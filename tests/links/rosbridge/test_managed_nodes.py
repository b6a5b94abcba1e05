"""Whether the servers of Nav2 are active, asked beside all else."""

from pathlib import Path

import pytest

from fleet_tui.cli.session import is_known
from fleet_tui.config.fleet import watching
from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.robots.ros.reading import DIAGNOSTICS, ROSOUT
from fleet_tui.simulator.nav2.faults import FAULTS
from fleet_tui.situation.navigation import inactive
from tests.support.links import finished, linked
from tests.support.nav2_site import keeping, nav2_ready, nav2_site

R0 = "robot_0"


def told(state: FleetState) -> str:
    fact = inactive(state, state.robots[R0])
    return fact.text if fact is not None else ""


CAUSES = {
    "inactive": "Nav2 inactive: paused or not started",
    "node-down": "Nav2 inactive: controller_server down",
    "bring-up": "Nav2 inactive: no pose yet: set one",
}


@pytest.mark.parametrize(("fault", "text"), CAUSES.items())
async def test_why_a_navigation_is_not_active(tmp_path: Path, fault: str, text: str) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(site.config) as (_, store):
        FAULTS[fault][1](site.server, R0)
        await store.until(lambda state: told(state) == text)


@pytest.mark.parametrize(("fault", "text"), CAUSES.items())
async def test_a_console_that_may_only_read_knows_it_without_a_call(
    tmp_path: Path, fault: str, text: str
) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site:
        FAULTS[fault][1](site.server, R0)
        async with linked(watching(site.config)) as (_, store):
            await store.until(lambda state: told(state) == text)
            assert site.server.bridge.services.calls == []


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


async def test_it_is_over_in_a_console_that_may_only_read_when_the_manager_says_so(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(watching(site.config)) as (_, store):
        await store.until(nav2_ready)
        site.navigation().active = False
        await store.until(told)
        site.navigation().active = True
        await store.until(lambda state: not told(state))


async def test_a_manager_that_calls_itself_active_beside_a_dead_node_is_not_believed(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site:
        del site.server.bridge.services.offered[f"/{R0}/controller_server/get_state"]
        async with linked(watching(site.config)) as (_, store):
            await store.until(lambda state: told(state) == CAUSES["node-down"])


async def test_a_node_that_dies_later_is_known_though_its_manager_calls_itself_active(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(watching(site.config)) as (_, store):
        await store.until(is_known)
        del site.server.bridge.services.offered[f"/{R0}/controller_server/get_state"]
        await store.until(lambda state: told(state) == CAUSES["node-down"])


async def test_diagnostics_are_read_once_for_all_robots_and_also_after_their_page_is_closed(
    tmp_path: Path,
) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(watching(site.config)) as (link, store):
        await store.until(is_known)

        def asked(topic: str) -> list[str]:
            return [one["op"] for one in site.server.bridge.received if one.get("topic") == topic]

        assert asked(DIAGNOSTICS) == ["subscribe"]
        before = asked(ROSOUT).count("subscribe")
        for on in (True, False, True):
            link.subscribe_logs(on)
        await store.until(lambda _: asked(ROSOUT).count("subscribe") == before + 2)
        assert "unsubscribe" not in asked(DIAGNOSTICS)


async def test_a_site_without_diagnostics_is_known_as_one_that_says_nothing(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site:
        site.server.bridge.withdraw(DIAGNOSTICS)
        async with linked(watching(site.config)) as (_, store):
            state = await store.until(is_known)
            assert not told(state or store.state)
            assert DIAGNOSTICS not in site.server.bridge.subscribed()

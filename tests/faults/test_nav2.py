"""What happens to a console when parts of Nav2 fail."""

from pathlib import Path

from fleet_tui.model.commands import PauseRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.nav2.navigation import SPIN
from fleet_tui.situation.navigation import inactive
from fleet_tui.situation.reported_motion import moves_despite_pause
from fleet_tui.situation.robots import adrift
from tests.support.fault_report import report
from tests.support.links import linked
from tests.support.nav2_site import Site, keeping, nav2_ready, nav2_site
from tests.support.proxied_link import Stopwatch

R0 = "robot_0"
LONG_SPIN = {"target_yaw": 500.0, "time_allowance": {"sec": 600, "nanosec": 0}}


def why_inactive(state: FleetState) -> str:
    """The text of its row, empty while its navigation is active."""
    fact = inactive(state, state.robots[R0])
    return fact.text if fact is not None else ""


def pause_text(state: FleetState) -> str:
    """The text of its row while it is paused and moves."""
    fact = moves_despite_pause(state, state.robots[R0])
    return fact.text if fact is not None else ""


def revived(site: Site) -> None:
    """Start the dead controller again."""
    services = site.server.bridge.services
    kept = services.offered[f"/{R0}/planner_server/get_state"]
    services.offered[f"/{R0}/controller_server/get_state"] = kept
    site.navigation().active = True


async def test_a_node_of_nav2_has_died(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(site.config) as (_, store):
        await store.until(nav2_ready)
        watch = Stopwatch(store)
        play(site.server, [("node-down", R0)])
        noticed = await watch.until(why_inactive)
        told = why_inactive(store.state)
        watch = Stopwatch(store)
        revived(site)
        healed = await watch.until(lambda state: not why_inactive(state))
    assert told == "Nav2 inactive: controller_server down"
    report(
        "Nav2: a node has died", "its controller; the manager takes all others down", told, noticed, healed
    )


async def test_nav2_waits_for_a_pose(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site:
        play(site.server, [("bring-up", R0)])
        async with linked(site.config) as (_, store):
            watch = Stopwatch(store)
            noticed = await watch.until(why_inactive)
            told = why_inactive(store.state)
            watch = Stopwatch(store)
            site.navigation().robot.place(Pose(1.0, 1.0))
            healed = await watch.until(lambda state: nav2_ready(state) and not why_inactive(state))
    assert told == "Nav2 inactive: no pose yet: set one"
    report("Nav2: its start waits for a pose", "its lifecycle manager does not answer", told, noticed, healed)


async def test_a_spin_goes_on_through_a_pause(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        server = site.navigation().servers[SPIN]
        server.refuses_cancel = True
        site.navigation().take(SPIN, LONG_SPIN)
        await store.until(lambda state: (motion := state.robots[R0].motion) and motion.value.is_moving)
        watch = Stopwatch(store)
        link.submit(PauseRobot(R0))
        noticed = await watch.until(lambda state: pause_text(state) == "still moving")
        watch = Stopwatch(store)
        server.refuses_cancel = False
        link.submit(PauseRobot(R0))
        healed = await watch.until(lambda state: not pause_text(state))
    seen = "stopping, after 3 s still moving with an alarm; never paused"
    report("Nav2: a motion goes on through a pause", "another client's spin", seen, noticed, healed)


async def test_a_localisation_dies_on_the_way(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(site.config) as (_, store):
        await store.until(nav2_ready)
        play(site.server, [("dead-localisation", R0)])
        site.navigation().give(35.0, 20.0)
        await store.until(lambda _: site.navigation().robot.is_unlocalised)
        watch = Stopwatch(store)
        noticed = await watch.until(lambda state: adrift(state, state.robots[R0]))
    seen = "pose estimated, localisation silent for N s"
    report("Nav2: its localisation dies on the way", "its wheels count on", seen, noticed, None)

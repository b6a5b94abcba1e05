"""Each fault of robots with Nav2: what the operator is told of it."""

import msgspec
import pytest

from fleet_tui.config.schema import Config
from fleet_tui.links.transports.rosbridge import connection
from fleet_tui.model.commands import CancelOrder, PauseRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import KINDS, play
from fleet_tui.simulator.nav2 import faults
from fleet_tui.simulator.navigating import faults as shared_faults
from fleet_tui.situation.why.why import reasons
from fleet_tui.state import reducer as apply
from tests.support.links import finished, linked
from tests.support.nav2_site import Holds, Site, keeping, nav2_ready, reached, record_of

R0 = "robot_0"


@pytest.fixture(autouse=True)
def soon(monkeypatch: pytest.MonkeyPatch) -> None:
    """A lost connection comes back at once."""
    monkeypatch.setattr(connection, "FIRST_DELAY", 0.05)
    monkeypatch.setattr(faults, "AWHILE", 0.3)
    monkeypatch.setattr(shared_faults, "AWHILE", 0.3)


def plant(site: Site, text: str) -> None:
    """Play faults on the server."""
    play(site.server, parse_faults(text, site.server.bridge.services.robots, KINDS["nav2"].faults))


def quick(site: Site, **limits: float) -> Config:
    """The configuration with short limits."""
    return msgspec.structs.replace(site.config, alarms=msgspec.structs.replace(site.config.alarms, **limits))


def alarmed(kind: str, text: str = "") -> Holds:
    """Tell whether an alarm of a kind with a text exists."""
    return lambda state: [one for one in state.alarms if one.key == (R0, kind) and text in one.condition.text]


def why(state: FleetState) -> list[str]:
    """The reasons for which the robot stands still."""
    return [one.name for one in reasons(state, state.robots[R0])]


async def test_inactive_and_reject_orders_are_refused(site: Site) -> None:
    plant(site, f"inactive:{R0},reject:robot_1")
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        for robot in (R0, "robot_1"):
            record = await finished(link, store, site.to("Receiving", robot=robot))
            assert (record.stage, record.detail) == (Stage.REFUSED, "Action goal was rejected")


async def test_a_goal_that_an_allow_list_drops_was_not_sent_and_blames_the_list(site: Site) -> None:
    plant(site, f"actions-glob:{R0}")
    text = "the bridge does not allow it (actions_glob)"
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Receiving"))
        assert (record.stage, record.detail) == (Stage.NOT_SENT, text)
        told = f"the bridge does not allow /{R0}/navigate_to_pose (actions_glob)"
        await store.until(
            lambda state: any(one.key[1] == "messages" and one.condition.text == told for one in state.alarms)
        )
        again = await finished(link, store, site.to("Receiving"))
        assert (again.stage, again.detail) == (Stage.NOT_SENT, text)
        assert (await finished(link, store, PauseRobot(R0))).stage is Stage.CONFIRMED
    assert not site.navigation().received


async def test_a_rejection_that_nobody_tells_ends_as_not_confirmed(site: Site) -> None:
    plant(site, f"mute-rejection:{R0},reject:{R0}")
    async with linked(quick(site, not_confirmed_after=0.5)) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Receiving"))
        assert record.stage is Stage.NOT_CONFIRMED
        assert record.detail == "no answer; no new goal seen"


async def test_aborts_end_the_order_as_failed_with_the_code(site: Site) -> None:
    plant(site, f"aborts:{R0}")
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Consumidores"))
        ended = await reached(store, record.id, Stage.FAILED)
        detail = "no progress (error 105): Failed to make progress"
        assert ended.detail == detail


async def test_an_abort_without_a_reason_has_that_of_the_log(site: Site) -> None:
    plant(site, f"silent-aborts:{R0}")
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        link.subscribe_logs(True)
        record = await finished(link, store, site.to("Receiving"))
        await reached(store, record.id, Stage.FAILED)
        said = "Timed out while waiting for action server to acknowledge goal request for follow_path"
        await store.until(alarmed("command", f"failed: {said}"))


async def test_a_goal_of_another_client_replaces_ours(site: Site) -> None:
    site.server.speed = 1.0
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Consumidores"))
        site.navigation().give(8.0, 0.0)
        ended = await reached(store, record.id, Stage.REPLACED)
        assert "as reported by the robot" in ended.detail


async def test_foreign_cancel_is_cancelled_elsewhere(site: Site) -> None:
    plant(site, f"foreign-cancel:{R0}")
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Consumidores"))
        ended = await reached(store, record.id, Stage.CANCELLED_ELSEWHERE, Stage.FAILED, Stage.LOST)
        assert ended.stage is Stage.CANCELLED_ELSEWHERE


async def test_a_pause_that_services_glob_drops_is_not_sent(site: Site) -> None:
    plant(site, f"services-glob:{R0}")
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Consumidores"))
        pause = await finished(link, store, PauseRobot(R0))
        assert (pause.stage, pause.detail) == (Stage.NOT_SENT, "the bridge does not allow it (services_glob)")


async def test_a_cancel_that_is_refused_says_so_and_the_order_goes_on(site: Site) -> None:
    plant(site, f"refuse-cancel:{R0}")
    site.server.speed = 1.0
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores"))
        assert order.order_id is not None
        cancel = await finished(link, store, CancelOrder(R0, order.order_id))
        assert (cancel.stage, cancel.detail) == (Stage.REFUSED, "rejected by the robot")
        assert store.state.robots[R0].orders.open


async def test_a_pause_that_no_server_carries_out_is_not_confirmed(site: Site) -> None:
    plant(site, f"refuse-cancel:{R0}")
    site.server.speed = 1.0
    async with linked(quick(site, not_confirmed_after=0.5), queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Consumidores"))
        await store.until(lambda _: site.navigation().robot.driving)
        pause = await finished(link, store, PauseRobot(R0))
        assert pause.stage in (Stage.REFUSED, Stage.NOT_CONFIRMED), pause.detail


async def test_dead_servers_leave_the_order_open_and_cancels_unanswered(site: Site) -> None:
    config = quick(site, no_answer_after=0.5, not_confirmed_after=0.5)
    async with linked(config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores"))
        assert order.order_id is not None
        plant(site, f"dead-server:{R0}")
        await store.until(lambda _: not site.navigation().servers["navigate_to_pose"].alive)
        cancel = await finished(link, store, CancelOrder(R0, order.order_id))
        assert cancel.stage is Stage.NOT_CONFIRMED and "is in process" in cancel.detail


async def test_an_action_server_that_was_started_anew_knows_no_goal_any_more(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores"))
        waits = link.submit(site.to("Base"))
        server = site.navigation().servers["navigate_to_pose"]
        server.die()
        server.alive = True
        assert order.order_id is not None
        cancel = await finished(link, store, CancelOrder(R0, order.order_id))
        assert (cancel.stage, cancel.detail) == (Stage.REFUSED, "goal unknown to the robot")
        await reached(store, order.id, Stage.LOST)
        await store.until(lambda state: state.robots[R0].held)
        assert record_of(store.state, waits).stage is Stage.WAITING


async def test_a_pause_finds_out_that_the_goals_are_gone(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores"))
        server = site.navigation().servers["navigate_to_pose"]
        server.die()
        server.alive = True
        pause = await finished(link, store, PauseRobot(R0))
        assert (pause.stage, pause.detail) == (Stage.CONFIRMED, "stopped, no goal to keep")
        await reached(store, order.id, Stage.LOST)


async def test_goals_that_nothing_lists_after_a_lost_link_are_gone(
    site: Site, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(apply, "RELISTED_WITHIN", (1.0, 60.0))
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores"))
        await site.server.stop()
        for server in site.navigation().servers.values():
            server.die()
            server.alive = True
        async with site.started_again():
            ended = await reached(store, order.id, Stage.DONE, Stage.FAILED, Stage.LOST)
        assert ended.stage is Stage.LOST


async def test_without_feedback_orders_are_done_all_the_same(site: Site) -> None:
    plant(site, f"no-feedback:{R0}")
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Receiving"))
        await reached(store, record.id, Stage.DONE)
        assert store.state.robots[R0].progress is None


async def test_without_odometry_it_is_drawn_where_it_localised_last(site: Site) -> None:
    plant(site, f"no-odom:{R0}")
    async with linked(site.config) as (_, store):
        state = await store.until(lambda state: state.robots[R0].located and state.robots[R0].battery)
        assert state.robots[R0].pose is not None


async def test_one_that_is_lost_is_told_so(site: Site) -> None:
    plant(site, f"lost:{R0}")
    async with linked(site.config) as (_, store):
        await store.until(alarmed("localisation", "localisation uncertain: within "))
        await store.until(lambda state: "pose uncertain" in why(state))


async def test_an_obstacle_stops_it_and_recoveries_are_counted(site: Site) -> None:
    async with linked(quick(site, obstacle_after=0.2)) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Consumidores"))
        await store.until(lambda _: site.navigation().robot.driving)
        site.navigation().robot.block()
        await store.until(alarmed("blocked", "blocked "))
        await store.until(lambda state: why(state)[0].startswith("blocked ") and " s (seen)" in why(state)[0])
        await store.until(lambda state: "recovering" in why(state))


async def test_batteries_of_every_scale_and_none(site: Site) -> None:
    site.fleet.robots["robot_1"].percent = 0.01
    plant(site, f"percent:{R0},unmeasured:robot_1")
    async with linked(site.config) as (_, store):
        state = await store.until(lambda state: state.robots[R0].battery)
        battery = state.robots[R0].battery
        assert battery is not None and abs(battery.value - site.navigation().robot.battery) < 2.0
        assert state.robots["robot_1"].battery is None and not state.robots["robot_1"].faults


async def test_a_flat_battery_is_alarmed(site: Site) -> None:
    plant(site, f"battery:{R0}")
    async with linked(site.config) as (_, store):
        await store.until(alarmed("battery", "%"))


async def test_a_silent_robot_is_offline(site: Site) -> None:
    async with linked(quick(site, offline_after=0.5)) as (_, store):
        await store.until(nav2_ready)
        plant(site, f"silent:{R0}")
        await store.until(alarmed("offline"))
        assert store.state.is_online(store.state.robots["robot_1"])


async def test_a_bridge_of_humble_takes_orders_and_cancels_while_a_goal_is_under_way(site: Site) -> None:
    plant(site, f"humble:{R0}")
    site.server.speed = 1.0
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        first = await finished(link, store, site.to("Consumidores"))
        other = await finished(link, store, site.to("Receiving", robot="robot_1"))
        assert (first.stage, other.stage) == (Stage.CONFIRMED, Stage.CONFIRMED)
        assert first.order_id is not None
        cancel = await finished(link, store, CancelOrder(R0, first.order_id))
        assert cancel.stage is Stage.CONFIRMED
        await reached(store, first.id, Stage.CANCELLED)
        again = await finished(link, store, site.to("Receiving"))
        assert again.stage is Stage.CONFIRMED


async def test_a_bridge_without_nav2_msgs_refuses_orders_and_names_the_package(site: Site) -> None:
    plant(site, f"unsourced:{R0}")
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Receiving"))
        assert record.stage is Stage.REFUSED and "nav2_msgs" in record.detail


async def test_services_that_never_answer_leave_a_pause_to_telemetry(site: Site) -> None:
    plant(site, f"never:{R0}")
    site.server.speed = 1.0
    config = quick(site, no_answer_after=0.3, not_confirmed_after=0.3)
    async with linked(config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Consumidores"))
        pause = await finished(link, store, PauseRobot(R0))
        assert pause.stage is Stage.NOT_CONFIRMED and "is in process" in pause.detail

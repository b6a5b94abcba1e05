"""Orders of robots with Nav2, over a real loopback bridge: given, confirmed, driven, cancelled."""

import asyncio
from pathlib import Path

import pytest

from fleet_tui.links.transports.rosbridge import connection
from fleet_tui.model.commands import CancelOrder, ClearOrders, PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.link import Phase
from fleet_tui.model.order import OrderState, Stop, at_vertices
from fleet_tui.orders.local_queue import foreign
from fleet_tui.simulator.nav2.navigation import TO_POSE, WAYPOINTS
from fleet_tui.simulator.ros.goals import CANCELED, EXECUTING
from fleet_tui.state import reducer as apply
from tests.support.links import finished, linked, phase
from tests.support.nav2_site import Site, nav2_ready, nav2_site, reached

R0 = "robot_0"
FAR, NEAR = (35.0, 20.0), (8.0, 0.0)


@pytest.fixture(autouse=True)
def soon(monkeypatch: pytest.MonkeyPatch) -> None:
    """A lost connection comes back at once."""
    monkeypatch.setattr(connection, "FIRST_DELAY", 0.05)
    monkeypatch.setattr(connection, "LONGEST_DELAY", 0.2)


async def test_an_order_from_a_to_b_is_confirmed_and_driven_to_its_end(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Receiving", "Base"))
        assert record.stage is Stage.CONFIRMED
        assert record.detail == f"seen in the queue as order {record.order_id}"
        (order,) = store.state.robots[R0].orders.open
        assert order.stops == at_vertices(site.vertex("Receiving"), site.vertex("Base"))
        await store.until(lambda state: state.robots[R0].orders.orders[0].state is OrderState.IN_PROCESS)
        ended = await reached(store, record.id, Stage.DONE)
        assert ended.detail == f"order {record.order_id}: as reported by the robot"
    stages = [step.stage for step in ended.steps]
    assert stages == [Stage.CHECKED, Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED, Stage.DONE]
    pose = site.navigation().robot.pose
    assert abs(pose.x) < 0.1 and abs(pose.y) < 0.1
    assert len(site.navigation().servers[WAYPOINTS].goals) == 1


async def test_its_legs_are_no_orders_and_their_progress_is_its_own(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Receiving", "Base"))

        def on_the_second_leg(state: FleetState) -> bool:
            progress, listed = state.robots[R0].progress, state.robots[R0].orders.open
            assert [one.id for one in listed] in ([record.order_id], [])
            assert not foreign(state, state.robots[R0])
            return progress is not None and progress.value.stop == 1 and progress.value.metres is not None

        state = await store.until(on_the_second_leg)
        progress = state.robots[R0].progress
        assert progress is not None and progress.value.goal == record.order_id


async def test_an_order_to_b_is_one_goal_with_the_heading_of_the_way_there(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, site.to("Receiving"))
        assert record.stage is Stage.CONFIRMED
        await reached(store, record.id, Stage.DONE)
    assert [list(one) for one in site.navigation().received] == [["pose", "behavior_tree"]]
    pose = site.navigation().robot.pose
    assert (round(pose.x, 1), round(pose.y, 1), round(pose.yaw, 2)) == (0.0, 7.0, 1.57)


async def test_a_feedback_topic_that_died_alone_is_subscribed_again_while_its_action_drives(
    tmp_path: Path,
) -> None:
    feedback = f"/{R0}/{TO_POSE}/_action/feedback"
    async with nav2_site(tmp_path, speed=1.0) as site, linked(site.config) as (link, store):
        await store.until(nav2_ready)
        await asyncio.sleep(5.0)  # the rest has been subscribed to
        site.server.bridge.orphaned.add(feedback)
        site.server.bridge.received.clear()
        await finished(link, store, site.to("Consumidores"))
        await store.until(lambda state: state.robots[R0].progress)
        asked = [one["topic"] for one in site.server.bridge.received if one["op"] == "subscribe"]
    # The way of a robot that begins to drive is asked for more often.
    assert [topic for topic in asked if topic != f"/{R0}/plan"] == [feedback]


async def test_our_order_is_cancelled_by_its_id(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores"))
        assert order.order_id is not None
        cancel = await finished(link, store, CancelOrder(R0, order.order_id))
        assert (cancel.stage, cancel.detail) == (Stage.CONFIRMED, "no longer in the queue")
        ended = await reached(store, order.id, Stage.CANCELLED)
        assert ended.detail == f"order {order.order_id}: by this console"
        ((action, uuid),) = site.cancels()
    assert action == "/robot_0/navigate_to_pose" and uuid != "AAAAAAAAAAAAAAAAAAAAAA=="
    assert [goal.status for goal in site.navigation().servers[TO_POSE].goals.values()] == [CANCELED]


async def test_a_goal_of_another_client_is_shown_and_can_be_stopped(site: Site) -> None:
    site.navigation().give(*FAR)
    async with linked(site.config) as (link, store):
        state = await store.until(lambda state: nav2_ready(state) and state.robots[R0].orders.open)
        (order,) = foreign(state, state.robots[R0])
        assert order.state is OrderState.IN_PROCESS
        cancel = await finished(link, store, CancelOrder(R0, order.id))
        assert cancel.stage is Stage.CONFIRMED
        state = await store.until(lambda state: not state.robots[R0].orders.open)
        (gone,) = state.robots[R0].gone
        assert (gone.order.id, gone.stage) == (order.id, Stage.CANCELLED)


async def test_where_a_goal_of_another_client_leads_to_its_path_tells(site: Site) -> None:
    site.server.speed = 1.0
    site.navigation().give(*FAR)
    async with linked(site.config) as (_, store):
        target = (Stop(site.vertex("Consumidores")),)
        await store.until(lambda state: [one.stops for one in state.robots[R0].orders.open] == [target])


async def test_a_goal_that_was_there_before_is_never_taken_for_ours(site: Site) -> None:
    site.navigation().give(*FAR)
    async with linked(site.config) as (link, store):
        state = await store.until(lambda state: nav2_ready(state) and state.robots[R0].orders.open)
        (theirs,) = state.robots[R0].orders.open
        record_id = link.submit(site.to("Receiving"))
        # It would replace theirs: it waits here until somebody decides.
        record = await reached(store, record_id, Stage.WAITING, Stage.NOT_SENT)
        assert record.stage is Stage.NOT_SENT and "has no queue" in record.detail
        assert [one.id for one in foreign(store.state, store.state.robots[R0])] == [theirs.id]
    assert len(site.navigation().received) == 1


async def test_an_order_that_another_client_replaces_is_replaced_and_not_failed(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores"))
        site.navigation().give(*NEAR)
        ended = await reached(store, order.id, Stage.REPLACED, Stage.FAILED, Stage.LOST)
        assert ended.stage is Stage.REPLACED
        (theirs,) = foreign(store.state, store.state.robots[R0])
        assert theirs.id != order.order_id


async def test_an_order_that_is_aborted_failed_with_the_robots_words(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores"))
        site.navigation().abort(106, "Failed to find valid control")
        ended = await reached(store, order.id, Stage.FAILED)
        detail = "no valid control (error 106): Failed to find valid control"
        assert ended.detail == detail


async def test_an_order_of_which_a_stop_was_missed_is_not_done(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores", "Receiving"))
        await store.until(lambda _: site.navigation().robot.driving)
        site.navigation().abort(208, "no path")
        ended = await reached(store, order.id, Stage.FAILED, Stage.DONE)
        assert (ended.stage, ended.detail) == (Stage.FAILED, "no path to the goal (error 208); 1 stop missed")


async def test_an_order_that_is_rejected_is_refused_at_once(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        site.navigation().reject = 1
        record = await finished(link, store, site.to("Receiving"))
        assert (record.stage, record.detail) == (Stage.REFUSED, "Action goal was rejected")


async def test_without_an_action_server_an_order_is_refused(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        site.navigation().servers[TO_POSE].die()
        record = await finished(link, store, site.to("Receiving"))
        assert (record.stage, record.detail) == (Stage.REFUSED, "No action server available")


async def test_to_a_place_that_no_graph_has_nothing_leaves(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, PlaceOrder(R0, at_vertices("99")))
        assert record.stage is Stage.NOT_SENT and "99" in record.detail
    assert not site.navigation().received


async def test_a_pose_is_a_place_too(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        record = await finished(link, store, PlaceOrder(R0, (Stop(pose=Pose(2.0, 0.0, 0.5)),)))
        await reached(store, record.id, Stage.DONE)
    pose = site.navigation().robot.pose
    assert (round(pose.x, 2), round(pose.y, 2), round(pose.yaw, 2)) == (2.0, 0.0, 0.5)


async def test_an_order_outlives_a_restart_of_the_bridge(site: Site, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(apply, "RELISTED_WITHIN", (1.0, 60.0))
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores", "Receiving"))
        await site.server.restart_bridge()
        await store.until(phase(Phase.WAITING))
        await store.until(phase(Phase.UP))
        ended = await reached(store, order.id, Stage.DONE, Stage.FAILED, Stage.LOST)
        assert ended.stage is Stage.DONE
        again = await finished(link, store, site.to("Base"))
        assert again.stage is Stage.CONFIRMED


async def test_an_order_that_ends_while_the_link_is_lost_is_known_afterwards(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Receiving"))
        await site.server.stop()
        await store.until(phase(Phase.WAITING))
        site.fleet.step(60.0)
        async with site.started_again():
            ended = await reached(store, order.id, Stage.DONE, Stage.FAILED, Stage.LOST)
        assert ended.stage is Stage.DONE


async def test_clear_takes_back_ours_alone(site: Site) -> None:
    async with linked(site.config) as (link, store):
        await store.until(nav2_ready)
        site.navigation("robot_1").give(*FAR)
        order = await finished(link, store, site.to("Consumidores"))
        clear = await finished(link, store, ClearOrders(R0))
        assert clear.stage is Stage.CONFIRMED
        await reached(store, order.id, Stage.CANCELLED)
        clear = await finished(link, store, ClearOrders("robot_1"))
    (theirs,) = site.navigation("robot_1").servers[TO_POSE].goals.values()
    assert theirs.status == EXECUTING

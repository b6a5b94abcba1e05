"""Orders that wait in this console for a robot with Nav2: when they leave, what holds them, pauses."""

from pathlib import Path

import msgspec
import pytest

from fleet_tui.links import waiting_orders
from fleet_tui.links.queue_file import FILE, WaitingOrder
from fleet_tui.links.waiting_orders import WaitingOrders
from fleet_tui.model.commands import RESTARTED, CancelOrder, ClearOrders, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.events import BridgeAnswered, Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.navigation_events import OrderMoved
from fleet_tui.model.order import OrderState, at_vertices
from fleet_tui.orders.local_queue import ANOTHER_CLIENT, waiting, waiting_orders_of
from fleet_tui.simulator.nav2.navigation import SPIN, TO_POSE
from fleet_tui.simulator.ros.goals import CANCELED
from fleet_tui.state.store import Store
from tests.support.fleets import T0, commanded, fleet, link_up, of_kinds, place_order, pose, reduced, tick
from tests.support.kinds import KEEPING
from tests.support.links import finished, linked, phase
from tests.support.nav2_site import SPEED, Holds, Site, keeping, nav2_ready, nav2_site, reached, record_of
from tests.support.queue_files import kept
from tests.support.watched_store import WatchedStore

R0 = "robot_0"
FAR, NEAR = (35.0, 20.0), (8.0, 0.0)
FOREIGN_STOPPED = "stopped, also another client's goal {goal}, not resumable from here"


@pytest.fixture(autouse=True)
def soon() -> None:
    """A lost connection comes back at once."""


def held(reason: str) -> Holds:
    return lambda state: state.robots[R0].held == reason


async def test_a_second_order_waits_here_and_leaves_when_the_first_is_done(
    site: Site, tmp_path: Path
) -> None:
    async with linked(site.config, queue=keeping(tmp_path)) as (link, store):
        await store.until(nav2_ready)
        first = await finished(link, store, site.to("Receiving"))
        second, third = link.submit(site.to("Base")), link.submit(site.to("Receiving", "Base"))
        await reached(store, third, Stage.WAITING)
        state = await store.until(lambda state: len(waiting(state, state.robots[R0])) == 2)
        assert [one.id for one in waiting_orders_of(state, state.robots[R0])] == ["k1", "k2"]
        assert record_of(state, second).detail.startswith("in the queue of this console (ana@")
        await store.until(lambda _: len(kept(tmp_path)) == 2)
        state = await store.until(lambda state: record_of(state, second).stage is Stage.CONFIRMED)
        assert record_of(state, first.id).stage is Stage.DONE
        assert record_of(state, third).stage is Stage.WAITING
        ended = await reached(store, third, Stage.DONE, Stage.FAILED, Stage.LOST)
        assert ended.stage is Stage.DONE and record_of(store.state, second).stage is Stage.DONE
        assert not store.state.robots[R0].held
        await store.until(lambda _: not kept(tmp_path))


async def test_an_order_moved_to_the_front_is_the_next_one_sent_also_after_a_restart(
    site: Site, tmp_path: Path
) -> None:
    site.server.speed = 1.0
    async with linked(site.config, queue=keeping(tmp_path)) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Consumidores"))
        orders = [
            link.submit(site.to(*labels)) for labels in (["Base"], ["Receiving"], ["Receiving", "Base"])
        ]
        await reached(store, orders[-1], Stage.WAITING)
        link.post(OrderMoved(R0, "k3", "k1", store.state.now))
        moved = await store.until(lambda state: record_of(state, orders[-1]).turn)
        assert [one.id for one in waiting_orders_of(moved, moved.robots[R0])] == ["k3", "k1", "k2"]
        await store.until(lambda _: len(kept(tmp_path)[:1]) and len(kept(tmp_path)[0].stops) == 2)
    site.server.speed = SPEED
    async with linked(site.config, queue=keeping(tmp_path)) as (link, store):
        state = await store.until(lambda state: len(waiting(state, state.robots[R0])) == 3)
        stops = [len(order.stops) for order in waiting_orders_of(state, state.robots[R0])]
        assert stops == [2, 1, 1]
        link.post(OrderMoved(R0, "k3", "k1", state.now))
        await store.until(lambda state: nav2_ready(state) and not state.robots[R0].orders.open)
        await finished(link, store, ResumeRobot(R0))
        before = len(site.navigation().received)
        await store.until(lambda _: len(site.navigation().received) > before)
        assert site.navigation().received[before]["pose"]["pose"]["position"]["y"] == 7.0, "Receiving"


def test_an_order_that_is_moved_up_does_not_overtake_the_one_that_is_leaving() -> None:
    known: list[Event] = [link_up(T0), pose(T0), tick(T0)]
    waits = [fact for n in (1, 2) for fact in commanded(n, place_order(R0, n), Stage.WAITING, at=T0 + n / 10)]
    store = Store(reduced(of_kinds(fleet(), KEEPING), *known, *waits))
    left: list[int] = []
    orders = WaitingOrders(
        *(None, store, store.apply, lambda id_, _order, _at: left.append(id_), lambda _: None, lambda: 9)
    )
    orders.tick(T0 + 0.3)
    store.apply(OrderMoved(R0, "k2", "k1", T0 + 0.3))
    orders.tick(T0 + 0.4)
    assert left == [1]


async def test_only_so_many_orders_wait_for_a_robot(site: Site, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(waiting_orders, "MOST_WAITING", 1)
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Consumidores"))
        await reached(store, link.submit(site.to("Base")), Stage.WAITING)
        surplus = await finished(link, store, site.to("Base"))
        assert (surplus.stage, surplus.detail) == (
            Stage.NOT_SENT,
            "robot_0 already has 1 orders waiting here, the maximum",
        )


async def test_one_that_waits_here_is_cancelled_here(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        first = await finished(link, store, site.to("Consumidores"))
        second, third = link.submit(site.to("Base")), link.submit(site.to("Receiving"))
        await reached(store, third, Stage.WAITING)
        cancel = await finished(link, store, CancelOrder(R0, "k1"))
        assert (cancel.stage, cancel.detail) == (Stage.CONFIRMED, "was waiting here")
        assert record_of(store.state, second).stage is Stage.CANCELLED
        assert not site.cancels()
        clear = await finished(link, store, ClearOrders(R0))
        assert clear.stage is Stage.CONFIRMED
        await reached(store, first.id, Stage.CANCELLED)
        assert record_of(store.state, third).stage is Stage.CANCELLED
        assert len(site.cancels()) == 1


async def test_after_a_failure_nothing_leaves_until_the_operator_resumes(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        first = await finished(link, store, site.to("Consumidores"))
        second = link.submit(site.to("Receiving"))
        await reached(store, second, Stage.WAITING)
        site.navigation().abort(208, "no path")
        await store.until(held(f"order {first.order_id}: failed"))
        alarm = await store.until(lambda state: [one for one in state.alarms if one.key[1] == "held"])
        assert len(site.navigation().received) == 1
        resume = await finished(link, store, ResumeRobot(R0))
        assert (resume.stage, resume.detail) == (Stage.CONFIRMED, "waiting orders continue")
        await reached(store, second, Stage.DONE)
    (text,) = [one.condition.text for one in alarm.alarms if one.key[1] == "held"]
    assert text == f"order {first.order_id}: failed: 1 order waiting here, resume to continue"


async def test_a_failure_of_long_ago_holds_nothing(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        first = await finished(link, store, site.to("Consumidores"))
        site.navigation().abort()
        await reached(store, first.id, Stage.FAILED)
        await finished(link, store, site.to("Receiving"))
        third = link.submit(site.to("Base"))
        ended = await reached(store, third, Stage.DONE)
        assert not store.state.robots[R0].held
        assert [step.stage for step in ended.steps][1] is Stage.WAITING


async def test_who_starts_anew_holds_what_was_kept(site: Site, tmp_path: Path) -> None:
    async with linked(site.config, queue=keeping(tmp_path)) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Receiving"))
        await reached(store, link.submit(site.to("Base")), Stage.WAITING)
        await store.until(lambda _: len(kept(tmp_path)) == 1)
    async with linked(site.config, queue=keeping(tmp_path)) as (link, store):
        state = await store.until(held(RESTARTED))
        (waits,) = waiting(state, state.robots[R0])
        assert waits.command == site.to("Base") and waits.detail == RESTARTED
        await store.until(
            lambda state: nav2_ready(state) and state.robots[R0].goals and not state.robots[R0].orders.open
        )
        assert len(site.navigation().received) == 1 and len(kept(tmp_path)) == 1
        await finished(link, store, ResumeRobot(R0))
        await reached(store, waits.id, Stage.DONE)


async def test_what_another_configuration_kept_stays_in_the_file(site: Site, tmp_path: Path) -> None:
    theirs = WaitingOrder("ws://other-site:9090", R0, at_vertices("1"), 1.0)
    (tmp_path / FILE).write_bytes(msgspec.json.encode([theirs]))
    async with linked(site.config, queue=keeping(tmp_path)) as (link, store):
        await store.until(nav2_ready)
        assert not waiting(store.state, store.state.robots[R0])
        await finished(link, store, site.to("Consumidores"))
        await reached(store, link.submit(site.to("Base")), Stage.WAITING)
        await store.until(lambda _: len(kept(tmp_path)) == 2)
    assert kept(tmp_path)[0] == theirs


async def test_while_someone_else_drives_the_queue_is_held(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        site.navigation().give(*NEAR)
        await store.until(lambda state: state.robots[R0].orders.open)
        second = link.submit(site.to("Receiving"))
        await reached(store, second, Stage.WAITING)
        state = await store.until(held(ANOTHER_CLIENT))
        await store.until(lambda state: [one for one in state.alarms if one.key[1] == "held"])
        await store.until(lambda state: not state.robots[R0].orders.open)
        assert record_of(store.state, second).stage is Stage.WAITING and state.robots[R0].held
        await finished(link, store, ResumeRobot(R0))
        await reached(store, second, Stage.DONE)


async def test_when_the_link_was_lost_the_queue_is_held(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        first = await finished(link, store, site.to("Consumidores"))
        second = link.submit(site.to("Receiving"))
        await reached(store, second, Stage.WAITING)
        await site.server.drop_clients()
        await store.until(held("the link was lost"))
        await store.until(phase(Phase.UP))
        await reached(store, first.id, Stage.DONE)
        assert record_of(store.state, second).stage is Stage.WAITING


async def test_when_the_robot_was_offline_the_queue_is_held(site: Site) -> None:
    config = msgspec.structs.replace(
        site.config, alarms=msgspec.structs.replace(site.config.alarms, offline_after=0.5)
    )
    async with linked(config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Consumidores"))
        second = link.submit(site.to("Receiving"))
        await reached(store, second, Stage.WAITING)
        site.navigation().robot.silence = float("inf")
        await store.until(held("robot_0 was offline"))


async def test_a_second_console_of_the_same_folder_keeps_nothing(site: Site, tmp_path: Path) -> None:
    ana, bea = keeping(tmp_path, "ana"), keeping(tmp_path, "bea")
    site.server.speed = 1.0
    async with linked(site.config, queue=ana) as (link, store):
        await store.until(nav2_ready)
        first = await finished(link, store, site.to("Consumidores"))
        await reached(store, link.submit(site.to("Receiving")), Stage.WAITING)
        async with linked(site.config, queue=bea) as (other, their_store):
            await their_store.until(lambda state: nav2_ready(state) and state.robots[R0].orders.open)
            assert not waiting(their_store.state, their_store.state.robots[R0])
            record = await finished(other, their_store, site.to("Base"))
            assert record.stage is Stage.NOT_SENT
            assert record.detail.startswith("robot_0 has an order, and ana@")
            assert record.detail.endswith(" keeps the queue")
            (goal,) = their_store.state.robots[R0].orders.open
            assert goal.id == first.order_id
        await store.until(lambda _: len(kept(tmp_path)) == 1)


async def test_a_pause_stops_the_robot_and_keeps_its_goal_here(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Consumidores", "Receiving"))
        await store.until(lambda _: site.navigation().robot.driving)
        pause = await finished(link, store, PauseRobot(R0))
        assert (pause.stage, pause.detail) == (Stage.CONFIRMED, "stopped, goal kept here")
        waits = await reached(store, order.id, Stage.WAITING)
        assert waits.order_id == "k1" and not site.navigation().robot.driving
        assert [action for action, _ in site.cancels()][:2] == [
            "/robot_0/follow_waypoints",
            "/robot_0/navigate_to_pose",
        ]
        resume = await finished(link, store, ResumeRobot(R0))
        assert resume.stage is Stage.CONFIRMED
        ended = await reached(store, order.id, Stage.DONE, Stage.FAILED, Stage.LOST)
        assert ended.stage is Stage.DONE
    pose = site.navigation().robot.pose
    assert (round(pose.x), round(pose.y)) == (0, 7)


async def test_what_was_paused_comes_before_what_waits(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        first = await finished(link, store, site.to("Receiving"))
        second = link.submit(site.to("Base"))
        await reached(store, second, Stage.WAITING)
        pause = await finished(link, store, PauseRobot(R0))
        assert pause.detail == "stopped, goal kept here"
        state = await store.until(lambda state: len(waiting(state, state.robots[R0])) == 2)
        assert [one.id for one in waiting(state, state.robots[R0])] == [first.id, second]
        await finished(link, store, ResumeRobot(R0))
        await reached(store, first.id, Stage.DONE)
        await reached(store, second, Stage.DONE)


async def test_a_goal_of_another_client_is_stopped_by_a_pause_and_cannot_be_resumed(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        site.navigation().give(*FAR)
        await store.until(lambda state: nav2_ready(state) and state.robots[R0].orders.open)
        (goal,) = site.navigation().servers[TO_POSE].goals.values()
        pause = await finished(link, store, PauseRobot(R0))
        told = FOREIGN_STOPPED.format(goal=goal.id.hex()[:8])
        assert (pause.stage, pause.detail) == (Stage.CONFIRMED, told)
    assert goal.status == CANCELED


LONG_SPIN = {"target_yaw": 500.0, "time_allowance": {"sec": 600, "nanosec": 0}}


async def actions_listed(store: WatchedStore, site: Site) -> None:
    """Wait until rosapi has listed the action servers: it answers in turn, one question may be on its way."""
    asked = "/rosapi/action_servers"
    await store.until(lambda _: any(one.get("service") == asked for one in site.server.bridge.received))
    answers = len(store.told(BridgeAnswered))
    await store.until(lambda _: len(store.told(BridgeAnswered)) > answers + 1)


async def test_a_motion_that_another_client_asked_of_nav2_itself_is_stopped_and_named(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        spin = site.navigation().take(SPIN, LONG_SPIN)
        assert spin is not None
        await actions_listed(store, site)
        pause = await finished(link, store, PauseRobot(R0))
        assert (pause.stage, pause.detail) == (
            Stage.CONFIRMED,
            "stopped, also another client's spin, not resumable from here",
        )
        resumed = await finished(link, store, ResumeRobot(R0))
        assert (resumed.stage, resumed.detail) == (Stage.CONFIRMED, "no orders waiting here")
        listed = {one.rpartition("/")[2] for one in site.server.bridge.services.actions.names}
        asked = {action.rpartition("/")[2] for action, _ in site.cancels()}
        assert asked == {"navigate_to_pose", "follow_waypoints", "spin", "dock_robot"} <= listed
    assert spin.status == CANCELED


async def test_a_pause_that_a_spin_defies_is_not_confirmed_until_it_is_ended(tmp_path: Path) -> None:
    async with nav2_site(tmp_path, speed=1.0) as site, linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        site.navigation().servers[SPIN].refuses_cancel = True
        site.navigation().take(SPIN, LONG_SPIN)
        await actions_listed(store, site)
        pause = await finished(link, store, PauseRobot(R0))
        assert (pause.stage, pause.detail) == (
            Stage.NOT_CONFIRMED,
            "accepted; the robot was not seen to stop",
        )
        (alarm,) = [one for one in store.state.alarms if one.holds]
        assert alarm.text == "still moving"
        site.navigation().servers[SPIN].refuses_cancel = False
        assert (await finished(link, store, PauseRobot(R0))).stage is Stage.CONFIRMED
        await store.until(lambda state: not any(one.holds for one in state.alarms))


async def test_a_recovery_within_an_order_is_no_motion_of_another_client(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        order = link.submit(site.to("Receiving"))
        await reached(store, order, Stage.CONFIRMED)
        site.navigation().take(SPIN, LONG_SPIN)
        pause = await finished(link, store, PauseRobot(R0))
        assert (pause.stage, pause.detail) == (Stage.CONFIRMED, "stopped, goal kept here")


async def test_a_robot_without_a_goal_can_be_paused_and_then_drives_no_order(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        pause = await finished(link, store, PauseRobot(R0))
        assert pause.stage is Stage.CONFIRMED
        order = await reached(store, link.submit(site.to("Receiving")), Stage.WAITING, Stage.CONFIRMED)
        assert order.stage is Stage.WAITING and not site.navigation().received
        await finished(link, store, ResumeRobot(R0))
        await reached(store, order.id, Stage.DONE)


async def test_orders_of_two_robots_do_not_wait_for_each_other(site: Site) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        await finished(link, store, site.to("Consumidores"))
        record = await finished(link, store, site.to("Receiving", robot="robot_1"))
        assert record.stage is Stage.CONFIRMED


async def test_an_ended_goal_leaves_the_queue(site: Site, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("fleet_tui.orders.goals.LISTED_FOR", 0.5)
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(nav2_ready)
        order = await finished(link, store, site.to("Receiving"))

        def is_listed_as_done(state: FleetState) -> bool:
            return [one.state for one in state.robots[R0].orders.orders] == [OrderState.DONE]

        await reached(store, order.id, Stage.DONE)
        await store.until(lambda state: is_listed_as_done(state) or not state.robots[R0].orders.orders)
        await store.until(lambda state: not state.robots[R0].orders.orders)

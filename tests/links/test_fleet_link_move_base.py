"""Orders of robots with move_base, over a real loopback bridge: given, confirmed, driven, cancelled."""

import asyncio
import json
from collections.abc import AsyncIterator
from pathlib import Path

import msgspec
import pytest
from websockets.asyncio.client import connect

from fleet_tui.cli.status.report import attention
from fleet_tui.config.schema import Operator
from fleet_tui.links.queue_file import FILE, WaitingOrder
from fleet_tui.links.rosbridge import publishing
from fleet_tui.links.rosbridge.services import Services
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.model.commands import CancelOrder, ClearOrders, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import at_vertices
from fleet_tui.model.robot import Robot
from fleet_tui.orders.local_queue import ANOTHER_CLIENT, foreign, waiting
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.move_base.faults import CONNECTS
from tests.support.links import finished, linked
from tests.support.move_base_site import MoveBaseSite, move_base_site
from tests.support.nav2_site import keeping, nav2_ready, reached

R0 = "robot_0"
FAR = (35.0, 20.0)
NEVER = {"secs": 0, "nsecs": 0}


@pytest.fixture(autouse=True)
def soon() -> None:
    """A lost connection comes back at once."""


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[MoveBaseSite]:
    async with move_base_site(tmp_path) as running:
        yield running


def robot(state: FleetState) -> Robot:
    return state.robots[R0]


def known(state: FleetState) -> bool:
    """Poses, graphs and goals have come, and commands get through."""
    return nav2_ready(state) and all(one.goals for one in state.robots.values())


async def test_an_order_is_a_goal_of_ours_confirmed_by_its_id_and_driven(site: MoveBaseSite) -> None:
    async with linked(site.config) as (link, store):
        await store.until(known)
        record = await finished(link, store, site.to("Base"))
        assert record.stage is Stage.CONFIRMED
        assert [step.stage for step in record.steps] == [
            *(Stage.CHECKED, Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED)
        ]
        ended = await reached(store, record.id, Stage.DONE)
    goal = site.navigation().received[0]
    assert all({**again, "header": goal["header"]} == goal for again in site.navigation().received)
    assert goal["goal_id"]["id"] == record.name and record.name.startswith("fleet-tui-")
    assert record.order_id == record.name[10:18]
    assert goal["goal_id"]["stamp"] == NEVER
    assert ended.detail == f"order {record.order_id}: Goal reached."
    pose = site.navigation().robot.pose
    assert abs(pose.x) < 0.1 and abs(pose.y) < 0.1


async def test_a_to_b_is_two_goals_of_one_order(site: MoveBaseSite, tmp_path: Path) -> None:
    async with linked(site.config, queue=keeping(tmp_path)) as (link, store):
        await store.until(known)
        order = site.to("Consumidores", "Base")
        record = await finished(link, store, order)
        assert robot(store.state).orders.open[0].stops == order.stops
        await store.until(lambda _: (tmp_path / FILE).exists())
        (kept,) = msgspec.json.decode((tmp_path / FILE).read_bytes(), type=list[WaitingOrder])
        assert kept.stops == order.stops[1:]
        ended = await reached(store, record.id, Stage.DONE, Stage.FAILED, Stage.LOST)
    assert ended.stage is Stage.DONE
    assert len({goal["goal_id"]["id"] for goal in site.navigation().received}) == 2
    pose = site.navigation().robot.pose
    assert abs(pose.x) < 0.1 and abs(pose.y) < 0.1


async def test_orders_wait_here_and_a_pause_keeps_what_is_driven(site: MoveBaseSite) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(known)
        first = await finished(link, store, site.to("Consumidores", "Base"))
        second = link.submit(site.to("Receiving"))
        await reached(store, second, Stage.WAITING)
        paused = await finished(link, store, PauseRobot(R0))
        assert (paused.stage, paused.detail) == (Stage.CONFIRMED, "stopped, goal kept here")
        state = await store.until(lambda state: len(waiting(state, robot(state))) == 2)
        assert waiting(state, robot(state))[0].id == first.id
        resumed = await finished(link, store, ResumeRobot(R0))
        assert resumed.stage is Stage.CONFIRMED
        assert (await reached(store, second, Stage.DONE)).stage is Stage.DONE
        assert (await reached(store, first.id, Stage.DONE)).stage is Stage.DONE
    assert all(one["id"] and one["stamp"] == NEVER for one in site.published("/cancel"))


async def test_goals_of_others_are_shown_with_their_target_and_cancelled_by_id(site: MoveBaseSite) -> None:
    async with linked(site.config) as (link, store):
        await store.until(known)
        site.navigation().give(*FAR)
        state = await store.until(
            lambda state: robot(state).orders.open and robot(state).orders.open[0].stops
        )
        (order,) = foreign(state, robot(state))
        assert order.stops[0].vertex or order.stops[0].pose
        cleared = await finished(link, store, ClearOrders(R0))
        assert cleared.stage is Stage.CONFIRMED and not site.published("/cancel")
        cancelled = await finished(link, store, CancelOrder(R0, order.id))
        assert cancelled.stage is Stage.CONFIRMED
    (cancel,) = site.published("/cancel")
    assert cancel["id"].startswith("/robot_0/move_base-1-") and cancel["stamp"] == NEVER


async def test_a_foreign_goal_replaces_ours_and_holds_what_waits(site: MoveBaseSite) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(known)
        first = await finished(link, store, site.to("Consumidores"))
        link.submit(site.to("Base"))
        await store.until(lambda state: waiting(state, robot(state)))
        site.navigation().give(*FAR)
        ended = await reached(store, first.id, Stage.REPLACED, Stage.CANCELLED_ELSEWHERE, Stage.FAILED)
        assert ended.stage is Stage.REPLACED
        await store.until(lambda state: robot(state).held == ANOTHER_CLIENT)


async def test_a_node_that_was_started_anew_has_lost_its_goals(site: MoveBaseSite) -> None:
    async with linked(site.config) as (link, store):
        await store.until(known)
        first = await finished(link, store, site.to("Consumidores"))
        site.navigation().restart()
        assert (await reached(store, first.id, Stage.LOST, Stage.DONE)).stage is Stage.LOST


async def test_its_status_is_a_heartbeat_of_a_robot_without_wheels(site: MoveBaseSite) -> None:
    for name in site.fleet.robots:
        site.fleet.robots[name].odometry = False
    profile = msgspec.structs.replace(site.config.profile, topics={"odometry": "", "battery": ""})
    async with linked(msgspec.structs.replace(site.config, profile=profile)) as (_, store):
        state = await store.until(lambda state: robot(state).last_received is not None)
        before = robot(state).last_received
        assert before is not None
        await store.until(lambda state: (robot(state).last_received or 0.0) > before + 1.0)
        assert store.state.is_online(robot(store.state))


async def test_topics_of_commands_are_advertised_before_they_are_needed(site: MoveBaseSite) -> None:
    async with linked(site.config) as (_, store):
        await store.until(known)
        assert site.advertised() == [
            f"/{name}/move_base/{part}" for name in site.fleet.robots for part in ("goal", "cancel")
        ]


async def test_a_console_that_may_send_nothing_advertises_nothing(site: MoveBaseSite) -> None:
    """One that is not armed may pause."""
    changed = msgspec.structs.replace
    for config, advertises in (
        (changed(site.config, operator=Operator(read_only=True)), False),
        (changed(site.config, watches=True), False),
        (changed(site.config, operator=Operator(armed=False)), True),
    ):
        async with linked(config) as (_, store):
            await store.until(known)
            assert bool(site.advertised()) == advertises


async def test_a_first_message_that_is_lost_is_repeated(
    site: MoveBaseSite, monkeypatch: pytest.MonkeyPatch
) -> None:
    # By number, not by time: on a busy machine the first may come after its subscribers.
    guests = site.server.bridge.services.guests
    monkeypatch.setattr(guests, "connected", lambda _session, _name: len(site.published("/goal")) > 1)
    not_armed = msgspec.structs.replace(site.config, operator=Operator(armed=False))
    async with linked(not_armed) as (link, store):
        await store.until(known)
        assert (await finished(link, store, site.to("Base"))).stage is Stage.CONFIRMED
    sent = site.published("/goal")
    assert len(sent) == 2 and sent[0] == sent[1] and len(site.navigation().received) == 1
    assert CONNECTS < publishing.KNOWN_AFTER, "by time it is lost for less than that"


async def test_a_goal_that_waits_for_a_new_connection_is_overtaken_by_a_pause(
    site: MoveBaseSite, monkeypatch: pytest.MonkeyPatch
) -> None:
    told = asyncio.Event()

    async def settle(_: Services) -> None:
        await told.wait()

    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(known)
        monkeypatch.setattr(Services, "is_new", True)
        monkeypatch.setattr(Services, "settle", settle)
        order = link.submit(site.to("Consumidores"))
        await reached(store, link.submit(PauseRobot(R0)), Stage.ACCEPTED, Stage.CONFIRMED)
        network_loop().call_soon_threadsafe(told.set)
        ended = await reached(store, order, Stage.NOT_SENT, Stage.CONFIRMED)
    assert (ended.stage, ended.detail) == (Stage.NOT_SENT, "robot paused before it was sent")
    assert not site.published("/goal")


async def test_a_goal_that_nobody_hears_is_not_confirmed(site: MoveBaseSite) -> None:
    play(site.server, [("never", R0)])
    async with linked(site.config) as (link, store):
        await store.until(known)
        record = await finished(link, store, site.to("Base"))
        assert (record.stage, record.detail) == (Stage.NOT_CONFIRMED, "no answer; no new goal seen")


async def test_what_a_robot_gives_up_is_said_in_its_words(site: MoveBaseSite) -> None:
    play(site.server, [("no-plan", R0)])
    async with linked(site.config) as (link, store):
        await store.until(known)
        record = await finished(link, store, site.to("Base"))
        ended = await reached(store, record.id, Stage.FAILED)
        assert ended.detail.endswith("Failed to find a valid plan. Even after executing recovery behaviors.")


async def test_a_vertex_that_no_graph_has_is_not_sent(site: MoveBaseSite) -> None:
    async with linked(site.config) as (link, store):
        await store.until(known)
        order = msgspec.structs.replace(site.to("Base"), stops=at_vertices("999"))
        record = await finished(link, store, order)
        assert record.stage is Stage.NOT_SENT and "999" in record.detail


async def test_a_goal_that_is_listed_only_after_a_pause_is_stopped_too(site: MoveBaseSite) -> None:
    async with linked(site.config, queue=keeping()) as (link, store):
        await store.until(known)
        site.navigation().give(*FAR)
        pause = link.submit(PauseRobot(R0))
        ended = await reached(store, pause, Stage.CONFIRMED, Stage.NOT_CONFIRMED)
    assert ended.stage is Stage.CONFIRMED and not site.navigation().busy
    assert [one["id"][:20] for one in site.published("/cancel")] == ["/robot_0/move_base-1"]


async def test_a_pose_topic_that_died_alone_is_subscribed_again_once_the_robot_moves(
    site: MoveBaseSite,
) -> None:
    """As after a restart of roscore, when another client held it: the wheels of its robot are back."""
    pose = f"/{R0}/amcl_pose"
    async with linked(site.config) as (link, store):
        await store.until(known)
        await asyncio.sleep(5.0)  # the rest has been subscribed to
        site.server.bridge.orphaned.add(pose)
        site.server.bridge.received.clear()
        await finished(link, store, site.to("Consumidores"))
        await store.until(lambda state: robot(state).adrift_at is not None)
        await store.until(lambda state: robot(state).adrift_at is None)
        asked = [one["topic"] for one in site.server.bridge.received if one["op"] == "subscribe"]
    assert asked == [pose]


async def test_a_feedback_topic_that_died_alone_is_subscribed_again_while_a_goal_is_driven(
    tmp_path: Path,
) -> None:
    feedback = f"/{R0}/move_base/feedback"
    async with move_base_site(tmp_path, speed=1.0) as site, linked(site.config) as (_, store):
        await store.until(known)
        await asyncio.sleep(20.0)  # it owes no message while nothing is driven
        site.server.bridge.orphaned.add(feedback)
        site.server.bridge.received.clear()
        site.navigation().give(*FAR)
        await store.until(lambda _: not site.server.bridge.orphaned)
        await store.until(lambda _: site.server.bridge.subscribers(feedback) == 1)
        asked = [one["topic"] for one in site.server.bridge.received if one["op"] == "subscribe"]
        assert robot(store.state).orders.open
    assert [topic for topic in asked if not topic.endswith("plan")] == [feedback]


async def test_a_pose_topic_that_another_client_holds_dead_blames_the_bridge(site: MoveBaseSite) -> None:
    pose = f"/{R0}/amcl_pose"
    async with linked(site.config) as (link, store), connect(site.server.url) as other:
        await store.until(known)
        await other.send(json.dumps({"op": "subscribe", "topic": pose}))
        await store.until(lambda _: site.server.bridge.subscribers(pose) == 2)
        site.server.bridge.orphaned.add(pose)
        await finished(link, store, site.to("Consumidores"))
        lost = "rosbridge: rosbridge lost its subscriptions of robot_0: restart it"
        await store.until(lambda state: lost in attention(state))

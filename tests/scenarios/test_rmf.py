"""Fleets of Open-RMF from this console: orders to a robot and to any, over a real loopback bridge."""

import json
from collections.abc import AsyncIterator
from pathlib import Path

import msgspec
import pytest

from fleet_tui.config.start import initial_state
from fleet_tui.model.commands import CancelOrder, ClearOrders, Command, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import OrderState, at_vertices
from fleet_tui.orders.local_queue import all_orders
from fleet_tui.robots.profile import Profile
from fleet_tui.simulator.rmf.faults import restart_dispatcher
from tests.support.links import finished, linked
from tests.support.rmf_site import FIRST, SECOND, Hospital, hospital, rmf_ready, stands_at, to


@pytest.fixture
async def site() -> AsyncIterator[Hospital]:
    async with hospital() as running:
        yield running


def quick(site: Hospital) -> Hospital:
    """The same hospital, whose console waits only briefly for answers and telemetry."""
    alarms = msgspec.structs.replace(site.config.alarms, no_answer_after=0.3, not_confirmed_after=0.5)
    site.config = msgspec.structs.replace(site.config, alarms=alarms)
    return site


async def test_an_order_to_a_robot_is_answered_confirmed_and_driven_to_its_end(site: Hospital) -> None:
    async with linked(site.config) as (link, store):
        await store.until(rmf_ready)
        record = await finished(link, store, to("Store", "Base"))
        assert [step.stage for step in record.steps][1:4] == [Stage.SENT, Stage.ACCEPTED, Stage.CONFIRMED]
        assert record.detail == f"seen in the queue as order {record.order_id}"
        (order,) = store.state.robots[FIRST].orders.open
        assert (order.stops, order.label) == (at_vertices("Store", "Base"), "")
        ended = await stands_at(store, record.id, Stage.DONE)
    assert ended.detail == f"order {record.order_id}: as reported by the robot"
    (asked,) = site.sent()
    assert (asked["type"], asked["fleet"], asked["robot"]) == ("robot_task_request", "tiny", "robot_0")


async def test_an_order_to_any_becomes_that_of_the_robot_that_has_it(site: Hospital) -> None:
    site.fleet.robots[FIRST].silence = 1e9
    async with linked(site.config) as (link, store):
        await store.until(rmf_ready)
        record = await finished(link, store, to("Store", to_any=True))
        assert (record.stage, record.command.robot) == (Stage.CONFIRMED, SECOND)
        assert [one.id for one in store.state.robots[SECOND].orders.open] == [record.order_id]
        await stands_at(store, record.id, Stage.DONE)
    assert [one["type"] for one in site.sent()] == ["dispatch_task_request"]


async def test_an_order_is_cancelled_while_fleets_still_bid() -> None:
    async with hospital(speed=1.0) as site, linked(site.config) as (link, store):
        await store.until(rmf_ready)
        given = link.submit(to("Store", to_any=True))
        await stands_at(store, given, Stage.ACCEPTED)
        (order,) = all_orders(store.state, store.state.robots[FIRST])
        assert (order.state_text, order.stops) == ("fleets bid", at_vertices("Store"))
        record = await finished(link, store, CancelOrder(FIRST, order.id))
        assert record.stage is Stage.CONFIRMED
        await stands_at(store, given, Stage.CANCELLED)
        assert not any(robot.tasks for robot in site.fleet.robots.values())


async def test_a_cancellation_that_no_dispatcher_takes_is_not_confirmed_while_fleets_bid() -> None:
    async with hospital(speed=1.0) as site, linked(quick(site).config) as (link, store):
        await store.until(rmf_ready)
        given = link.submit(to("Store", to_any=True))
        await stands_at(store, given, Stage.ACCEPTED)
        site.fleet.dispatcher.deaf = True
        (order,) = all_orders(store.state, store.state.robots[FIRST])
        record = await finished(link, store, CancelOrder(FIRST, order.id))
    assert record.stage is Stage.NOT_CONFIRMED


async def test_an_order_that_no_fleet_takes_is_refused_with_the_dispatchers_reason(site: Hospital) -> None:
    for member in site.fleet.robots.values():
        member.places.pop("Store")
    async with linked(site.config) as (link, store):
        await store.until(rmf_ready)
        to_any = await finished(link, store, to("Store", to_any=True))
        to_one = await finished(link, store, to("Store"))
    assert to_any.stage is Stage.REFUSED
    assert to_any.detail == "no fleet took the task: Not Feasible: no bid was received"
    assert (to_one.stage, to_one.detail) == (Stage.REFUSED, "Invalid request: no place named Store")


async def test_a_cancel_counts_only_when_the_task_says_so(site: Hospital) -> None:
    async with linked(site.config) as (link, store):
        await store.until(rmf_ready)
        order = await finished(link, store, to("Store", "Base"))
        assert order.order_id is not None
        cancel = await finished(link, store, CancelOrder(FIRST, order.order_id))
        assert (cancel.stage, cancel.detail) == (Stage.CONFIRMED, "no longer in the queue")
        ended = await stands_at(store, order.id, Stage.CANCELLED)
    assert ended.detail == f"order {order.order_id}: by this console"


async def test_a_clear_leaves_the_tasks_of_others(site: Hospital) -> None:
    theirs = {"places": ["Base", "Store"], "rounds": 1}
    asked = {"type": "robot_task_request", "robot": "robot_0", "fleet": "tiny"}
    site.fleet.dispatcher.take(json.dumps({**asked, "request": {"description": theirs}}), "web")
    async with linked(site.config) as (link, store):
        await store.until(rmf_ready)
        await finished(link, store, to("Store"))
        await finished(link, store, to("Base"))
        assert len(store.state.robots[FIRST].orders.open) == 3
        cleared = await finished(link, store, ClearOrders(FIRST))
        assert cleared.stage is Stage.CONFIRMED
        (left,) = store.state.robots[FIRST].orders.open
    assert left.label == "patrol: Store"


async def test_another_console_finds_the_token_of_an_interruption(site: Hospital) -> None:
    async with linked(site.config) as (link, store):
        await store.until(rmf_ready)
        order = await finished(link, store, to("Store", "Base"))
        await store.until(lambda state: state.robots[FIRST].orders.current)
        paused = await finished(link, store, PauseRobot(FIRST))
        assert (paused.stage, paused.detail) == (Stage.CONFIRMED, "by the robot")
        assert store.state.robots[FIRST].orders.open[0].state is OrderState.PAUSED
    async with linked(site.config) as (link, store):
        await store.until(lambda state: rmf_ready(state) and state.is_paused(state.robots[FIRST]))
        resumed = await finished(link, store, ResumeRobot(FIRST))
        assert (resumed.stage, resumed.detail) == (Stage.CONFIRMED, "by the robot")
        await store.until(lambda state: not state.robots[FIRST].orders.open)
    resume = site.sent()[-1]
    assert (resume["for_task"], resume["for_tokens"]) == (order.order_id, ["0"])


@pytest.mark.parametrize(
    ("command", "reason"),
    [
        (PauseRobot(FIRST), "tiny/robot_0 has no task under way: an idle robot can't be paused"),
        (ResumeRobot(FIRST), "tiny/robot_0 has no interrupted task"),
    ],
)
async def test_a_robot_without_a_task_is_neither_paused_nor_resumed(
    site: Hospital, command: Command, reason: str
) -> None:
    async with linked(site.config) as (link, store):
        await store.until(rmf_ready)
        record = await finished(link, store, command)
    assert (record.stage, record.detail) == (Stage.NOT_SENT, reason)
    assert not site.sent()


async def test_silence_is_no_answer_and_the_task_decides(site: Hospital) -> None:
    site.fleet.dispatcher.mute = True
    async with linked(quick(site).config) as (link, store):
        await store.until(rmf_ready)
        record = await finished(link, store, to("Store", "Base"))
    assert [step.stage for step in record.steps][1:] == [Stage.SENT, Stage.NO_ANSWER, Stage.CONFIRMED]


async def test_what_nobody_takes_is_not_confirmed(site: Hospital) -> None:
    site.fleet.dispatcher.deaf = True
    async with linked(quick(site).config) as (link, store):
        await store.until(rmf_ready)
        record = await finished(link, store, to("Store"))
    assert record.stage is Stage.NOT_CONFIRMED
    assert record.detail.startswith("no answer: no reply within 0.3 s")


async def test_a_request_is_sent_once_and_never_latched(site: Hospital) -> None:
    async with linked(site.config) as (link, store):
        await store.until(rmf_ready)
        await finished(link, store, to("Store", "Base"))
        restart_dispatcher(site.server, FIRST)
        await finished(link, store, CancelOrder(FIRST, store.state.robots[FIRST].orders.open[0].id))
    frames = site.frames("advertise") + site.frames("publish")
    assert frames and not any(frame.get("latch") or frame.get("qos") for frame in frames)
    assert len(site.frames("publish")) == len(site.sent()) == 2


async def test_a_restarted_dispatcher_would_run_a_latched_request_again(site: Hospital) -> None:
    """The simulator shows the fault that the test above guards against."""
    async with linked(site.config) as (_, store):
        await store.until(rmf_ready)
        topic = site.server.bridge.topics["/task_api_requests"]
        message = {"json_msg": json.dumps({"type": "cancel_task_request", "task_id": "x"}), "request_id": "q"}
        payload = type("Latched", (), {"msg": message})()
        latched = type(topic)(topic.name, topic.type, topic.payload, latched=True, history=lambda: [payload])
        site.server.bridge.topics["/task_api_requests"] = latched
        restart_dispatcher(site.server, FIRST)
    assert [one["type"] for one in site.sent()] == ["cancel_task_request"]


async def test_shared_topics_are_subscribed_once_for_all_robots() -> None:
    async with hospital(robots=9) as site, linked(site.config) as (_, store):
        await store.until(rmf_ready)
        asked = [one for one in site.server.bridge.received if one["op"] == "subscribe"]
    shared = [one for one in asked if one["topic"] in ("/fleet_states", "/task_state_update")]
    assert len(shared) == 2
    assert all((one["throttle_rate"], one["queue_length"]) == (0, 100) for one in shared)


async def test_a_lost_robot_is_offline_while_its_adapter_and_the_others_go_on(site: Hospital) -> None:
    alarms = msgspec.structs.replace(site.config.alarms, offline_after=0.5)
    site.config = msgspec.structs.replace(site.config, alarms=alarms)
    async with linked(site.config) as (_, store):
        await store.until(rmf_ready)
        site.fleet.robots[FIRST].silence = 1e9
        state = await store.until(lambda state: not state.is_online(state.robots[FIRST]))
        assert state.is_online(state.robots[SECOND])


async def test_a_console_without_the_packages_lives_on_texts_alone(site: Hospital) -> None:
    site.server.bridge.services.unsourced |= {"rmf_fleet_msgs", "rmf_task_msgs", "rmf_building_map_msgs"}
    profile = Profile(kind="rmf", topics={"graphs": ""})
    async with linked(msgspec.structs.replace(site.config, profile=profile)) as (_, store):
        state = await store.until(lambda state: all(one.pose for one in state.robots.values()))
        assert state.is_online(state.robots[FIRST]) and state.robots[FIRST].clock is None


async def test_the_pictures_of_all_levels_come_with_the_map_of_one() -> None:
    async with hospital(floors=3) as site, linked(site.config) as (link, store):
        await store.until(rmf_ready)
        link.show_map(FIRST, "floor_0")
        state = await store.until(lambda state: all(one.live for one in state.floors.values()))
    frame = next(iter(state.floors.values())).live.frame  # type: ignore[union-attr]  # all have one
    assert (round(frame.origin.x, 3), round(frame.origin.y, 3), frame.width) == (-2.0, -3.0, 800)


async def test_a_robot_goes_through_all_floors_by_lift() -> None:
    async with hospital(robots=1, floors=3) as site, linked(site.config) as (link, store):
        state = await store.until(rmf_ready)
        floors = set(state.robots[FIRST].maps)
        record = await finished(link, store, to("Kitchen", "Packing 2", "Base"))
        seen = set()

        def on(state: FleetState) -> bool:
            seen.add(state.robots[FIRST].floor)
            return any(one.id == record.id and one.stage is Stage.DONE for one in state.commands)

        await store.until(on)
    assert seen >= floors == {"floor_0", "floor_1", "floor_2"}


def nav_graph_of(site: Hospital) -> str:
    """The navigation graph of all levels as the file that fleet adapters read."""
    levels = {}
    for floor in site.fleet.building.floors:
        places = {id_: n for n, id_ in enumerate(floor.graph.vertices)}
        vertices = [
            [one.x, one.y, {"name": floor.labels.get(id_, "")}] for id_, one in floor.graph.vertices.items()
        ]
        ends = [(places[one.start], places[one.end]) for one in floor.graph.edges]
        lanes = [[*pair, {}] for start, end in ends for pair in ((start, end), (end, start))]
        levels[floor.name] = {"vertices": vertices, "lanes": lanes}
    return json.dumps({"building_name": "hospital", "levels": levels})  # JSON is YAML


async def test_levels_of_a_file_serve_a_robot_on_all_floors(tmp_path: Path) -> None:
    async with hospital(robots=1, floors=3) as site:
        file = tmp_path / "nav.yaml"
        file.write_text(nav_graph_of(site))
        floors = [msgspec.structs.replace(one, graph=str(file)) for one in site.config.floors]
        profile = Profile(kind="rmf", topics={"graphs": ""})
        config = msgspec.structs.replace(site.config, floors=floors, profile=profile)
        assert [name for name, one in initial_state(config, 0.0).floors.items() if one.graph_problem] == []
        async with linked(config) as (link, store):
            await store.until(rmf_ready)
            record = await finished(link, store, to("Kitchen", "Packing 2"))
            seen = set()

            def on(state: FleetState) -> bool:
                seen.add(state.robots[FIRST].floor)
                return any(one.id == record.id and one.stage is Stage.DONE for one in state.commands)

            state = await store.until(on)
    assert seen == {"floor_0", "floor_1", "floor_2"}
    assert all(one.graph and one.labels for one in state.robots[FIRST].maps.values())

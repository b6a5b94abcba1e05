"""The whole link against the real loopback simulator."""

import asyncio
import gc

import msgspec
import pytest

from fleet_tui.client import writer
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    PauseRobot,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.events import CommandAdvanced
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.order import at_vertices
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fleets import place_order
from tests.support.links import finished, linked, path, phase, ready
from tests.support.watched_store import config_of

BAD_POSE = {"header": {"frame_id": "floor_0"}, "pose": {"position": {"x": None, "y": 1.0}}}


async def test_everything_is_heard(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2, 2)) as (_, store):
        state = await store.until(ready)
        robot = state.robots["robot_0"]
        assert set(robot.charts) == {"floor_0", "floor_1"}
        assert "Base" in robot.charts["floor_0"].labels.values()
        assert state.is_online(robot)


async def test_garbage_is_looked_for_while_it_runs(
    server: RosbridgeServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Python by itself waits for a million new objects: for a console at work that is 10 minutes and more."""
    monkeypatch.setattr(writer, "TIDY_EVERY", 0.0)
    looks = gc.get_stats()[2]["collections"]
    async with linked(config_of(server.url)) as (_, store):
        await store.until(lambda _: gc.get_stats()[2]["collections"] > looks + 1)


async def test_poses_are_subscribed_first_and_always_with_a_queue(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2, 2)) as (link, store):
        await store.until(ready)
        link.show_map("robot_0", "floor_0")
        await store.until(lambda state: state.robots["robot_0"].charts["floor_0"].grid)
        asked = [operation for operation in server.received if operation["op"] == "subscribe"]
    assert [operation["topic"] for operation in asked[:2]] == ["/robot_0/pose", "/robot_1/pose"]
    assert all(operation["queue_length"] >= 1 for operation in asked)
    assert all(type(operation["throttle_rate"]) is int for operation in asked)
    maps = [operation["topic"] for operation in asked if operation["topic"].endswith("/map")]
    assert maps == ["/robot_0/floor_0/map"]


async def test_a_map_arrives_as_binary_when_its_floor_is_shown(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1, 2)) as (link, store):
        await store.until(ready)
        assert store.state.robots["robot_0"].charts["floor_1"].grid is None
        link.show_map("robot_0", "floor_1")
        state = await store.until(lambda state: state.robots["robot_0"].charts["floor_1"].grid)
    grid = state.robots["robot_0"].charts["floor_1"].grid
    assert grid is not None
    assert grid.levels[0].shape == (grid.frame.height, grid.frame.width)
    assert set(grid.levels[0].ravel().tolist()) == {0, 1, 2}


async def test_an_order_is_accepted_cancelled_and_cleared(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        state = await store.until(ready)
        ids = {label: id_ for id_, label in state.robots["robot_0"].charts["floor_0"].labels.items()}
        order = place_order("robot_0", ids["Base"], ids["Consumidores"])
        assert (await finished(link, store, order)).stage is Stage.CONFIRMED
        state = store.state
        placed = state.robots["robot_0"].orders.orders[0]
        assert placed.stops == order.stops
        assert (await finished(link, store, CancelOrder("robot_0", placed.id))).stage is Stage.CONFIRMED
        assert not store.state.robots["robot_0"].orders.orders
        await finished(link, store, order)
        assert (await finished(link, store, ClearOrders("robot_0"))).stage is Stage.CONFIRMED
        assert not store.state.robots["robot_0"].orders.orders
        _, args = server.calls[0]
        assert set(args) == {"request_id", "initial_point", "end_point"}
        assert all(type(value) is int for value in args.values())


async def test_pause_and_resume_are_told_by_the_robot(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        assert store.state.is_paused(store.state.robots["robot_0"])
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.CONFIRMED
        assert not store.state.is_paused(store.state.robots["robot_0"])


async def test_a_refusal_in_an_answer_that_went_well(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, place_order("robot_0", 0, 9999))
    assert record.stage is Stage.REFUSED
    assert "no vertex 9999" in record.words


@pytest.mark.parametrize("order_id", [0, -1])
async def test_a_cancel_that_would_mean_all_never_leaves(server: RosbridgeServer, order_id: int) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, CancelOrder("robot_0", str(order_id)))
    assert record.stage is Stage.NOT_SENT
    assert not server.calls


async def test_a_command_without_a_link_is_refused_at_once_and_never_sent_later() -> None:
    server = RosbridgeServer(World(robots=1, floors=1, seed=1, quiet=True))
    await server.start()
    url, port = server.url, int(server.url.rpartition(":")[2])
    await server.stop()
    async with linked(config_of(url, 1)) as (link, store):
        state = await store.until(phase(Phase.WAITING))
        assert state.links["rosbridge"].reason == "connection refused"
        record = await finished(link, store, PauseRobot("robot_0"))
        assert record.stage is Stage.NOT_SENT
        late = RosbridgeServer(World(robots=1, floors=1, seed=1, quiet=True), port=port)
        await late.start()
        await store.until(ready)
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.CONFIRMED
        await late.stop()
    assert [service.rpartition("/")[2] for service, _ in late.calls] == ["Resume"]


async def test_a_drop_is_shown_and_heals_with_every_subscription(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2, 2)) as (link, store):
        await store.until(ready)
        link.show_map("robot_0", "floor_0")
        await store.until(lambda state: state.robots["robot_0"].charts["floor_0"].grid)
        topics = {operation["topic"] for operation in server.received if operation["op"] == "subscribe"}
        await server.drop_clients()
        await store.until(phase(Phase.WAITING))
        server.received.clear()
        heard = store.state.robots["robot_0"].heard or 0.0
        await store.until(
            lambda state: phase(Phase.UP)(state) and (state.robots["robot_0"].heard or 0) > heard
        )
        await store.until(lambda _: server.subscribers("/robot_0/floor_0/map") == 1)
        again = {operation["topic"] for operation in server.received if operation["op"] == "subscribe"}
    assert again == topics


async def test_a_command_under_way_ends_when_the_link_goes(server: RosbridgeServer) -> None:
    server.silent_services.add("/robot_0/Application_layout/Pause")
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        command_id = link.submit(PauseRobot("robot_0"))
        await store.until(lambda _: server.calls)
        await server.drop_clients()
        await store.until(lambda state: state.commands[-1].stage is Stage.UNKNOWN)
        # What became of it is seen after the return of the link, in the telemetry: it was not carried out.
        state = await store.until(lambda state: state.commands[-1].is_decided)
        record = state.commands[-1]
        steps = [event for event in store.events if isinstance(event, CommandAdvanced)]
    assert (record.id, record.stage) == (command_id, Stage.NOT_CONFIRMED)
    assert "outcome unknown" in record.words and "the robot reported no pause" in record.words
    assert [step.stage for step in steps] == [Stage.SENT, Stage.UNKNOWN]
    assert len(server.calls) == 1


async def test_a_call_never_answered_is_no_answer_and_then_not_confirmed(server: RosbridgeServer) -> None:
    server.silent_services.add("/robot_0/Application_layout/Pause")
    config = config_of(server.url, 1)
    alarms = msgspec.structs.replace(config.alarms, no_answer_after=0.3, not_confirmed_after=0.5)
    async with linked(msgspec.structs.replace(config, alarms=alarms)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, PauseRobot("robot_0"))
    assert [step.stage for step in record.steps[-2:]] == [Stage.NO_ANSWER, Stage.NOT_CONFIRMED]
    assert "no answer" in record.words and "0.3 s" in record.words


async def test_telemetry_alive_and_commands_dead_is_a_state_of_its_own(server: RosbridgeServer) -> None:
    server.master_alive = False
    async with linked(config_of(server.url, 1)) as (link, store):
        state = await store.until(path(CommandPath.DEAD))
        assert state.links["rosbridge"].command_reason == "no ROS master"
        state = await store.until(lambda state: state.robots["robot_0"].pose)
        assert state.links["rosbridge"].phase is Phase.UP
        record = await finished(link, store, ResumeRobot("robot_0"))
        assert record.stage is Stage.NOT_SENT
        assert "no ROS master" in record.words


async def test_a_bridge_without_rosapi_is_alive(server: RosbridgeServer) -> None:
    server.rosapi_alive = False
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED


async def test_a_topic_of_another_type_is_not_subscribed_and_said(server: RosbridgeServer) -> None:
    config = config_of(server.url, 1)
    profile = msgspec.structs.replace(config.profile, types={"battery": "std_msgs/Int8"})
    async with linked(msgspec.structs.replace(config, profile=profile)) as (_, store):
        state = await store.until(lambda state: state.robots["robot_0"].faults)
        await store.until(lambda state: state.robots["robot_0"].cargo)
        asked = [operation["topic"] for operation in server.received if operation["op"] == "subscribe"]
    assert (
        "/robot_0/battery has type std_msgs/Float32, not std_msgs/Int8" in state.robots["robot_0"].last_fault
    )
    assert "/robot_0/battery" not in asked


async def test_bad_data_is_counted_on_the_robot_and_the_rest_goes_on(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (_, store):
        await store.until(ready)
        server.publish_raw("/robot_0/pose", BAD_POSE)
        server.publish_raw("/robot_0/pose", '{"op":"publish","topic":')
        state = await store.until(
            lambda state: state.robots["robot_0"].faults and state.links["rosbridge"].faults
        )
        assert "/robot_0/pose" in state.robots["robot_0"].last_fault
        assert "position.x" in state.robots["robot_0"].last_fault
        heard = state.robots["robot_0"].heard or 0.0
        await store.until(lambda state: (state.robots["robot_0"].heard or 0.0) > heard)


async def test_read_only_lets_nothing_leave_but_subscriptions_and_rosapi(server: RosbridgeServer) -> None:
    config = config_of(server.url, 1)
    operator = msgspec.structs.replace(config.operator, read_only=True)
    async with linked(msgspec.structs.replace(config, operator=operator)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, PauseRobot("robot_0"))
        operations = list(server.received)
    assert record.stage is Stage.NOT_SENT
    assert "read-only" in record.words
    assert {operation["op"] for operation in operations} == {"subscribe", "call_service"}
    services = [operation["service"] for operation in operations if operation["op"] == "call_service"]
    assert all(service.startswith("/rosapi/") for service in services)


async def test_commands_do_not_wait_behind_subscriptions() -> None:
    """With 15 ms for each subscribe, as on a real bridge, a burst takes longer than a command may."""
    server = RosbridgeServer(World(robots=20, floors=2, seed=1, quiet=True), subscribe_delay=0.015)
    await server.start()
    async with linked(config_of(server.url, 20, 2)) as (link, store):
        await store.until(path(CommandPath.ALIVE))
        link.submit(PauseRobot("robot_0"))
        await store.until(lambda state: any(one.time_of(Stage.ACCEPTED) for one in state.commands))
        asked = [operation for operation in server.received if operation["op"] == "subscribe"]
    await server.stop()
    assert len(asked) < 20 * 12


async def test_two_consoles_see_one_order(server: RosbridgeServer) -> None:
    config = config_of(server.url, 1)
    async with linked(config) as (link, mine), linked(config) as (_, theirs):
        await mine.until(ready)
        await theirs.until(ready)
        await finished(link, mine, place_order("robot_0", 0, 1))
        state = await theirs.until(lambda state: state.robots["robot_0"].orders.orders)
        assert state.robots["robot_0"].orders.orders[0].stops == at_vertices("0", "1")


async def test_closing_leaves_no_task_behind(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (_, store):
        await store.until(ready)
    async with asyncio.timeout(5):
        while server.subscribers("/robot_0/pose"):  # noqa: ASYNC110  # nobody tells that a client left
            await asyncio.sleep(0)


async def test_nothing_is_put_into_a_connection_that_fell_silent(server: RosbridgeServer) -> None:
    """What a frozen bridge takes in it may obey much later."""
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        server.muted.update(topic for topic in store_topics(server))
        heard = store.state.links["rosbridge"].heard or 0.0
        await store.until(lambda state: state.now - max(heard, state.links["rosbridge"].heard or 0.0) > 2.5)
        record = await finished(link, store, ResumeRobot("robot_0"))
        assert record.stage is Stage.NOT_SENT
        assert "no message from the bridge" in record.words
        # A pause is tried all the same; as nothing is heard, nothing can confirm it.
        record = await finished(link, store, PauseRobot("robot_0"))
        assert record.stage is Stage.NOT_CONFIRMED and record.words.startswith("accepted")


def store_topics(server: RosbridgeServer) -> set[str]:
    return {operation["topic"] for operation in server.received if operation["op"] == "subscribe"}

"""The whole link against the real loopback simulator."""

import asyncio

import msgspec

from fleet_tui.model.commands import CancelOrder, ClearOrders, PauseRobot, ResumeRobot, Stage
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.order import at_vertices
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fleets import place_order
from tests.support.links import finished, linked, path, ready
from tests.support.polling import HANGS
from tests.support.watched_store import config_of

BAD_POSE = {"header": {"frame_id": "floor_0"}, "pose": {"position": {"x": None, "y": 1.0}}}


async def test_everything_is_heard(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 2, 2)) as (_, store):
        state = await store.until(ready)
        robot = state.robots["robot_0"]
        assert set(robot.maps) == {"floor_0", "floor_1"}
        assert "Base" in robot.maps["floor_0"].labels.values()
        assert state.is_online(robot)


async def test_a_map_arrives_as_binary_when_its_floor_is_shown(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1, 2)) as (link, store):
        await store.until(ready)
        assert store.state.robots["robot_0"].maps["floor_1"].grid is None
        link.show_map("robot_0", "floor_1")
        state = await store.until(lambda state: state.robots["robot_0"].maps["floor_1"].grid)
    grid = state.robots["robot_0"].maps["floor_1"].grid
    assert grid is not None
    assert grid.levels[0].shape == (grid.frame.height, grid.frame.width)
    assert set(grid.levels[0].ravel().tolist()) == {0, 1, 2}


async def test_an_order_is_accepted_cancelled_and_cleared(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        state = await store.until(ready)
        ids = {label: id_ for id_, label in state.robots["robot_0"].maps["floor_0"].labels.items()}
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
        _, args = server.bridge.services.calls[0]
        assert set(args) == {"request_id", "initial_point", "end_point"}
        assert all(type(value) is int for value in args.values())


async def test_pause_and_resume_are_told_by_the_robot(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED
        assert store.state.is_paused(store.state.robots["robot_0"])
        assert (await finished(link, store, ResumeRobot("robot_0"))).stage is Stage.CONFIRMED
        assert not store.state.is_paused(store.state.robots["robot_0"])


async def test_a_request_to_many_robots_is_one_and_told_before_the_first_is_sent(
    server: RosbridgeServer,
) -> None:
    async with linked(config_of(server.url, 2)) as (link, store):
        await store.until(ready)
        seen = list[list[Stage]]()
        store.watchers.append(lambda _, after: seen.append([one.stage for one in after.commands]))
        ids = link.submit_all([PauseRobot(f"robot_{n}") for n in range(2)])
        state = await store.until(lambda now: now.commands and all(one.is_decided for one in now.commands))
    assert [record.id for record in state.commands] == ids
    assert len({record.issued_at for record in state.commands}) == 1
    assert seen[:2] == [[Stage.CHECKED] * 2, [Stage.SENT] * 2]


async def test_one_that_fails_keeps_no_other_from_its_robot(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        failed, known = link.submit_all([PauseRobot("nobody"), PauseRobot("robot_0")])
        state = await store.until(
            lambda state: any(one.id == known and one.stage is Stage.CONFIRMED for one in state.commands)
        )
        (record,) = (one for one in state.commands if one.id == failed)
        assert (record.stage, record.detail) == (Stage.UNKNOWN, "internal error: see the log file")


async def test_telemetry_alive_and_commands_dead_is_a_state_of_its_own(server: RosbridgeServer) -> None:
    server.bridge.services.master_alive = False
    async with linked(config_of(server.url, 1)) as (link, store):
        state = await store.until(path(CommandPath.DEAD))
        assert state.links["rosbridge"].command_reason == "no ROS master"
        state = await store.until(lambda state: state.robots["robot_0"].pose)
        assert state.links["rosbridge"].phase is Phase.UP
        record = await finished(link, store, ResumeRobot("robot_0"))
        assert record.stage is Stage.NOT_SENT
        assert "no ROS master" in record.detail


async def test_a_bridge_without_rosapi_is_alive(server: RosbridgeServer) -> None:
    server.bridge.services.rosapi_alive = False
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        assert (await finished(link, store, PauseRobot("robot_0"))).stage is Stage.CONFIRMED


async def test_bad_data_is_counted_on_the_robot_and_the_rest_goes_on(server: RosbridgeServer) -> None:
    async with linked(config_of(server.url, 1)) as (_, store):
        await store.until(ready)
        server.bridge.publish_raw("/robot_0/pose", BAD_POSE)
        server.bridge.publish_raw("/robot_0/pose", '{"op":"publish","topic":')
        state = await store.until(
            lambda state: state.robots["robot_0"].faults and state.links["rosbridge"].faults
        )
        assert "/robot_0/pose" in state.robots["robot_0"].last_fault
        assert "position.x" in state.robots["robot_0"].last_fault
        received = state.robots["robot_0"].last_received or 0.0
        await store.until(lambda state: (state.robots["robot_0"].last_received or 0.0) > received)


async def test_read_only_lets_nothing_leave_but_subscriptions_and_rosapi(server: RosbridgeServer) -> None:
    config = config_of(server.url, 1)
    operator = msgspec.structs.replace(config.operator, read_only=True)
    async with linked(msgspec.structs.replace(config, operator=operator)) as (link, store):
        await store.until(ready)
        record = await finished(link, store, PauseRobot("robot_0"))
        operations = list(server.bridge.received)
    assert record.stage is Stage.NOT_SENT
    assert "read-only" in record.detail
    assert {operation["op"] for operation in operations} == {"subscribe", "call_service"}
    services = [operation["service"] for operation in operations if operation["op"] == "call_service"]
    assert all(service.startswith("/rosapi/") for service in services)


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
    async with asyncio.timeout(HANGS):
        while server.bridge.subscribers("/robot_0/pose"):  # noqa: ASYNC110  # nobody tells that a client left
            await asyncio.sleep(0)


async def test_nothing_is_put_into_a_connection_that_fell_silent(server: RosbridgeServer) -> None:
    """A frozen bridge may obey much later."""
    async with linked(config_of(server.url, 1)) as (link, store):
        await store.until(ready)
        server.bridge.muted.update(topic for topic in store_topics(server))
        received = store.state.links["rosbridge"].last_received or 0.0
        await store.until(
            lambda state: state.now - max(received, state.links["rosbridge"].last_received or 0.0) > 2.5
        )
        record = await finished(link, store, ResumeRobot("robot_0"))
        assert record.stage is Stage.NOT_SENT
        assert "no message from the bridge" in record.detail
        # A pause is tried all the same; as nothing is heard, nothing can confirm it.
        record = await finished(link, store, PauseRobot("robot_0"))
        assert record.stage is Stage.NOT_CONFIRMED and record.detail.startswith("accepted")


def store_topics(server: RosbridgeServer) -> set[str]:
    return {operation["topic"] for operation in server.bridge.received if operation["op"] == "subscribe"}

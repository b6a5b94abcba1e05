"""The server over real connections. Nothing sleeps: every wait is for a frame."""

import json

import pytest
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

from fleet_tui.simulator.ros.errors import ServiceError
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.errors import FleetError
from tests.support.bridge_client import Json, call, frames_before_an_answer, read, read_until, send, subscribe

POSE, POSE_TYPE = "/robot_0/pose", "geometry_msgs/PoseStamped"
GRAPH, GRAPH_TYPE = "/robot_0/floor_0/graph", "OH_ressources/Graph"
ORDER = "/robot_0/Application_layout/Execute_order"
PAUSE = "/robot_0/Application_layout/Pause"
ARGS = {"request_id": 1, "initial_point": 2, "end_point": 5}


async def test_poses_flow_to_every_client_alike(server: RosbridgeServer, client: ClientConnection) -> None:
    async with connect(server.url) as other:
        for each in (client, other):
            await subscribe(each, POSE, POSE_TYPE)
        seen = [await client.recv() for _ in range(10)]
        others = [await other.recv() for _ in range(10)]
    assert str(seen[0]).startswith('{"op":"publish","topic":"\\/robot_0\\/pose","msg":{"header":{"seq":')
    assert len(set(seen) & set(others)) >= 5
    numbers = [json.loads(frame)["msg"]["header"]["seq"] for frame in seen]
    assert numbers == sorted(set(numbers))


async def test_an_order_shows_in_the_queue_and_moves_the_robot(
    server: RosbridgeServer, client: ClientConnection
) -> None:
    await subscribe(client, POSE, POSE_TYPE)
    first = await read(client)
    await subscribe(client, "/robot_0/queue", "OH_ressources/ActionQueue")
    answer = await call(client, ORDER, ARGS)
    assert answer["values"] == {"request_id": 1, "status": "ACCEPTED"}
    frames = await read_until(client, lambda frame: frame.get("msg", {}).get("current_order_id") == 1)
    assert frames[-1]["msg"]["orders"] == [{"id": 1, "start": 2, "end": 5, "status": "W"}]
    await read_until(
        client, lambda frame: frame["topic"] == POSE and frame["msg"]["pose"] != first["msg"]["pose"]
    )
    assert server.bridge.services.calls == [(ORDER, ARGS)]


async def test_the_bridge_counts_its_clients(server: RosbridgeServer, client: ClientConnection) -> None:
    await subscribe(client, "/client_count", "std_msgs/Int32")
    assert (await read(client))["msg"] == {"data": 1}
    async with connect(server.url):
        assert (await read(client))["msg"] == {"data": 2}
    assert (await read(client))["msg"] == {"data": 1}


class TestDoors:
    async def test_a_silent_service_is_called_and_never_answers(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.services.silent_services.add(PAUSE)
        await send(client, "call_service", service=PAUSE, id="p")
        assert await frames_before_an_answer(client) == []
        assert server.bridge.services.calls == [(PAUSE, {})]
        assert not server.world.robots["robot_0"].paused

    async def test_answers_are_overridden(self, server: RosbridgeServer, client: ClientConnection) -> None:
        def broken(args: Json) -> Json:
            raise ServiceError(f"service [{PAUSE}] responded with an error: {args}")

        server.bridge.services.answers[ORDER] = lambda args: {
            "request_id": args["request_id"],
            "status": "REJECTED: too tired",
        }
        server.bridge.services.answers[PAUSE] = broken
        answer = await call(client, ORDER, {"request_id": 3})
        assert answer["values"] == {"request_id": 3, "status": "REJECTED: too tired"}
        answer = await call(client, PAUSE)
        assert (answer["values"], answer["result"]) == (
            f"service [{PAUSE}] responded with an error: {{}}",
            False,
        )

    async def test_without_a_master_calls_fail_and_topics_go_on(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.services.master_alive = False
        for service in (PAUSE, "/rosapi/topics"):
            answer = await call(client, service)
            assert (answer["values"], answer["result"]) == ("Unable to communicate with master!", False)
        await subscribe(client, POSE, POSE_TYPE)
        assert (await read(client))["topic"] == POSE

    async def test_without_rosapi_its_services_do_not_exist(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.services.rosapi_alive = False
        answer = await call(client, "/rosapi/topics")
        assert (answer["values"], answer["result"]) == ("Service /rosapi/topics does not exist", False)
        assert (await call(client, PAUSE))["result"]

    async def test_a_muted_topic_is_not_published(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.muted |= {POSE, GRAPH}
        await subscribe(client, POSE, POSE_TYPE)
        await subscribe(client, GRAPH, GRAPH_TYPE)
        await subscribe(client, "/robot_1/pose", POSE_TYPE)
        assert {(await read(client))["topic"] for _ in range(20)} == {"/robot_1/pose"}
        server.bridge.muted.clear()
        await read_until(client, lambda frame: frame["topic"] == POSE)

    async def test_dropped_clients_may_come_back(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        await subscribe(client, POSE, POSE_TYPE)
        await read(client)
        await server.drop_clients()
        with pytest.raises(ConnectionClosed):
            while True:
                await client.recv()
        assert server.bridge.subscribers(POSE) == 0
        async with connect(server.url) as again:
            await subscribe(again, POSE, POSE_TYPE)
            assert (await read(again))["topic"] == POSE

    async def test_every_operation_is_kept(self, server: RosbridgeServer, client: ClientConnection) -> None:
        await send(client, "nonsense", x=1)
        await frames_before_an_answer(client)
        assert list(server.bridge.received) == [
            {"op": "nonsense", "x": 1},
            {"op": "call_service", "service": "/rosapi/get_time", "id": "last"},
        ]
        assert server.bridge.services.calls == []


async def test_a_taken_port_is_named_with_a_remedy(server: RosbridgeServer) -> None:
    port = int(server.url.rsplit(":", 1)[1])
    with pytest.raises(FleetError, match=rf"port {port} .* is in use: .* --port"):
        await RosbridgeServer(server.world, port=port).start()

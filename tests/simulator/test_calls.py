"""Calls under way: answered, given up or never answered."""

from typing import Any

import pytest
from websockets.asyncio.client import ClientConnection

from fleet_tui.simulator.faults import parse_faults, wire
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import read_until, send
from tests.support.ros2_transcripts import given_up, recorded_answers
from tests.support.transcripts import until_answer

Json = dict[str, Any]
ORDER = "/robot_0/Application_layout/Execute_order"
PAUSE = "/robot_0/Application_layout/Pause"


@pytest.fixture
def server(ros2_server: RosbridgeServer) -> RosbridgeServer:
    return ros2_server


class TestCalls:
    async def test_a_slow_robot_is_given_up_and_obeys(
        self, server: RosbridgeServer, client: ClientConnection, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(wire, "SLOW", 0.4)
        play(server, parse_faults("slow-answer:robot_0", server.world.robots))
        args = {"request_id": 1, "initial_point": 0, "end_point": 2}
        await send(client, "call_service", id="o", service=ORDER, args=args, timeout=0.1)
        answer = await until_answer(client, "o")
        assert (answer["values"], answer["result"]) == (given_up(), False)
        assert len(server.world.robots["robot_0"].orders) == 1
        await send(client, "call_service", id="p", service=ORDER, args=args, timeout=5.0)
        came = await read_until(client, lambda frame: frame.get("id") == "p")
        assert [frame["id"] for frame in came] == ["p"]  # the late answer to the first never comes
        assert came[0]["result"]

    async def test_a_node_that_wakes_too_late_does_not_obey(
        self, server: RosbridgeServer, client: ClientConnection
    ) -> None:
        server.bridge.services.frozen[ORDER] = 0.2
        for limit, orders in ((0.05, 0), (5.0, 1)):
            await send(client, "call_service", id="o", service=ORDER, args={}, timeout=limit)
            await until_answer(client, "o")
            assert len(server.world.robots["robot_0"].orders) == orders

    @pytest.mark.parametrize("name", ["dies", "throws", "never"])
    async def test_silence_ends_in_the_time_limit(
        self, server: RosbridgeServer, client: ClientConnection, name: str
    ) -> None:
        play(server, parse_faults(f"{name}:robot_0", server.world.robots))
        await send(client, "call_service", id="o", service=ORDER, args={}, timeout=0.1)
        answer = await until_answer(client, "o")
        assert (answer["values"], answer["result"]) == (given_up(), False)

    async def test_a_time_limit_must_be_a_number(self, client: ClientConnection) -> None:
        (recorded,) = [
            one for one in recorded_answers("ros2-services.jsonl.gz").values() if "'>'" in str(one)
        ]
        await send(client, "call_service", id="o", service=PAUSE, timeout="2")
        answer = await until_answer(client, "o")
        assert (answer["values"], answer["result"]) == (recorded["values"], False)

    async def test_the_limit_is_five_seconds(self) -> None:
        assert ROS2.call_timeout == 5.0

"""Logs and diagnostics of robots on the wire."""

import json

from websockets.asyncio.client import connect

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.bridge_client import read_until, send
from tests.support.counting import counter, until
from tests.support.links import linked, ready
from tests.support.watched_store import config_of


async def test_it_comes_over_the_wire_with_the_types_that_rosapi_tells(server: RosbridgeServer) -> None:
    asked = server.bridge.services.answer({"service": "/rosapi/topics", "id": "1"})
    assert isinstance(asked, str)
    values = json.loads(asked)["values"]
    types = dict(zip(values["topics"], values["types"], strict=True))
    assert types["/rosout"] == "rosgraph_msgs/Log"
    assert types["/diagnostics"] == "diagnostic_msgs/DiagnosticArray"
    async with linked(config_of(server.url, 2)) as (link, store):
        await store.until(ready)
        link.subscribe_logs(True)
        await until(store, lambda: counter(link).health)
        server.world.robots["robot_0"].paused = True
        await until(store, lambda: any(line.node != "/rosbridge_websocket" for line in counter(link).log))
        line = next(line for line in counter(link).log if line.node != "/rosbridge_websocket")
        assert (line.node, line.text) == ("/robot_0/drive", "brakes on")
        assert sorted(counter(link).health)[:3] == ["robot_0: battery", "robot_0: drive", "robot_0: laser"]


async def test_a_bridge_of_ros_1_logs_what_it_does_not_take_too(server: RosbridgeServer) -> None:
    async with connect(server.url) as client:
        await send(client, "subscribe", topic="/rosout", type="rosgraph_msgs/Log")
        await send(client, "subscribe", id="mine", topic="/robot_0/pose", type="std_msgs/String")
        line = (await read_until(client, lambda frame: "[id: mine]" in str(frame)))[-1]["msg"]
    assert (line["level"], line["name"]) == (8, "/rosbridge_websocket") and "subscribe: " in line["msg"]

"""Logs and diagnostics of robots on the wire."""

import json

from fleet_tui.simulator.server import RosbridgeServer
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
        await until(store, lambda: counter(link).log)
        line = counter(link).log[0]
        assert (line.node, line.text) == ("/robot_0/drive", "brakes on")
        assert sorted(counter(link).health)[:3] == ["robot_0: battery", "robot_0: drive", "robot_0: laser"]

"""The questions of rosapi and their answers."""

import pytest
from websockets.asyncio.client import ClientConnection

from tests.support.bridge_client import call, subscribe

GRAPH, GRAPH_TYPE = "/robot_0/floor_0/graph", "OH_ressources/Graph"

POSE, MAP = "/robot_0/pose", "/robot_0/floor_0/map"


async def test_rosapi_keeps_params_and_tells_of_nodes(client: ClientConnection) -> None:
    await call(client, "/rosapi/set_param", {"name": "/speed", "value": "1.5"})
    assert (await call(client, "/rosapi/get_param", {"name": "/speed"}))["values"] == {"value": "1.5"}
    assert (await call(client, "/rosapi/has_param", {"name": "/speed"}))["values"] == {"exists": True}
    assert "/speed" in (await call(client, "/rosapi/get_param_names"))["values"]["names"]
    await call(client, "/rosapi/delete_param", {"name": "/speed"})
    assert (await call(client, "/rosapi/has_param", {"name": "/speed"}))["values"] == {"exists": False}
    details = (await call(client, "/rosapi/node_details", {"node": "/fleet"}))["values"]
    assert POSE in details["publishing"] and "/robot_0/initialpose" in details["subscribing"]
    assert "/robot_0/Application_layout/Pause" in details["services"]
    raw = (await call(client, "/rosapi/topics_and_raw_types"))["values"]
    text = raw["typedefs_full_text"][raw["topics"].index("/robot_0/battery")]
    assert text == "float32 data"


@pytest.mark.parametrize(
    ("verb", "names"),
    [("request", ["request_id", "initial_point", "end_point"]), ("response", ["request_id", "status"])],
)
async def test_rosapi_describes_services(client: ClientConnection, verb: str, names: list[str]) -> None:
    args = {"type": "OH_ressources/Execute_manual_order"}
    (typedef,) = (await call(client, f"/rosapi/service_{verb}_details", args))["values"]["typedefs"]
    assert typedef["type"] == f"OH_ressources/Execute_manual_order{verb.capitalize()}"
    assert typedef["fieldnames"] == names
    assert typedef["fieldarraylen"] == [-1] * len(names)


async def test_rosapi_answers_emptily_about_unknown_names(client: ClientConnection) -> None:
    for verb, args, empty in (
        ("topic_type", {"topic": "/x"}, {"type": ""}),
        ("service_type", {"service": "/x"}, {"type": ""}),
        ("service_node", {"service": "/x"}, {"node": ""}),
        ("publishers", {"topic": "/x"}, {"publishers": []}),
        ("subscribers", {"topic": "/x"}, {"subscribers": []}),
        ("topics_for_type", {"type": "x/X"}, {"topics": []}),
        ("message_details", {"type": "x/X"}, {"typedefs": []}),
    ):
        answer = await call(client, f"/rosapi/{verb}", args)
        assert (answer["values"], answer["result"]) == (empty, True)


async def test_rosapi_knows_who_subscribes(client: ClientConnection) -> None:
    await subscribe(client, GRAPH, GRAPH_TYPE)
    answer = await call(client, "/rosapi/subscribers", {"topic": GRAPH})
    assert answer["values"] == {"subscribers": ["/rosbridge_websocket"]}
    answer = await call(client, "/rosapi/topics_for_type", {"type": "geometry_msgs/PoseStamped"})
    assert answer["values"] == {
        "topics": ["/robot_0/goal", "/robot_1/goal", "/robot_0/pose", "/robot_1/pose"]
    }

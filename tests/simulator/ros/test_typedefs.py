"""Messages described, with all that is in them."""

from websockets.asyncio.client import ClientConnection

from tests.support.bridge_client import call


async def test_rosapi_describes_a_message_and_all_in_it(client: ClientConnection) -> None:
    args = {"type": "OH_ressources/Graph"}
    graph, *parts = (await call(client, "/rosapi/message_details", args))["values"]["typedefs"]
    assert graph == {
        "type": "OH_ressources/Graph",
        "fieldnames": ["vertices", "edges"],
        "fieldtypes": ["OH_ressources/Vertex", "OH_ressources/Edge"],
        "fieldarraylen": [0, 0],
        "examples": ["[]", "[]"],
        "constnames": [],
        "constvalues": [],
    }
    assert [part["type"] for part in parts] == ["OH_ressources/Vertex", "OH_ressources/Edge"]

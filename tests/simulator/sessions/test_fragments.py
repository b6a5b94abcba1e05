"""Messages in fragments, both ways."""

import json

from websockets.asyncio.client import ClientConnection

from tests.support.bridge_client import read, send


async def test_fragments_in_both_directions(client: ClientConnection) -> None:
    text = json.dumps({"op": "subscribe", "topic": "/robot_0/floor_0/graph", "fragment_size": 700})
    for number, data in enumerate((text[:10], text[10:])):
        await send(client, "fragment", id="whole", data=data, num=number, total=2)
    first = await read(client)
    assert (first["op"], first["id"], first["num"], len(first["data"])) == ("fragment", 0, 0, 700)
    parts = [first, *[await read(client) for _ in range(first["total"] - 1)]]
    assert len(json.loads("".join(part["data"] for part in parts))["msg"]["vertices"]) == 20

"""Messages of robots and floors, in the shape of those recorded."""

from websockets.asyncio.client import connect

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.transcripts import frames, ours, parsed, recording, shape


async def test_every_topic_says_messages_of_the_same_shape(three: RosbridgeServer) -> None:
    lines = recording("telemetry-and-orders.jsonl")
    three.world.robots["robot_1"].take(0, 7, request_id=1)
    theirs: dict[str, object] = {}
    for frame in map(parsed, frames(lines, "in")):
        if frame["op"] == "publish":  # the last message of each topic: the queue is not empty there
            theirs[ours(frame["topic"])] = shape(frame)
    found: dict[str, object] = {}
    async with connect(three.url) as client:
        for text in frames(lines, "out"):
            if parsed(text).get("op") == "subscribe":
                await client.send(ours(text))
        while found.keys() != theirs.keys():
            text = str(await client.recv())
            assert text.startswith('{"op":"publish","topic":"\\/robot_1\\/')
            frame = parsed(text)
            found[frame["topic"]] = shape(frame)
    assert found == theirs

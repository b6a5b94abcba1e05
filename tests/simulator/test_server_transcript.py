"""The simulator against recordings of a real bridge: same answers, same shapes, same bytes on the wire."""

import base64

import cbor2
from websockets.asyncio.client import connect

from fleet_tui.simulator.server import RosbridgeServer
from tests.support.transcripts import Json, frames, ours, parsed, recording, shape, until_answer

ELSEWHERE = ("scan", "camera", "connected_clients")  # topics the simulated robots don't have


async def test_every_call_is_answered_in_the_same_words(three: RosbridgeServer) -> None:
    lines = recording("telemetry-and-orders.jsonl")
    theirs = {frame["id"]: frame for frame in map(parsed, frames(lines, "in")) if "id" in frame}
    async with connect(three.url) as client:
        for text in frames(lines, "out"):
            if "with_cargo" in text:  # the recorded robot took such an order without cargo
                three.world.robots["robot_1"].cargo = True
            await client.send(ours(text))
            operation = parsed(text)
            if operation.get("op") == "call_service":
                answer = await until_answer(client, operation["id"])
                assert answer == theirs.pop(operation["id"])
                assert list(answer) == ["op", "service", "values", "result", "id"]
    assert theirs == {}


async def test_rosapi_answers_alike(three: RosbridgeServer) -> None:
    lines = recording("rosapi-and-scan.jsonl")
    theirs = {frame["id"]: frame for frame in map(parsed, frames(lines, "in")) if "id" in frame}
    answers: dict[str, Json] = {}
    async with connect(three.url) as client:
        for text in frames(lines, "out"):
            await client.send(ours(text))
            if "id" in parsed(text) and parsed(text)["op"] == "call_service":
                answers[parsed(text)["id"]] = await until_answer(client, parsed(text)["id"])
    assert {id_: shape(frame) for id_, frame in answers.items()} == {
        id_: shape(frame) for id_, frame in theirs.items()
    }
    for id_ in ("a4", "a5", "a6"):
        assert answers[id_] == theirs[id_]
    topics = dict(zip(*answers["a1"]["values"].values(), strict=True))
    recorded = dict(zip(*theirs["a1"]["values"].values(), strict=True))
    wanted = {ours(topic): type_ for topic, type_ in recorded.items() if not topic.endswith(ELSEWHERE)}
    assert wanted.items() <= topics.items()
    robots = [name for name in theirs["a2"]["values"]["services"] if name.startswith("/robot_")]
    assert set(robots) <= set(answers["a2"]["values"]["services"])


async def test_the_number_of_clients_is_told_alike(three: RosbridgeServer) -> None:
    lines = recording("rosapi-and-scan.jsonl")
    (told,) = [text for text in frames(lines, "in") if text.startswith('{"op":"publish","topic":"\\/client')]
    (asked,) = [text for text in frames(lines, "out") if '"/client_count"' in text]
    async with connect(three.url) as client:
        await client.send(asked)
        assert await client.recv() == told


async def test_a_map_is_sent_alike_as_json(three: RosbridgeServer) -> None:
    lines = recording("map-json.jsonl.gz")
    async with connect(three.url, max_size=None) as client:
        await client.send(ours(frames(lines, "out")[0]))
        text = str(await client.recv())
    theirs = frames(lines, "in")[0]
    assert shape(parsed(text)) == shape(parsed(theirs))
    assert text.startswith('{"op":"publish","topic":"\\/robot_1\\/floor_0\\/map","msg":{"header":{"seq":1,')
    info, data = parsed(text)["msg"]["info"], parsed(text)["msg"]["data"]
    assert len(data) == info["width"] * info["height"]
    assert set(data) == set(parsed(theirs)["msg"]["data"]) == {-1, 0, 100}
    assert info["resolution"] == parsed(theirs)["msg"]["info"]["resolution"]


async def test_a_map_is_sent_alike_as_cbor(three: RosbridgeServer) -> None:
    lines = recording("map-cbor.jsonl.gz")
    async with connect(three.url, max_size=None) as client:
        await client.send(ours(frames(lines, "out")[0]))
        binary = await client.recv()
    (theirs,) = [base64.b64decode(line["binary"]) for line in lines if "binary" in line]
    assert isinstance(binary, bytes)
    message, recorded = cbor2.loads(binary), cbor2.loads(theirs)
    assert shape(message) == shape(recorded)
    data = message["msg"]["data"]
    assert data.tag == recorded["msg"]["data"].tag == 72
    assert len(data.value) == 800 * 520
    assert set(data.value) == {255, 0, 100}
    head = b"\xa3bopgpublishetopic"
    assert binary.startswith(head) and theirs.startswith(head)

"""Stock clients get from the simulator what they got from a real bridge: roslibpy and roslibjs."""

import asyncio
import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.polling import HANGS
from tests.support.ros2_transcripts import theirs
from tests.support.transcripts import frames, parsed, recording

Json = dict[str, Any]

HERE = Path(__file__).parent
ROOT = HERE.parent.parent
ROSLIBJS = "roslib@2.1.0"
POSE, QUEUE, GRAPH = "/robot_1/pose", "/robot_1/queue", "/robot_1/floor_0/graph"
RECORDINGS = {
    1: ("telemetry-and-orders.jsonl", "rosapi-and-scan.jsonl"),
    2: ("ros2-services.jsonl.gz", "ros2-rosapi.jsonl.gz", "ros2-topics.jsonl.gz"),
}
NOT_OURS = ("/probe", "/tb1", "/map", "/fake_nav2", "with_cargo", "action_servers")
DIES = ("/nope", "message_details", "_param", "interfaces", "raw_types", "_details")


def calls(dialect: Dialect) -> tuple[list[Json], dict[str, Json]]:
    """The recorded calls that a stock client can make, and the recorded answers."""
    asked, answers = list[Json](), dict[str, Json]()
    for name in RECORDINGS[dialect.version]:
        for frame in map(parsed, frames(recording(name), "in")):
            if frame.get("op") == "service_response":
                answers[frame["id"]] = frame
        for text in map(theirs, frames(recording(name), "out")):
            frame = parsed(text)
            plain = isinstance(frame.get("args"), dict) and "timeout" not in frame
            known = not any(part in text for part in NOT_OURS) and "7.0" not in text  # 7 in JavaScript
            harmless = dialect.version == 1 or not any(part in text for part in DIES) or "topic_type" in text
            if frame.get("op") == "call_service" and plain and known and harmless:
                asked.append({key: frame[key] for key in ("id", "service", "args")})
    return asked, answers


def messages(dialect: Dialect) -> dict[str, Json]:
    """The recorded messages; the last of each topic."""
    found: dict[str, Json] = {}
    for name in RECORDINGS[dialect.version]:
        for frame in map(parsed, frames(recording(name), "in")):
            topic = theirs(frame.get("topic", "")) if frame.get("op") == "publish" else ""
            if topic in (QUEUE, GRAPH) or (topic == POSE and dialect.version == 1):
                found[topic] = frame["msg"]
    return found


async def asked_by(client: list[str], dialect: Dialect) -> Json:
    """The messages of a stock client, as its program prints them."""
    server = RosbridgeServer(OhFleet(3, 2, seed=1, quiet=True), rate=20.0, dialect=dialect)
    await server.start()
    server.bridge.started -= 10.0
    message, service = dialect.message_type, dialect.service_type
    asked = {
        "url": server.url,
        "calls": calls(dialect)[0],
        "topics": {
            POSE: message("geometry_msgs/PoseStamped"),
            QUEUE: message("OH_ressources/ActionQueue"),
            GRAPH: message("OH_ressources/Graph"),
        },
        "string": message("std_msgs/String"),
        "set_bool": service("std_srvs/SetBool"),
        "pose": message("geometry_msgs/PoseStamped"),
    }
    process = await asyncio.create_subprocess_exec(
        *client, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    try:
        async with asyncio.timeout(HANGS):
            out, err = await process.communicate(json.dumps(asked).encode())
    finally:
        if process.returncode is None:
            process.kill()
            await process.wait()
        await server.stop()
    assert process.returncode == 0, err.decode()
    found: Json = json.loads(out)
    return found


def alike(value: object) -> object:
    """The shape of a value, without the difference of 1 and 1.0 that JavaScript does not know."""
    if isinstance(value, dict):
        return [(name, alike(inner)) for name, inner in value.items()]
    if isinstance(value, list):
        return [alike(inner) for inner in value[:1]]
    return float if isinstance(value, int) and not isinstance(value, bool) else type(value)


def check(found: Json, dialect: Dialect) -> None:
    asked, recorded = calls(dialect)
    assert len(asked) >= 15
    for call in asked:
        result, values = found["answers"][call["id"]]
        wanted = recorded[call["id"]]
        assert (result, alike(values)) == (wanted["result"], alike(wanted["values"])), call
        if not result:
            assert values == wanted["values"]
    for topic, message in messages(dialect).items():
        if topic == QUEUE:  # whether orders are in it differs
            assert list(found["messages"][topic]) == list(message)
        else:
            assert alike(found["messages"][topic]) == alike(message)
    assert found["echo"] == {"data": "hello"}
    assert found["served"] == [True, {"success": True, "message": "done"}]
    assert found["topic_type"] == dialect.message_type("geometry_msgs/PoseStamped")
    assert "/rosbridge_websocket" in found["nodes"]
    assert found["fields"] == ["header", "pose"]


@pytest.mark.parametrize("dialect", [ROS1, ROS2], ids=["ros1", "ros2"])
async def test_roslibpy(dialect: Dialect) -> None:
    check(await asked_by([sys.executable, str(HERE / "stock_client.py")], dialect), dialect)


def roslibjs() -> Path:
    """The folder in which npm has put roslibjs; skips the test where it can't."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if node is None or npm is None:
        pytest.skip("roslibjs is not tried: there is no node or no npm")
    folder = ROOT / ".venv" / "roslibjs"
    if not (folder / "node_modules" / "roslib" / "package.json").exists():
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "package.json").write_text('{"private": true}\n')
        quickly = ["--no-audit", "--no-fund", "--fetch-retries=0", "--fetch-timeout=20000"]
        command = [npm, "install", *quickly, ROSLIBJS]
        try:
            subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60, check=True)
        except (subprocess.CalledProcessError, subprocess.TimeoutExpired) as error:
            shutil.rmtree(folder)
            pytest.skip(f"roslibjs is not tried: npm can't install it: {error}")
    return folder


async def test_roslibjs() -> None:
    folder = roslibjs()
    for dialect in (ROS1, ROS2):
        check(await asked_by(["node", str(HERE / "stock_client.mjs"), str(folder)], dialect), dialect)

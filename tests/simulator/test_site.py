"""Robots of every kind at one site, behind three bridges."""

import asyncio
import json
import socket
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from websockets.asyncio.client import connect

from fleet_tui.config.schema import Config
from fleet_tui.console.demo import demo_config
from fleet_tui.simulator.faults import parse_faults_of
from fleet_tui.simulator.fleets import Fleet
from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.ros.dialect import ROS1
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.simulator.site import MIXED, Crew, SitedBridge, faults_of, site_of
from fleet_tui.text.errors import ConfigError
from tests.support.command_line import run
from tests.support.mqtt_peer import Peer
from tests.support.nav2_client import Json, call, listen, until
from tests.support.polling import HANGS, eventually

URLS = "ws://one:1", "ws://two:2", "ws://three:3"


def fleets(robots: int, floors: int) -> list[Fleet]:
    """The fleets behind the bridge of ROS 1."""
    crews = site_of(MIXED, robots)[0].crews
    return [
        KINDS[crew.kind].build(len(crew.numbers), floors, 1, crew.numbers.start, crew.numbers.step)
        for crew in crews
    ]


@contextmanager
def sim(folder: Path, *args: str, count: int = 3) -> Iterator[list[str]]:
    """`fleet-tui sim --kind mixed` as a process; its URLs."""
    command = [sys.executable, "-m", "fleet_tui", "sim", "--kind", "mixed", "--stop-with-stdin", *args]
    with subprocess.Popen(
        command, cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as child:
        assert child.stdin is not None and child.stdout is not None
        yield [child.stdout.readline().strip() for _ in range(count)]
        child.stdin.close()
        assert child.wait(10) == 0


def free_ports() -> int:
    """A port that is free, and so are the next ones."""
    while True:
        with socket.socket() as one, socket.socket() as second, socket.socket() as third:
            one.bind(("127.0.0.1", 0))
            port = int(one.getsockname()[1])
            try:
                second.bind(("127.0.0.1", port + 1))
                third.bind(("127.0.0.1", port + 2))
            except OSError:
                continue
            return port


def test_the_kinds_take_turns() -> None:
    assert site_of(MIXED, 6) == [
        SitedBridge("ros1", "1", (Crew("oh_ressources", range(0, 6, 4)), Crew("move_base", range(1, 6, 4)))),
        SitedBridge("ros2", "2", (Crew("nav2", range(2, 6, 4)),)),
        SitedBridge("rmf", "2", (Crew("rmf", range(3, 6, 4)),)),
    ]
    crews = [crew for bridge in site_of(MIXED, 17, first=4) for crew in bridge.crews]
    numbers = sorted(number for crew in crews for number in crew.numbers)
    assert numbers == list(range(4, 21))
    assert max(len(crew.numbers) for crew in crews) - min(len(crew.numbers) for crew in crews) <= 1


@pytest.mark.parametrize("floors", [1, 3])
def test_fleets_behind_one_bridge_share_no_topic_service_or_listener(floors: int) -> None:
    both = fleets(11, floors)
    topics = Counter(topic.name for fleet in both for topic in fleet.topics(0.0, ROS1))
    services = Counter(name for fleet in both for name in fleet.services(ROS1))
    subscriptions = Counter(name for fleet in both for name in fleet.subscriptions())
    assert {count for names in (topics, services, subscriptions) for count in names.values()} == {1}
    assert len(RosbridgeServer(both).bridge.services.robots) == 6


def labels(message: Json) -> dict[int, str]:
    return {one["vertex_id"]: one["label"] for one in message["vertices"]}


def test_the_graphs_topic_and_file_agree(tmp_path: Path) -> None:
    server = RosbridgeServer(fleets(4, 2))
    config = demo_config(Config(), URLS[0], 4, 2, kind=MIXED, folder=tmp_path, further=URLS[1:])
    for floor in config.floors:
        told = {
            name: json.loads(server.bridge.topics[f"/robot_0/{floor.name}/{name}"].payload(0.0).json)
            for name in ("graph", "labeled_vertices")
        }
        nodes = [
            one
            for one in json.loads(Path(floor.graph).read_text())["features"]
            if one["geometry"]["type"] == "Point"
        ]
        spots = {one["properties"]["id"]: one["geometry"]["coordinates"] for one in nodes}
        named = {one["properties"]["id"]: one["properties"]["metadata"].get("name") for one in nodes}
        assert {one["id"]: [one["x"], one["y"]] for one in told["graph"]["vertices"]} == spots
        assert labels(told["labeled_vertices"]) == {id_: name for id_, name in named.items() if name}
        maps = [
            json.loads(server.bridge.topics[name].payload(0.0).json)
            for name in (f"/robot_0/{floor.name}/map", f"/{floor.name}/map")
        ]
        assert maps[0]["data"] == maps[1]["data"] and maps[0]["info"] == maps[1]["info"]


class TestFaults:
    KNOWN = faults_of(site_of(MIXED, 5))

    def test_a_fault_is_for_every_robot_that_knows_it(self) -> None:
        assert parse_faults_of("stuck", self.KNOWN) == [
            ("stuck", name) for name in ("robot_0", "robot_4", "robot_1", "robot_2")
        ]
        assert parse_faults_of("inactive", self.KNOWN) == [("inactive", "robot_2")]
        assert parse_faults_of("first-lost,restart:robot_0", self.KNOWN) == [
            ("first-lost", "robot_1"),
            ("restart", "robot_0"),
        ]

    def test_a_robots_fault_is_one_of_its_kind(self) -> None:
        with pytest.raises(ConfigError) as raised:
            parse_faults_of("inactive:robot_0,inactve,stuck:robot_9", self.KNOWN)
        first, second, third = raised.value.problems
        assert first.startswith("--fault inactive:robot_0: unknown fault of this kind of robots")
        assert second == "--fault inactve: unknown fault, did you mean inactive?"
        assert third.startswith("--fault stuck:robot_9: unknown robot")


async def test_sim_serves_three_bridges_and_writes_the_graphs(tmp_path: Path) -> None:
    port = free_ports()
    args = ("--port", str(port), "--robots", "5", "--floors", "2", "--graph-file", "graphs")
    with sim(tmp_path, *args, "--fault", "reject,silent:robot_1") as urls:
        assert urls == [f"ws://127.0.0.1:{at}" for at in (port, port + 1, port + 2)]
        async with connect(urls[0]) as ros1, connect(urls[1]) as ros2, asyncio.timeout(HANGS):
            topics = (await call(ros1, "/rosapi/topics"))["topics"]
            assert {"/robot_0/queue", "/robot_4/queue", "/robot_1/move_base/status", "/floor_0/map"} <= {
                *topics
            }
            assert not any(name.startswith("/robot_2/") for name in topics)
            assert (await call(ros2, "/rosapi/get_ros_version"))["version"] == 2
            types = await call(ros2, "/rosapi/topics")
            assert "/robot_2/odom" in types["topics"] and "/robot_1/odom" not in types["topics"]
            for topic in ("/robot_1/odom", "/robot_0/pose"):
                await listen(ros1, topic)
            for _ in range(5):
                assert json.loads(await ros1.recv())["topic"] == "/robot_0/pose"
            goal: Json = {"op": "send_action_goal", "id": "a", "action": "/robot_2/navigate_to_pose"}
            goal |= {"action_type": "nav2_msgs/action/NavigateToPose", "args": {}}
            await ros2.send(json.dumps(goal))
            answer = await until(ros2, lambda frame: frame["op"] == "action_result")
            assert answer["values"] == "Action goal was rejected"
    assert sorted(path.name for path in (tmp_path / "graphs").iterdir()) == [
        "floor_0.geojson",
        "floor_1.geojson",
    ]


def test_vehicles_are_beside_the_bridges_on_a_broker(tmp_path: Path) -> None:
    with sim(tmp_path, "--port", "0", count=4) as urls:
        assert urls[3].startswith("mqtt://127.0.0.1:")
        peer = Peer(int(urls[3].rsplit(":", 1)[1]), "uagv/+/+/+/connection")
        eventually(lambda: {one.topic.split("/")[3] for one in peer.told} == {"agv_0", "agv_1"})
        peer.close()


def test_sim_takes_free_ports(tmp_path: Path) -> None:
    with sim(tmp_path, "--port", "0") as urls:
        assert len(set(urls)) == 3 and all(url.startswith("ws://127.0.0.1:") for url in urls)


def test_a_port_that_is_taken_ends_all(tmp_path: Path) -> None:
    port = free_ports()
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", port + 1))
        taken.listen()
        command = [sys.executable, "-m", "fleet_tui", "sim", "--kind", "mixed", "--port", str(port)]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, timeout=20)
    assert done.returncode != 0 and done.stdout == "" and f"port {port + 1}" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(
    ("args", "words"),
    [
        (("--robots", "3"), "at least --robots 4"),
        (("--ros", "1"), "--ros needs a single kind"),
        (("--port", "65535"), "needs 3 ports"),
        (("--fault", "inactive:robot_1"), "unknown fault of this kind of robots"),
    ],
)
def test_what_makes_no_sense_is_a_usage_error(tmp_path: Path, args: tuple[str, ...], words: str) -> None:
    done = run("sim", "--port", "0", "--kind", "mixed", *args, cwd=tmp_path)
    assert done.returncode == 2 and words in done.stderr and "Traceback" not in done.stderr

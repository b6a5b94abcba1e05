"""The simulator as a process: it comes, says where it is, and goes without a word."""

import asyncio
import json
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from websockets.asyncio.client import connect

from fleet_tui.adapters.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.config.schema import Config
from fleet_tui.demo import demo_config, simulated
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.adapters import names_of

PROGRAM = """
from fleet_tui.simulator.run import run
run(1, 1, 0, 10.0, 1, lambda urls: print(*urls, flush=True), stop_with_stdin=True)
"""


@pytest.fixture
def process() -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [sys.executable, "-c", PROGRAM],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline().startswith("ws://127.0.0.1:")
        yield process
        process.kill()


@pytest.fixture
def fast() -> Iterator[str]:
    """The URL of a fleet on ROS 2 whose time runs fifty times as fast."""
    with simulated(3, 1, speed=50.0, ros="2") as (url,):
        yield url


async def test_it_speaks_the_dialect_and_runs_at_the_speed_that_is_asked_for(fast: str) -> None:
    async with connect(fast) as client:
        await client.send('{"op":"call_service","id":"v","service":"/rosapi/get_ros_version"}')
        assert json.loads(await client.recv())["values"] == {"version": 2, "distro": "jazzy"}
        ask = {"op": "subscribe", "topic": "/robot_0/queue", "type": "oh_ressources/msg/ActionQueue"}
        await client.send(json.dumps(ask))
        async with asyncio.timeout(30):  # at its own pace a robot drives an order for half a minute
            while json.loads(await client.recv())["msg"]["last_order_id"] < 3:
                pass


def test_the_demos_configuration_names_the_types_of_ros_2() -> None:
    server = RosbridgeServer(World(1, 1), dialect=ROS2)
    names = names_of(demo_config(Config(path=Path("c.toml")), server.url, 1, 1, "2").profile)
    for key in VOCABULARY.topics:
        assert names.type(key) == server.bridge.services.types[names.topic(key, "robot_0", "floor_0")]
    for key in VOCABULARY.services:
        assert names.service_type(key) == server.bridge.services.offered[names.service(key, "robot_0")].name


@pytest.mark.parametrize(("number", "code"), [(signal.SIGTERM, 0), (signal.SIGINT, 130)])
def test_a_signal_ends_it_quietly(process: subprocess.Popen[str], number: int, code: int) -> None:
    process.send_signal(number)
    assert process.wait(10) == code
    assert process.stderr is not None
    assert process.stderr.read() == ""


def test_it_ends_with_its_parents_pipe(process: subprocess.Popen[str]) -> None:
    assert process.stdin is not None
    process.stdin.close()
    assert process.wait(10) == 0
    assert process.stderr is not None
    assert process.stderr.read() == ""

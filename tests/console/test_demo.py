"""The demo: its configuration by kinds and links, and its simulator in a process."""

import asyncio
import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from websockets.asyncio.client import connect

from fleet_tui.config.entries import RobotEntry
from fleet_tui.config.fleet import adapters_of
from fleet_tui.config.programs import ProgramEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.console.demo import SIZE, demo_config, simulated, with_vehicles
from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.simulator.kinds import KINDS
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.simulator.site import MIXED
from tests.support.adapters import names_of
from tests.support.polling import HANGS

URLS = "ws://one:1", "ws://two:2", "ws://three:3"


def test_the_demos_configuration_names_links_and_profiles(tmp_path: Path) -> None:
    config = demo_config(Config(), URLS[0], 5, 2, kind=MIXED, folder=tmp_path, further=URLS[1:])
    assert (config.rosbridge.url, {name: link.url for name, link in config.links.items()}) == (
        URLS[0],
        {"ros2": URLS[1], "rmf": URLS[2]},
    )
    assert config.robots == [
        RobotEntry("robot_0", profile="oh_ressources", size=SIZE),
        RobotEntry("robot_1", profile="move_base", size=SIZE),
        RobotEntry("robot_2", link="ros2", profile="nav2", size=SIZE),
        RobotEntry("tiny/robot_3", link="rmf", profile="rmf", size=SIZE),
        RobotEntry("robot_4", profile="oh_ressources", size=SIZE),
    ]
    assert {name: profile.kind for name, profile in config.profiles.items()} == {kind: kind for kind in KINDS}
    assert config.profiles["nav2"].topics == {
        "mode": "/{robot}/mode",
        "floor": "/{robot}/floor",
        "map": "/{floor}/map",
    }
    assert not config.profiles["oh_ressources"].types  # on ROS 1, as usual
    assert all(Path(floor.graph).is_file() for floor in config.floors)


def test_a_mixed_demo_has_vehicles_on_a_broker_commanded_by_this_console(tmp_path: Path) -> None:
    with simulated(4, 1, kind=MIXED) as urls:
        assert [url.split(":")[0] for url in urls] == ["ws", "ws", "ws", "mqtt"]
        mixed = demo_config(Config(), urls[0], 4, 1, kind=MIXED, folder=tmp_path, further=urls[1:3])
        config = with_vehicles(mixed, urls[3])
    assert config.links["broker"] == Link(urls[3], role="master") and "ros2" in config.links
    assert config.robots[:4] == mixed.robots
    adapters = adapters_of(config)
    assert [(name, adapters[name].kind.name) for name in list(adapters)[4:]] == [
        ("agv_0", "vda5050"),
        ("agv_1", "vda5050"),
    ]


def test_the_demo_of_one_kind_has_one_profile_and_one_link(tmp_path: Path) -> None:
    config = demo_config(Config(), URLS[0], 2, 1, kind="move_base", folder=tmp_path)
    assert (config.profile.kind, config.profiles, config.links) == ("move_base", {}, {})
    assert config.robots == [RobotEntry("robot_0", size=SIZE), RobotEntry("robot_1", size=SIZE)]
    assert config.floors[0].graph == str(tmp_path / "graph.geojson")
    other = demo_config(Config(), URLS[0], 2, 1, kind="oh_ressources", folder=tmp_path)
    assert other.floors[0].graph == "" and other.profile.topics["paused"] == "/{robot}/paused"


def test_the_demo_has_no_programs_of_a_real_site() -> None:
    real = Config(programs=[ProgramEntry("bridge", unit="rosbridge.service")])
    assert demo_config(real, URLS[0], 1, 1).programs == []


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
        async with asyncio.timeout(HANGS):  # at its own pace a robot drives an order for half a minute
            while json.loads(await client.recv())["msg"]["last_order_id"] < 3:
                pass


def test_the_demos_configuration_names_the_types_of_ros_2() -> None:
    server = RosbridgeServer(OhFleet(1, 1), dialect=ROS2)
    names = names_of(demo_config(Config(path=Path("c.toml")), server.url, 1, 1, "2").profile)
    published = VOCABULARY.topics.keys() - {
        "goal",
        "goal_cancel",
        "initial_pose",
        "path",
        "drive",
        "graph_save",
        "labels_save",
    }
    for key in published:
        assert names.type(key) == server.bridge.services.types[names.topic(key, "robot_0", "floor_0")]
    for key in VOCABULARY.services.keys() - {"localise", "settle", "map_pose_graph"}:
        assert names.service_type(key) == server.bridge.services.offered[names.service(key, "robot_0")].name

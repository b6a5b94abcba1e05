"""`fleet-tui config init` where robots have Nav2, alone or beside others."""

import tomllib
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest

from fleet_tui.config.load import read
from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.config_text import render
from fleet_tui.links.discovery.recognition import discover
from fleet_tui.robots.discovery import Listed
from fleet_tui.simulator.nav2.fleet import Nav2Fleet
from fleet_tui.simulator.ros.ros2 import ROS2
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import run
from tests.support.site_faults import renamed

ODOM, AMCL = "nav_msgs/msg/Odometry", "geometry_msgs/msg/PoseWithCovarianceStamped"
BATTERY, MAP, TEXT = "sensor_msgs/msg/BatteryState", "nav_msgs/msg/OccupancyGrid", "std_msgs/msg/String"
ONE = {"/tb1/odom": ODOM, "/tb1/amcl_pose": AMCL, "/tb1/battery_state": BATTERY, "/map": MAP}
BLOCKED = {"/tb1/collision_monitor_state": "nav2_msgs/msg/CollisionMonitorState"}
QUEUE = {"/amr/queue": "oh_ressources/msg/ActionQueue", "/amr/ground/graph": "oh_ressources/msg/Graph"}
DRIVES = ("/tb1/navigate_to_pose", "/tb1/follow_waypoints")


async def serving(floors: int) -> AsyncIterator[RosbridgeServer]:
    server = RosbridgeServer(Nav2Fleet(2, floors, seed=1, quiet=True), dialect=ROS2)
    await server.start()
    yield server
    await server.stop()


@pytest.fixture
async def nav2() -> AsyncIterator[RosbridgeServer]:
    async for server in serving(1):
        yield server


@pytest.fixture
async def two_floors() -> AsyncIterator[RosbridgeServer]:
    async for server in serving(2):
        yield server


async def init(server: RosbridgeServer, folder: Path) -> dict[str, Any]:
    """The config of what the server has, which the program itself checks."""
    done = await run(folder, "config", "init", "--from-live", server.url, "--output", "config.toml")
    assert (done.code, done.out) == (0, ""), done.err
    checked = await run(folder, "check")
    assert checked.code == 0, checked.err
    return tomllib.loads((folder / "config.toml").read_text())


async def test_a_usual_fleet_needs_but_its_kind(nav2: RosbridgeServer, tmp_path: Path) -> None:
    config = await init(nav2, tmp_path)
    assert config.pop("rosbridge") == {"url": nav2.url}
    assert config == {
        "floors": [{"name": "floor_0"}],
        "robots": [{"name": "robot_0"}, {"name": "robot_1"}],
        "profile": {"kind": "nav2"},
    }
    text = (tmp_path / "config.toml").read_text()
    assert '# graph = "maps/floor_0.geojson"' in text and "the live map is used" in text
    # rosapi of ROS 2 dies of some questions, and nothing was commanded.
    assert nav2.bridge.services.rosapi_alive and not nav2.bridge.services.calls


async def test_other_names_and_a_battery_by_its_type(nav2: RosbridgeServer, tmp_path: Path) -> None:
    for robot in ("robot_0", "robot_1"):
        renamed(nav2, f"/{robot}/battery_state", f"/{robot}/platform/bms")
        renamed(nav2, f"/{robot}/odom", f"/{robot}/odometry/filtered")
    config = await init(nav2, tmp_path)
    topics = {"odometry": "/{robot}/odometry/filtered", "battery": "/{robot}/platform/bms"}
    assert config["profile"] == {"kind": "nav2", "topics": topics}


async def test_floors_have_a_map_each(two_floors: RosbridgeServer, tmp_path: Path) -> None:
    config = await init(two_floors, tmp_path)
    assert [floor["name"] for floor in config["floors"]] == ["floor_0", "floor_1"]
    assert config["profile"]["topics"] == {"map": "/{floor}/map", "floor": "/{robot}/floor"}


def made(listed: Listed, folder: Path) -> dict[str, Any]:
    text = render(Link(), discover(listed), {})
    (folder / "made.toml").write_text(text)
    assert read(folder / "made.toml")[1] == [], text
    return tomllib.loads(text)


def test_two_kinds_behind_one_bridge(tmp_path: Path) -> None:
    config = made(Listed({**ONE, **BLOCKED, **QUEUE}, {}, DRIVES), tmp_path)
    assert config["robots"] == [
        {"name": "amr", "floors": ["ground"]},
        {"name": "tb1", "profile": "nav2", "floors": ["floor_0"]},
    ]
    assert config["profiles"] == {"nav2": {"kind": "nav2"}}
    assert "kind" not in config["profile"]


def test_a_robot_of_the_sources_stack_that_drives_with_nav2_is_one_robot(tmp_path: Path) -> None:
    both = {topic.replace("/amr/", "/tb1/"): type_ for topic, type_ in QUEUE.items()} | ONE
    assert list(discover(Listed(both, {}, DRIVES))) == ["oh_ressources"]


def test_a_robot_without_a_namespace(tmp_path: Path) -> None:
    bare = {topic.replace("/tb1", ""): type_ for topic, type_ in {**ONE, **BLOCKED}.items()}
    config = made(Listed(bare, {}, ("/navigate_to_pose", "/follow_waypoints", "/backup")), tmp_path)
    assert config["robots"] == [{"name": "robot_0"}]
    profile = config["profile"]
    assert profile["topics"] == {
        "odometry": "/odom",
        "pose": "/amcl_pose",
        "battery": "/battery_state",
        "blocked": "/collision_monitor_state",
        "plan": "/plan",
        "initial_pose": "/initialpose",
        "scan": "/scan",
        "drive": "/cmd_vel",
        "camera": "/camera/image_raw/compressed",
    }
    assert profile["actions"]["navigate_to_pose"] == "/navigate_to_pose"
    services = profile["services"]
    assert services["is_active"] == "/lifecycle_manager_navigation/is_active"
    assert services["settle"] == "/request_nomotion_update"


def test_guesses_give_way_to_what_is_certain() -> None:
    dock = {"/tb1/detected_dock_pose": "geometry_msgs/msg/PoseStamped"}
    stray = {"/camera/pose": "geometry_msgs/msg/PoseStamped"}
    found = discover(Listed({**ONE, **dock, **stray}, {}, DRIVES))
    assert {kind: list(one.robots) for kind, one in found.items()} == {"nav2": ["tb1"]}

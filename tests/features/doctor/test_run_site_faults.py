"""For each planted fault the doctor's first complaint is its true cause: as docs/doctor.md promises."""

import asyncio
import json
import re
from collections.abc import Callable
from contextlib import AbstractAsyncContextManager
from functools import partial
from pathlib import Path
from typing import Any

import msgspec
import pytest
from websockets.asyncio.client import connect

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.schema import Config, Link
from fleet_tui.console.demo import demo_config
from fleet_tui.features.doctor.run import doctor
from fleet_tui.links.rosbridge.probes import OF_NODE
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.simulator.graph_files import write_graphs
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.nav2.navigation import NODES
from fleet_tui.simulator.ros.filling import ServiceType
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.driven_time import TIME
from tests.support.site_faults import (
    NAV2_PLANTS,
    PLANTS,
    ROS_2_PLANTS,
    elsewhere_on_the_server,
    mute_server,
    other_websocket,
    renamed,
    tls_server,
    web_server,
)
from tests.support.watched_store import config_of

TIMEOUT = 25.0  # 9 are enough, but not on a busy machine
FALLS_BEHIND = "on ROS 2 a bridge that falls behind"
IS_ACTIVE = "/robot_0/lifecycle_manager_navigation/is_active"
GET_STATES = [f"/robot_0/{node}/get_state" for node in NODES]
TAKEN_TOO_EARLY = "on ROS 2 a floor topic that another client subscribed too early"
OTHER_SERVERS: dict[str, Callable[[Path], AbstractAsyncContextManager[str]]] = {
    "a web server instead of rosbridge": lambda folder: web_server(),
    "another url_path": lambda folder: elsewhere_on_the_server(),
    "a frozen bridge": lambda folder: mute_server(),
    "another WebSocket server": lambda folder: other_websocket(),
    "TLS where ws:// is configured": partial(tls_server, scheme="ws"),
    "an untrusted certificate": partial(tls_server, scheme="wss"),
}


def nav2_config(url: str, folder: Path) -> Config:
    """A config for a robot with Nav2, and the file with its graph."""
    (file,) = write_graphs(folder / "routes.geojson", 1)
    floors = [FloorEntry("floor_0", graph=str(file))]
    robots, profile = [RobotEntry("robot_0")], Profile(kind="nav2")
    return Config(rosbridge=Link(url), floors=floors, robots=robots, profile=profile)


def promised() -> dict[str, tuple[str, str]]:
    """From docs/doctor.md: what is planted, the first line that is not ok, the exit code."""
    text = (Path(__file__).parents[3] / "docs" / "doctor.md").read_text()
    rows = re.findall(r"^\| ([^|]+) \| `([^|]+)` \| (\d) \|$", text, re.MULTILINE)
    return {plant: (line, code) for plant, line, code in rows}


async def complaint(config: Config, within: float = TIMEOUT) -> tuple[str, int]:
    """The doctor's first finding that is not ok, and its exit code."""
    said = list[str]()
    code = await asyncio.to_thread(doctor, config, within, True, said.append)
    report: dict[str, Any] = json.loads("".join(said))
    assert report["exit_code"] == code
    wrong = [one for one in report["findings"] if one["verdict"] in ("warn", "fail")]
    failed = [one for one in wrong if one["verdict"] == "fail"]
    assert report["first"] == (failed[0] if failed else None)
    one = (failed or wrong)[0]
    words = f"{one['subject']} {one['check']}: {one['measured']} -> {one['remedy']}"
    return f"{'FAIL' if failed else 'warn'} {words}", code


def assert_as_promised(plant: str, line: str, code: int) -> None:
    wanted, wanted_code = promised()[plant]
    pattern = ".*".join(re.escape(part) for part in wanted.split("..."))
    assert re.match(pattern, line), f"{plant}: {line}"
    assert str(code) == wanted_code


@pytest.mark.parametrize("plant", PLANTS)
async def test_the_first_complaint_is_the_cause(server: RosbridgeServer, plant: str) -> None:
    config = PLANTS[plant](server, config_of(server.url, 2, 2))
    assert_as_promised(plant, *await complaint(config))
    # Nothing of it commands a robot.
    assert not server.bridge.services.calls
    called = {operation.get("service", "/rosapi/") for operation in server.bridge.received} - {*OF_NODE}
    assert all(service.startswith("/rosapi/") for service in called)
    assert {operation["op"] for operation in server.bridge.received} <= {"subscribe", "call_service"}
    # Nor spoils it a topic for others.
    asked = [operation for operation in server.bridge.received if operation["op"] == "subscribe"]
    assert all(server.bridge.services.types.get(one["topic"]) == one["type"] for one in asked)


@pytest.mark.parametrize("plant", ROS_2_PLANTS)
async def test_the_first_complaint_is_the_cause_on_ros_2(ros_2: RosbridgeServer, plant: str) -> None:
    config = ROS_2_PLANTS[plant](ros_2, demo_config(Config(), ros_2.url, 2, 2, "2"))
    has_rosapi = ros_2.bridge.services.rosapi_alive
    within = 9.0 if plant == FALLS_BEHIND else TIMEOUT  # its fault is that the time runs out
    assert_as_promised(plant, *await complaint(config, within))
    if has_rosapi:
        assert_harmless(ros_2)


async def test_nothing_is_wrong_with_a_fleet_of_ros_2(ros_2: RosbridgeServer) -> None:
    said = list[str]()
    config = demo_config(Config(), ros_2.url, 2, 2, "2")
    code = await asyncio.to_thread(doctor, config, TIMEOUT, False, said.append)
    assert (code, said[-1]) == (0, f"{len(said) - 1} ok")
    assert_harmless(ros_2)


@pytest.mark.parametrize("plant", NAV2_PLANTS)
async def test_the_first_complaint_is_the_cause_with_nav2(
    nav2: RosbridgeServer, tmp_path: Path, plant: str
) -> None:
    config = NAV2_PLANTS[plant](nav2, nav2_config(nav2.url, tmp_path))
    assert_as_promised(plant, *await complaint(config))
    assert_harmless(nav2, IS_ACTIVE, *GET_STATES)
    is_query = nav2.bridge.services.offered.get(IS_ACTIVE, ServiceType("", {})).name == "std_srvs/srv/Trigger"
    assert is_query or not nav2.bridge.services.calls


async def test_nothing_is_wrong_with_a_fleet_with_nav2(nav2: RosbridgeServer, tmp_path: Path) -> None:
    said = list[str]()
    config = nav2_config(nav2.url, tmp_path)
    code = await asyncio.to_thread(doctor, config, TIMEOUT, False, said.append)
    assert (code, said[-1]) == (0, f"{len(said) - 1} ok")
    assert_harmless(nav2, IS_ACTIVE)
    assert nav2.bridge.services.calls == [(IS_ACTIVE, {})]


async def test_a_volatile_pose_that_is_repeated_is_no_fault(nav2: RosbridgeServer, tmp_path: Path) -> None:
    play(nav2, [("volatile-pose", "robot_0")])
    said = list[str]()
    code = await asyncio.to_thread(doctor, nav2_config(nav2.url, tmp_path), TIMEOUT, False, said.append)
    assert (code, said[-1]) == (0, f"{len(said) - 1} ok")
    assert any("robot_0 pose: received without quality of service" in line for line in said)


async def test_a_remedy_names_the_table_of_the_robots_profile(nav2: RosbridgeServer, tmp_path: Path) -> None:
    renamed(nav2, "/robot_0/battery_state", "/robot_0/bms")
    config = msgspec.structs.replace(
        nav2_config(nav2.url, tmp_path),
        profile=Profile(),
        profiles={"amr": Profile(kind="nav2")},
        robots=[RobotEntry("robot_0", profile="amr")],
    )
    line, code = await complaint(config)
    assert code == 1 and '[profiles.amr.topics] battery = "/{robot}/bms"' in line


async def test_a_topic_of_an_action_is_in_no_list_and_not_missing(ros_2: RosbridgeServer) -> None:
    said = list[str]()
    config = demo_config(Config(), ros_2.url, 2, 2, "2")
    topics = {"paused": "/{robot}/navigate_to_pose/_action/status"}
    config = msgspec.structs.replace(config, profile=msgspec.structs.replace(config.profile, topics=topics))
    code = await asyncio.to_thread(doctor, config, TIMEOUT, False, said.append)
    assert code == 0
    assert any("skipped - robot_0 paused: action topic: not listed" in line for line in said)


async def test_a_topic_that_another_client_took_too_early(ros_2: RosbridgeServer) -> None:
    graph = "/robot_0/floor_0/graph"
    asked = {"op": "subscribe", "topic": graph, "type": ros_2.bridge.services.types[graph]}
    async with connect(ros_2.url) as early:
        await early.send(json.dumps(asked))
        line, code = await complaint(demo_config(Config(), ros_2.url, 2, 2, "2"))
    assert_as_promised(TAKEN_TOO_EARLY, line, code)


def assert_harmless(server: RosbridgeServer, *queries: str) -> None:
    """No robot was commanded, no topic spoiled for others, and rosapi not asked what kills it."""
    assert {service for service, _ in server.bridge.services.calls} <= {
        *queries
    } and server.bridge.services.rosapi_alive
    asked = [one["service"] for one in server.bridge.received if one["op"] == "call_service"]
    lists = ("topics", "services", "nodes", "action_servers", "get_ros_version", "get_time")
    of_names = ("publishers", "subscribers", "service_type", "service_node", "fleet_tui_heartbeat")
    assert set(asked) - {*queries, *OF_NODE} <= {f"/rosapi/{verb}" for verb in (*lists, *of_names)}
    # The bridge itself publishes its log: a wrong type spoils nothing there.
    subscribed = [
        one for one in server.bridge.received if one["op"] == "subscribe" and one["topic"] != "/rosout"
    ]
    # Of those of actions nobody tells how the bridge spells their types, without rosapi of none.
    is_silent = not {*asked}.isdisjoint(OF_NODE)
    hidden = [one for one in subscribed if is_silent or "/_action/" in one["topic"]]
    there = [one for one in hidden if one["topic"] in server.bridge.topics]
    assert all(same_type(server.bridge.topics[one["topic"]].type, one["type"]) for one in there)
    told = [one for one in subscribed if one not in hidden]
    assert all(server.bridge.services.types.get(one["topic"]) == one["type"] for one in told)


@pytest.mark.nightly
@pytest.mark.parametrize("plant", OTHER_SERVERS)
async def test_something_else_listens_there(plant: str, tmp_path: Path) -> None:
    # Ticks let five driven seconds pass within 20 ms; on a busy machine a TLS handshake takes longer.
    TIME.be_real()
    async with OTHER_SERVERS[plant](tmp_path) as url:
        config = msgspec.structs.replace(
            config_of("", 2, 2), rosbridge=Link(url), path=tmp_path / "config.toml"
        )
        assert_as_promised(plant, *await complaint(config))


def test_every_promise_is_planted() -> None:
    assert set(promised()) == {*PLANTS, *OTHER_SERVERS, *ROS_2_PLANTS, *NAV2_PLANTS, TAKEN_TOO_EARLY}


STOCK_LACKS = ("scan", "camera/image_raw/compressed", "collision_monitor_state", "plan")
SERVICES_STOCK_LACKS = (
    "map_saver/save_map",
    "slam_toolbox/serialize_map",
    "slam_toolbox/set_localization_mode",
    "route_server/set_route_graph",
    "request_nomotion_update",
)


async def test_a_stock_robot_lacks_nothing_that_nobody_configured(
    nav2: RosbridgeServer, tmp_path: Path
) -> None:
    services = nav2.bridge.services
    for end in STOCK_LACKS:
        del nav2.bridge.topics[f"/robot_0/{end}"], services.types[f"/robot_0/{end}"]
    for end in SERVICES_STOCK_LACKS:
        del services.offered[f"/robot_0/{end}"]
    services.offered["/robot_0/set_map"] = ServiceType("nav_msgs/srv/SetMap", {})  # amcl's: it saves none
    said = list[str]()
    config = msgspec.structs.replace(nav2_config(nav2.url, tmp_path), floors=[FloorEntry("floor_0")])
    code = await asyncio.to_thread(doctor, config, TIMEOUT, False, said.append)
    assert code == 0 and re.fullmatch(r"\d+ ok, 10 skipped", said[-1]), "\n".join(said)

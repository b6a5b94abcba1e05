"""`fleet-tui config init`: what a bridge has, as a configuration that works."""

import gzip
import json
import tomllib
from collections.abc import Mapping
from pathlib import Path

from fleet_tui.config.schema import Config
from fleet_tui.links.discovery.recognition import discover
from fleet_tui.robots.discovery import Discovery, Listed
from fleet_tui.robots.oh_ressources.vocabulary import VOCABULARY
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.cli import Ended, run
from tests.support.site_faults import PLANTS, only_listened_to, renamed, retyped

TOPICS, SERVICES = VOCABULARY.topics, VOCABULARY.services


def site_of(topics: Mapping[str, str], services: Mapping[str, str]) -> Discovery:
    """The result of discovery if all robots are of one kind."""
    (found,) = discover(Listed(topics, services)).values()
    return found


async def made(server: RosbridgeServer, folder: Path) -> Ended:
    """The config of what the server has, written, and checked by the program itself."""
    done = await run(folder, "config", "init", "--from-live", server.url, "--output", "config.toml")
    assert (done.code, done.out) == (0, ""), done.err
    assert done.err.startswith(f"{server.url}: 2 robots")
    assert "wrote config.toml. Next: " in done.err and done.err.endswith("fleet-tui check && fleet-tui\n")
    checked = await run(folder, "check")
    assert checked.code == 0, checked.err
    return await run(folder, "status", "--json")


async def test_a_usual_site_needs_no_editing(server: RosbridgeServer, tmp_path: Path) -> None:
    status = await made(server, tmp_path)
    report = json.loads(status.out)
    assert (status.code, report["attention"]) == (0, [])
    assert [robot["name"] for robot in report["robots"]] == ["robot_0", "robot_1"]
    config = tomllib.loads((tmp_path / "config.toml").read_text())
    assert [floor["name"] for floor in config["floors"]] == ["floor_0", "floor_1"]
    assert (await run(tmp_path, "doctor")).code == 0
    assert not server.bridge.services.calls


async def test_other_names_become_overrides(server: RosbridgeServer, tmp_path: Path) -> None:
    for robot in ("robot_0", "robot_1"):
        renamed(server, f"/{robot}/pose", f"/{robot}/amcl_pose")
        renamed(server, f"/{robot}/queue", f"/{robot}/tasks")
        retyped(server, f"/{robot}/battery", "std_msgs/Float64")
        for floor in ("floor_0", "floor_1"):
            renamed(server, f"/{robot}/{floor}/graph", f"/{robot}/{floor}/routes")
        names = server.bridge.services.offered
        names[f"/{robot}/halt_robot_pause"] = names.pop(f"/{robot}/Application_layout/Pause")
    status = await made(server, tmp_path)
    assert status.code == 0, status.out
    profile = tomllib.loads((tmp_path / "config.toml").read_text())["profile"]
    assert profile["topics"] == {
        "pose": "/{robot}/amcl_pose",
        "queue": "/{robot}/tasks",
        "graph": "/{robot}/{floor}/routes",
        "paused": "/{robot}/paused",
        "scan": "/{robot}/scan",
        "camera": "/{robot}/camera/image_raw/compressed",
        "initial_pose": "/{robot}/initialpose",
    }
    assert profile["types"] == {"battery": "std_msgs/Float64"}
    assert profile["services"] == {"pause": "/{robot}/halt_robot_pause"}


async def test_without_a_bridge_it_is_an_example_that_is_never_written_over(tmp_path: Path) -> None:
    printed = await run(tmp_path, "config", "init")
    (tmp_path / "printed.toml").write_text(printed.out)
    assert (await run(tmp_path, "check", "printed.toml")).code == 0
    assert "set the address of your rosbridge" in printed.err and "--output config.toml" in printed.err
    kept = await run(tmp_path, "config", "init", "--output", "printed.toml")
    assert kept.code == 1 and "overwrite with --force" in kept.err
    written = await run(tmp_path, "config", "init", "--output", "printed.toml", "--force")
    assert (written.code, written.out) == (0, "")
    assert "then type: fleet-tui check printed.toml && fleet-tui --config printed.toml" in written.err
    assert (await run(tmp_path, "config", "init", "--output", "no/such/folder.toml")).code == 1


async def test_by_force_no_link_that_others_could_have_made_is_written_through(tmp_path: Path) -> None:
    shared, victim = tmp_path / "shared", tmp_path / "victim"
    shared.mkdir()
    shared.chmod(0o757)
    victim.write_text("mine")
    (shared / "config.toml").symlink_to(victim)
    refused = await run(tmp_path, "config", "init", "--output", "shared/config.toml", "--force")
    assert refused.code == 1 and "a link that another user could have made" in refused.err
    assert victim.read_text() == "mine"


async def test_what_can_not_be_asked(server: RosbridgeServer, tmp_path: Path) -> None:
    dead = await run(tmp_path, "config", "init", "--from-live", "ws://127.0.0.1:9")
    assert dead.code == 3 and "connection refused" in dead.err
    wrong = await run(tmp_path, "config", "init", "--from-live", "http://x")
    assert wrong.code == 2 and "is not a rosbridge address" in wrong.err
    PLANTS["a rosapi with an internal error"](server, Config())
    failing = await run(tmp_path, "config", "init", "--from-live", server.url)
    assert failing.code == 1 and "error processing request: boom" in failing.err
    assert "start" not in failing.err.lower()
    PLANTS["a frozen rosapi"](server, Config())
    frozen = await run(tmp_path, "config", "init", "--from-live", server.url)
    assert frozen.code == 1 and "restart rosapi (" in frozen.err
    assert "restart rosbridge: it may be half dead" in frozen.err
    server.bridge.services.silent_services.clear()
    server.bridge.services.answers.clear()
    server.bridge.services.rosapi_alive = False
    mute = await run(tmp_path, "config", "init", "--from-live", server.url)
    assert "half dead" not in mute.err
    assert mute.code == 1 and "discovery needs rosapi" in mute.err and "start rosapi" in mute.err


def test_what_a_real_bridge_said() -> None:
    lines = (Path(__file__).parents[2] / "wire" / "rosapi-and-scan.jsonl").read_text().splitlines()
    answers = [json.loads(json.loads(line)["text"]) for line in lines if '"in"' in line]
    told = {answer["service"]: answer["values"] for answer in answers if answer["op"] == "service_response"}
    topics = told["/rosapi/topics"]
    services = dict.fromkeys(told["/rosapi/services"]["services"], "")
    site = site_of(dict(zip(topics["topics"], topics["types"], strict=True)), services)
    assert site.robots == {"robot_1": ["ground", "first"], "robot_2": ["ground", "first"]}
    assert (site.topics, site.types, site.services, site.notes) == ({"scan": "/{robot}/scan"}, {}, {}, {})
    assert site.live_maps == {"ground", "first"}


def test_what_a_real_bridge_of_ros_2_said() -> None:
    packed = (Path(__file__).parents[2] / "wire" / "ros2-rosapi.jsonl.gz").read_bytes()
    lines = gzip.decompress(packed).decode().splitlines()
    answers = [json.loads(json.loads(line)["text"]) for line in lines if '"in"' in line]
    told = {answer["service"]: answer["values"] for answer in answers if isinstance(answer["values"], dict)}
    listed = told["/rosapi/topics"]
    topics = dict(zip(listed["topics"], listed["types"], strict=True))
    order = "/robot_1/Application_layout/Execute_order"
    assert order in told["/rosapi/services"]["services"]
    actions = tuple(told["/rosapi/action_servers"]["action_servers"])
    found = discover(Listed(topics, {order: "oh_ressources/srv/ExecuteManualOrder"}, actions))
    site = found["oh_ressources"]
    assert site.robots == {"robot_1": ["ground", "upper"], "robot_2": ["ground", "upper"]}
    assert (site.topics, site.service_types) == ({}, {"order": "oh_ressources/srv/ExecuteManualOrder"})
    assert site.types == {
        "queue": "oh_ressources/msg/ActionQueue",
        "graph": "oh_ressources/msg/Graph",
        "labels": "oh_ressources/msg/LabeledVertices",
    }
    nav2 = found["nav2"]
    assert list(nav2.robots) == ["tb1", "tb2", "tb3"] and nav2.types == {}


async def test_a_site_of_ros_2_needs_no_editing(ros_2: RosbridgeServer, tmp_path: Path) -> None:
    status = await made(ros_2, tmp_path)
    assert status.code == 0, status.out
    profile = tomllib.loads((tmp_path / "config.toml").read_text())["profile"]
    assert profile["types"]["queue"] == "oh_ressources/msg/ActionQueue" and len(profile["types"]) == 3
    assert profile["service_types"]["order"] == "oh_ressources/srv/ExecuteManualOrder"
    done = await run(tmp_path, "doctor")
    assert done.code == 0 and "warn" not in done.out, done.out


async def test_what_nobody_publishes_is_not_proposed(server: RosbridgeServer, tmp_path: Path) -> None:
    for robot in ("robot_0", "robot_1"):
        renamed(server, f"/{robot}/pose", f"/{robot}/amcl_pose")
        retyped(server, f"/{robot}/amcl_pose", "geometry_msgs/PoseWithCovarianceStamped")
        server.bridge.services.types[f"/{robot}/goal_pose"] = "geometry_msgs/PoseStamped"
    only_listened_to(server, "/robot_0/goal_pose", "/robot_1/goal_pose")
    done = await run(tmp_path, "config", "init", "--from-live", server.url)
    assert done.code == 0 and "goal_pose" not in done.out
    assert 'pose = "..."' in done.out


def test_robots_under_one_roof_and_in_their_natural_order() -> None:
    names = [f"/site/robot_{n}" for n in (10, 9)]
    topics = {f"{name}/{key}": TOPICS[key][1] for name in names for key in ("pose", "queue")}
    topics |= {f"{names[0]}/cellar/graph": TOPICS["graph"][1], "/tags/pose": TOPICS["pose"][1]}
    assert site_of(topics, {}).robots == {"site/robot_9": [], "site/robot_10": ["cellar"]}

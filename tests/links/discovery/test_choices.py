"""Uncertain results of discovery: each is a choice, and the configuration follows it."""

import tomllib
from typing import Any

from fleet_tui.config.schema import Link
from fleet_tui.links.discovery.choices import Answers
from fleet_tui.links.discovery.recognition import claimed
from fleet_tui.links.discovery.site import DiscoveredSite
from fleet_tui.robots.discovery import Listed

POSE, AMCL = "geometry_msgs/msg/PoseStamped", "geometry_msgs/msg/PoseWithCovarianceStamped"
ODOM, MAP, BATTERY = "nav_msgs/msg/Odometry", "nav_msgs/msg/OccupancyGrid", "sensor_msgs/msg/BatteryState"
QUEUE, GRAPH = "oh_ressources/msg/ActionQueue", "oh_ressources/msg/Graph"
NAV2 = {"/amr/odom": ODOM, "/amr/amcl_pose": AMCL, "/amr/battery_state": BATTERY, "/map": MAP}
DRIVES = ("/amr/navigate_to_pose",)


def site(listed: Listed, frames: dict[str, str] | None = None, **answers: str) -> DiscoveredSite:
    return DiscoveredSite(Link("ws://site:9090"), claimed(listed), frames or {}, len(listed.topics))


def chosen(found: DiscoveredSite, answers: Answers) -> dict[str, Any]:
    """The configuration after these answers, which is that of its own text."""
    answered = DiscoveredSite(found.bridge, found.claims, found.frames, found.topics, answers)
    assert answered.config.robots
    return tomllib.loads(answered.text)


def test_a_usual_site_leaves_nothing_to_choose() -> None:
    found = site(Listed(NAV2, {}, DRIVES))
    assert (found.choices, found.lacks, found.summary) == ([], [], "1 robot (nav2), 1 floor")


def test_two_kinds_that_fit_one_robot() -> None:
    topics = NAV2 | {"/amr/queue": QUEUE, "/amr/pose": POSE, "/amr/ground/graph": GRAPH}
    found = site(Listed(topics, {}, DRIVES))
    choice = found.choices[0]
    assert (choice.options, choice.chosen) == (("oh_ressources", "nav2"), "oh_ressources")
    assert "kind of amr: oh_ressources, possibly nav2" in found.unclear[0]
    config = chosen(found, {choice.id: "nav2"})
    assert config["profile"]["kind"] == "nav2" and config["robots"] == [{"name": "amr"}]
    assert "profile" not in chosen(found, {choice.id: "oh_ressources"}).get("profile", {})


def test_several_pose_topics() -> None:
    topics = {name: type_ for name, type_ in NAV2.items() if type_ != AMCL}
    found = site(Listed(topics | {"/amr/global": AMCL, "/amr/other": AMCL}, {}, DRIVES))
    (choice,) = found.choices
    assert (choice.text, choice.options, choice.chosen) == (
        "topic of pose (nav2)",
        ("/{robot}/global", "/{robot}/other"),
        "",
    )
    config = chosen(found, {choice.id: "/{robot}/other"})
    assert config["profile"]["topics"]["pose"] == "/{robot}/other"


def test_no_pose_topic_is_said_unless_transforms_may_tell_the_place() -> None:
    topics = {name: type_ for name, type_ in NAV2.items() if type_ != AMCL}
    found = site(Listed(topics, {}, DRIVES))
    assert found.choices == [] and not found.lacks
    queue = site(Listed({"/r/queue": QUEUE, "/r/ground/graph": GRAPH}, {}))
    assert "no pose topic for oh_ressources robots" in queue.lacks[0]


def test_floors_that_nothing_tells() -> None:
    topics = {name: type_ for name, type_ in NAV2.items() if type_ != MAP}
    found = site(Listed(topics | {"/hall/map": MAP, "/roof/map": MAP}, {}, DRIVES))
    (choice,) = found.choices
    assert (choice.text, choice.options, choice.chosen) == ("floor of amr", ("hall", "roof"), "")
    config = chosen(found, {choice.id: "roof"})
    assert config["robots"] == [{"name": "amr", "floors": ["roof"]}]
    assert {floor["name"] for floor in config["floors"]} == {"hall", "roof"}
    assert "floors" not in chosen(found, {choice.id: ""})["robots"][0]


def test_frames_that_are_no_floors() -> None:
    topics = {"/r/queue": QUEUE, "/r/pose": POSE, "/r/hall/graph": GRAPH, "/r/roof/graph": GRAPH}
    found = site(Listed(topics, {}), {"r": "map_1"})
    (choice,) = found.choices
    assert (choice.text, choice.options, choice.chosen) == ("floor of frame map_1", ("hall", "roof"), "")
    floors = chosen(found, {choice.id: "roof"})["floors"]
    assert floors == [{"name": "hall"}, {"name": "roof", "frame_id": "map_1"}]

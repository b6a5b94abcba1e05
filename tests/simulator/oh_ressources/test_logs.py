"""The simulated robots say in words what happens to them, on the topics of ROS 1."""

import json
from typing import Any

import pytest

from fleet_tui.simulator.faults import parse_faults
from fleet_tui.simulator.kinds import play
from fleet_tui.simulator.logs import DIAGNOSTICS, Talk
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fleets import WALL

# genmsg's field lists of rosgraph_msgs/Log and diagnostic_msgs/DiagnosticStatus.
LOG_FIELDS = {"header", "level", "name", "msg", "file", "function", "line", "topics"}
STATUS_FIELDS = {"level", "name", "message", "hardware_id", "values"}


def world() -> OhFleet:
    return OhFleet(2, 1, seed=1, quiet=True)


def said(fleet: OhFleet) -> list[tuple[int, str, str]]:
    talk = Talk()
    lines = [talk.say(WALL, *line) for line in fleet.lines()]
    assert all(set(line) == LOG_FIELDS for line in lines)
    return [(line["level"], line["name"], line["msg"]) for line in lines]


def test_nothing_is_said_while_nothing_happens() -> None:
    it = world()
    assert said(it) == []
    it.step(1.0)
    assert said(it) == []


def test_an_order_from_its_arrival_to_its_end() -> None:
    it = world()
    said(it)
    robot = it.robots["robot_0"]
    start, end = list(robot.floor.labels)[:2]
    robot.take(start, end, 1)
    assert (2, "/robot_0/planner", f"took order 1: {start} -> {end}") in said(it)
    subscriptions = []
    for _ in range(3000):
        it.step(0.1)
        subscriptions += said(it)
    assert subscriptions.count((1, "/robot_0/navigation", f"at vertex {end}")) == 1
    assert [words for _, node, words in subscriptions if "navigation" not in node] == [
        "working on order 1",
        "cargo is on board",
        "order 1 has left the queue",
        "cargo is unloaded",
    ]


def health(it: OhFleet) -> list[dict[str, Any]]:
    told = json.loads(RosbridgeServer(it).bridge.topics[DIAGNOSTICS].payload(WALL).json)["status"]
    assert isinstance(told, list)
    return told


@pytest.mark.parametrize(
    ("fault", "level", "words", "part", "broken"),
    [
        ("obstacle", 4, "obstacle in front", "laser", 1),
        ("paused", 4, "brakes on", "drive", 0),
        ("battery", 4, "charging soon", "battery", 2),
    ],
)
def test_planted_faults_are_spoken_of(fault: str, level: int, words: str, part: str, broken: int) -> None:
    it = world()
    said(it)
    play(RosbridgeServer(it), parse_faults(f"{fault}:robot_1", it.robots))
    it.step(0.1)
    ((heard_level, node, subscriptions),) = said(it)
    assert (heard_level, node) == (level, f"/robot_1/{part}") and words in subscriptions
    parts = {one["name"]: one for one in health(it)}
    assert all(set(one) == STATUS_FIELDS for one in parts.values())
    assert parts[f"robot_1: {part}"]["level"] == broken
    assert parts[f"robot_0: {part}"]["level"] == 0


def test_who_is_silent_says_nothing() -> None:
    it = world()
    said(it)
    robot = it.robots["robot_0"]
    robot.silence, robot.paused = 60.0, True
    assert said(it) == []
    assert {one["name"].partition(":")[0] for one in health(it)} == {"robot_1"}

"""Recordings of real bridges as the oracle: on an ordinary site nothing is late, silent or old."""

import json
from collections.abc import Iterator
from typing import Any

import pytest

from fleet_tui.config.entries import FloorEntry, RobotEntry
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config, Link
from fleet_tui.config.start import initial_state
from fleet_tui.model.events import GridReceived
from fleet_tui.model.fleet import FleetState
from fleet_tui.robots.adapter import Feed, Limit
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.reading import FrameReader
from fleet_tui.situation.facts import BAD_DATA, BEHIND, LATE_LINK, SILENT
from fleet_tui.situation.links import behind, late_link
from fleet_tui.situation.robots import absence, bad_data, silent
from fleet_tui.text.errors import WireError
from tests.support.fleets import LINK, T0, WIRE, link_up, recording, reduced, tick

ROBOT = "robot_1"
BLAME = {fact.name for fact in (BAD_DATA, BEHIND, LATE_LINK, SILENT)}
ROBOTS = {"robot_1": "oh_ressources", "robot_2": "oh_ressources", "tb1": "nav2", "tb2": "nav2", "tb3": "nav2"}
LIVE = ("/pose", "/battery", "/cargo", "/obstacle", "/queue", "/odom", "/feedback")
"""Topics that are signs of life: asked for by the console, and not latched."""
LIVE_FOR = 3.0
"""Seconds after a message for which its robot surely is no silent one."""
UNHEARD = {
    "map-cbor.jsonl.gz": "one map",
    "map-json.jsonl.gz": "one map",
    "ros2-map-cbor.jsonl.gz": "one map",
    "ros2-map-json.jsonl.gz": "one map",
    "ros2-map-png.jsonl.gz": "one map",
    "ros2-actions.jsonl.gz": "goals and their answers only",
    "ros2-badjson.jsonl.gz": "requests that are no JSON, planted by the client",
    "ros2-fragments.jsonl.gz": "one answer in fragments",
    "ros2-globs.jsonl.gz": "topics of no robot, one of them not allowed",
    "ros2-publish.jsonl.gz": "what a probe heard, of no robot",
    "ros2-qos.jsonl.gz": "topics of no robot",
    "ros2-restart-with-qos.jsonl.gz": "one latched graph",
    "ros2-rosapi-types.jsonl.gz": "answers of rosapi only",
    "ros2-rosapi.jsonl.gz": "answers of rosapi only",
    "ros2-services.jsonl.gz": "answers of services only",
    "rosapi-and-scan.jsonl": "scans, which only a view of them asks for",
    **{path.name: "a robot without a namespace" for path in (*WIRE.glob("nav2-*"), *WIRE.glob("ros1-*"))},
}
"""Recordings in which no robot speaks, with what is in them instead."""


def no_map(_profile: Profile, _feed: Feed, _payload: bytes) -> GridReceived:
    raise WireError("no map here")


def replayed(name: str, *robots: str) -> Iterator[tuple[float, dict[str, Any], FleetState]]:
    """Each frame that a bridge sent, by its time, and the state after it."""
    config = Config(
        rosbridge=Link("ws://site:9090"),
        floors=[FloorEntry("ground"), FloorEntry("first")],
        robots=[RobotEntry(robot, profile=ROBOTS[robot]) for robot in robots],
    )
    adapters = adapters_of(config)
    reader = FrameReader(LINK, Limit(64.0, ""), adapters, feeds_of(config, adapters, LINK), no_map, print)
    state = reduced(initial_state(config, T0), link_up(T0))
    ticked = T0
    for line in recording(name):
        at = T0 + line["t"]
        while ticked < at:
            state, ticked = reduced(state, tick(ticked)), ticked + 0.1
        if line["dir"] == "out" or "text" not in line:
            continue
        read = reader.read(line["text"].encode(), False, at)
        state = reduced(state, *(read if isinstance(read, tuple) else ()), tick(at))
        yield line["t"], json.loads(line["text"]) if line["text"].startswith("{") else {}, state


def speaker(frame: dict[str, Any]) -> str:
    """The robot of which a frame is a sign of life, empty if of none."""
    topic = str(frame.get("topic", ""))
    if not topic.endswith(LIVE):
        return ""
    return next((robot for robot in ROBOTS if topic.startswith(f"/{robot}/")), "")


def blamed(state: FleetState) -> set[tuple[str, str]]:
    """What is blamed now, as a fact or as an alarm, and for what."""
    facts = [late_link(state, state.links[LINK]), behind(state), bad_data(state, state.links[LINK])]
    facts += [find(state, robot) for robot in state.robots.values() for find in (silent, bad_data)]
    alarms = {alarm.key for alarm in state.alarms if alarm.holds}
    return {(fact.source, fact.kind.name) for fact in facts if fact} | {
        key for key in alarms if key[1] in BLAME
    }


@pytest.mark.parametrize("name", sorted(path.name for path in WIRE.iterdir() if path.name not in UNHEARD))
def test_on_no_recording_is_anything_blamed_that_is_well(name: str) -> None:
    heard: dict[str, list[float]] = {}
    for at, frame, state in replayed(name, *ROBOTS):
        if robot := speaker(frame):
            heard.setdefault(robot, []).append(at)
        # The recording client asks only for some topics, and not of all robots: the others are silent to it.
        # A first message may be old: nothing dates it.
        speaking = {robot for robot, times in heard.items() if len(times) > 1 and at - times[-1] < LIVE_FOR}
        assert blamed(state) <= {(robot, SILENT.name) for robot in ROBOTS if robot not in speaking}, at
    assert heard


@pytest.mark.parametrize("name", UNHEARD)
def test_recordings_are_left_out_only_if_no_robot_speaks_in_them(name: str) -> None:
    assert not any(speaker(frame) for _, frame, _ in replayed(name, *ROBOTS)), UNHEARD[name]


def test_a_real_robot_is_online_and_its_pose_fresh_from_its_second_message_on() -> None:
    poses, at = 0, 0.0
    for at, frame, state in replayed("telemetry-and-orders.jsonl", ROBOT):
        poses += frame.get("topic") == f"/{ROBOT}/pose"
        robot = state.robots[ROBOT]
        fact = absence(state, robot)
        assert not blamed(state) and (fact is None or fact.kind is not BAD_DATA)
        if poses >= 2 and at < 18.0:
            assert state.is_online(robot) and state.is_fresh(robot, "pose"), at
            assert robot.pose is not None and T0 + at - robot.pose.at < 0.5
    assert poses > 100

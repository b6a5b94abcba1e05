"""Reports of the robots of the source, from recordings of a real bridge and as bad as it can be."""

import base64
import json
import math
from typing import Any

import cbor2
import msgspec
import pytest

from fleet_tui.config.entries import DEFAULT_LINK, FloorEntry, RobotEntry
from fleet_tui.config.fleet import adapters_of, feeds_of
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.model import events
from fleet_tui.model.commands import Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Role
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.operations import Publish, ServiceResponse, decode, decode_cbor
from fleet_tui.state.reducer import apply
from fleet_tui.text.errors import WireError
from tests.support.adapters import adapter_of, event_of
from tests.support.changed import changed
from tests.support.fleets import order, order_queue, place_order, recording

ROBOT = "robot_1"
UNIT = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
STILL = {"position": {"x": 1.0, "y": 2.0, "z": 0.0}, "orientation": UNIT}
POSE = {"header": {"stamp": {"secs": 5, "nsecs": 0}, "frame_id": "ground"}, "pose": STILL}
METADATA = {"resolution": 0.05, "width": 2, "height": 1, "origin": STILL}
ORDER = {"id": 1, "start": 0, "end": 7, "status": "W"}
QUEUE = {"request_id": 1, "last_order_id": 1, "robot_id": 1, "current_order_id": 1, "orders": [ORDER]}
GOOD: dict[str, dict[str, Any]] = {
    "pose": POSE,
    "queue": QUEUE,
    "obstacle": {"data": 4.2},
    "battery": {"data": 55.5},
    "cargo": {"data": True},
    "paused": {"data": True},
    "graph": {"vertices": [{"id": 0, "x": 1.0, "y": 2.0, "type": "way"}], "edges": []},
    "labels": {"vertices": [{"label": "Base", "vertex_id": 0}]},
    "map_metadata": METADATA,
    "map": {"info": METADATA, "data": [0, 100]},
}


def event(key: str, msg: object, profile: Profile | None = None) -> events.Event:
    return event_of(adapter_of(profile), key, msg, ROBOT, "ground", 10.0)


def two_floors() -> tuple[Config, FleetState]:
    floors = [FloorEntry("ground"), FloorEntry("first")]
    config = Config(floors=floors, robots=[RobotEntry(ROBOT)])
    return config, initial_state(config, 1.0)


def replay(lines: list[dict[str, Any]]) -> FleetState:
    """The state after every recorded frame, by the names that the config derives."""
    config, state = two_floors()
    adapters = adapters_of(config)
    feeds = {feed.address: feed for feed in feeds_of(config, adapters, DEFAULT_LINK)}
    for line in lines:
        text, binary = line.get("text", "").encode(), base64.b64decode(line.get("binary", ""))
        if line["dir"] == "in":
            operation = decode(text) if text else decode_cbor(binary)
            if isinstance(operation, Publish):
                for fact in adapters[ROBOT].read(feeds[operation.topic], operation.msg, 100.0 + line["t"]):
                    state = apply(state, fact)
    return state


def test_the_recording_ends_in_the_state_it_tells() -> None:
    state = replay(recording("telemetry-and-orders.jsonl"))
    robot = state.robots[ROBOT]
    assert (robot.faults, robot.last_fault) == (0, "")
    assert robot.pose is not None and robot.battery is not None and robot.obstacle is not None
    assert (robot.pose.value.x, robot.pose.value.y) == (1.0, 0.5)
    assert robot.pose.value.yaw == pytest.approx(-math.pi / 2)
    assert robot.floor == "first"
    assert robot.battery.value == pytest.approx(87.09254)
    assert (robot.obstacle.value, robot.has_cargo, robot.paused) == (0.0, False, None)
    orders = (order(4, 105, 8, "W"), order(5, 105, 2, "Q"))
    assert robot.orders == order_queue(5, 4, *orders, request_id=4)
    assert [robot.name_of(id_) for id_ in ("105", "8", "2", "9999")] == ["105", "8", "Lab ground", None]


def test_the_recording_brings_both_floors() -> None:
    maps = replay(recording("telemetry-and-orders.jsonl")).robots[ROBOT].maps
    assert {floor: len(robot_map.labels) for floor, robot_map in maps.items()} == {"ground": 7, "first": 7}
    ground = maps["ground"]
    assert ground.graph is not None and ground.frame is not None
    assert (len(ground.graph.vertices), ground.graph.vertices["4"].role) == (15, Role.ELEVATOR)
    assert ground.graph.vertices["10"].role is Role.DOCKING
    assert ground.graph.vertices["0"].role is ground.graph.vertices["1"].role is Role.PLAIN
    assert ground.graph.path("0", "7") in (tuple("0127"), tuple("0567"))
    assert (ground.frame.width, ground.frame.height, ground.frame.origin) == (400, 300, Pose(-1.0, -2.0))
    assert maps["first"].frame is None


def test_a_map_looks_the_same_however_it_came() -> None:
    text, binary = (
        replay(recording(name)).robots[ROBOT].maps["ground"].grid
        for name in ("map-json.jsonl.gz", "map-cbor.jsonl.gz")
    )
    assert text is not None and binary is not None and text.frame == binary.frame
    assert all((one == other).all() for one, other in zip(text.levels, binary.levels, strict=True))
    recorded = json.loads(recording("map-json.jsonl.gz")[1]["text"])["msg"]["data"]
    assert (text.levels[0] == 2).sum() == recorded.count(100)
    assert text.levels[0][299].tolist() == [{-1: 0, 0: 1, 100: 2}[cell] for cell in recorded[:400]]


def test_the_recorded_answers_are_judged_by_their_words() -> None:
    answers = {}
    for line in recording("telemetry-and-orders.jsonl"):
        operation = decode(line["text"].encode()) if line["dir"] == "in" else None
        if isinstance(operation, ServiceResponse):
            answers[operation.id] = adapter_of().outcome(
                place_order(ROBOT, 0, 7), operation.values, operation.result
            )
    refused = {id_: detail for id_, (outcome, detail) in answers.items() if outcome is Stage.REFUSED}
    assert refused.keys() == {"c6", "c7", "c8", "c9"}
    assert refused["c6"] == "REJECTED: no vertex 9999"
    assert "requires a int32" in refused["c7"] and "does not exist" in refused["c9"]
    assert answers["c5"] == (Stage.ACCEPTED, "cancelled 2")
    assert answers["c3"] == (Stage.ACCEPTED, "paused")


def test_good_messages_are_the_facts_they_tell() -> None:
    assert event("pose", POSE) == events.PoseReported(ROBOT, 10.0, Pose(1.0, 2.0, 0.0), "ground", 5.0)
    queue = order_queue(1, 1, order(1, 0, 7, "W"), request_id=1)
    assert event("queue", QUEUE) == events.QueueReported(ROBOT, 10.0, queue)
    assert event("obstacle", {"data": 4.2}) == events.ObstacleReported(ROBOT, 10.0, 4.2)
    assert event("battery", {"data": 55.5}) == events.BatteryReported(ROBOT, 10.0, 55.5)
    assert event("cargo", {"data": True}) == events.CargoReported(ROBOT, 10.0, True)
    assert event("paused", {"data": False}) == events.PausedReported(ROBOT, 10.0, False)
    assert event("labels", GOOD["labels"]) == events.LabelsReceived(ROBOT, "ground", {"0": "Base"})


NUMBERS = ["pose:pose.position.x", "pose:pose.orientation.w", "battery:data", "obstacle:data"]
NUMBERS += ["map_metadata:resolution", "map_metadata:origin.position.y"]


@pytest.mark.parametrize("bad", [None, "7", True, [], math.nan, math.inf, -math.inf, ...], ids=repr)
@pytest.mark.parametrize("place", NUMBERS)
def test_a_bad_number_is_a_bad_message(place: str, bad: object) -> None:
    key, _, path = place.partition(":")
    event(key, GOOD[key])
    with pytest.raises(WireError):
        event(key, changed(GOOD[key], path, bad))
    if bad is not ... and bad == bad and bad not in (math.inf, -math.inf):
        with pytest.raises(WireError):
            event(key, msgspec.Raw(json.dumps(changed(GOOD[key], path, bad)).encode()))


@pytest.mark.parametrize(
    ("key", "path", "bad"),
    [
        ("pose", "header.frame_id", None),
        ("pose", "header", ...),
        ("pose", "header.stamp.secs", 10**30),
        ("battery", "data", -0.1),
        ("battery", "data", 102.0),
        ("obstacle", "data", -1.0),
        ("cargo", "data", 1),
        ("cargo", "data", "true"),
        ("queue", "current_order_id", ...),
        ("queue", "last_order_id", 2**31),
        ("queue", "orders", None),
        ("queue", "orders", [{**ORDER, "id": "one"}]),
        ("queue", "orders", [ORDER, 7]),
        ("queue", "orders", [{**ORDER, "end": None}]),
        ("graph", "vertices", {}),
        ("graph", "edges", ...),
        ("labels", "vertices", [{"label": 7, "vertex_id": 0}]),
        ("map_metadata", "width", 0),
        ("map_metadata", "height", 2.5),
        ("map_metadata", "width", 10**12),
        ("map_metadata", "resolution", 0.0),
        ("map", "data", [0]),
        ("map", "data", [0, 1000]),
        ("map", "data", cbor2.CBORTag(72, b"\0\0\0")),
        ("map", "info.width", 3),
    ],
)
def test_each_kind_of_bad_message_is_refused(key: str, path: str, bad: object) -> None:
    event(key, GOOD[key])
    with pytest.raises(WireError) as refused:
        event(key, changed(GOOD[key], path, bad))
    assert str(refused.value)


def test_a_quaternion_of_length_zero_turns_no_robot_but_leaves_a_map_as_it_is() -> None:
    nothing = dict.fromkeys("xyzw", 0.0)
    with pytest.raises(WireError, match="orientation"):
        event("pose", changed(POSE, "pose.orientation", nothing))
    got = event("map_metadata", changed(METADATA, "origin.orientation", nothing))
    assert isinstance(got, events.FrameReceived) and got.frame.origin == Pose(1.0, 2.0, 0.0)

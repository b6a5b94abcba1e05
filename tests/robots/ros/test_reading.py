"""From a frame to its facts: counted, named where it is bad, and never raised."""

import json
from collections.abc import Sequence
from typing import Any

from fleet_tui.model.events import BatteryReported, Event, FrameRejected, GridReceived, MessageRejected
from fleet_tui.model.navigation_events import ErrorReported, OdometryReported, OriginReported
from fleet_tui.robots.adapter import Feed, Limit
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.reading import ROSOUT, FrameReader, StreamTaken
from fleet_tui.text.errors import WireError
from tests.support import nav2_adapter
from tests.support.adapters import adapter_of
from tests.support.fleets import R0

BATTERY = "/robot_0/battery"


def never(_profile: Profile, _feed: Feed, _payload: bytes) -> GridReceived:
    raise WireError("no map is that large")


def reader(warned: list[str] | None = None) -> FrameReader:
    adapter = adapter_of()
    warn = (warned if warned is not None else []).append
    feeds = list(adapter.feeds("robot_0", ["floor_0"]))
    return FrameReader(
        "rosbridge", Limit(64.0, "rosbridge.max_message_mb"), {"robot_0": adapter}, feeds, never, warn
    )


def said(topic: str, **msg: Any) -> bytes:
    return json.dumps({"op": "publish", "topic": topic, "msg": msg}).encode()


def read(it: FrameReader, payload: bytes) -> Sequence[Event]:
    found = it.read(payload, False, 5.0)
    assert isinstance(found, Sequence)
    return found


def test_a_message_is_its_facts_and_is_counted_on_its_topic() -> None:
    it = reader()
    assert read(it, said(BATTERY, data=80.0)) == (BatteryReported("robot_0", 5.0, 80.0),)
    assert it.counter.topics[BATTERY].last is not None
    assert read(it, said("/somebody/else", data=1)) == ()


def test_bad_data_names_its_topic_and_a_bad_frame_its_link() -> None:
    it = reader()
    (rejected,) = read(it, said(BATTERY, data="full"))
    assert isinstance(rejected, MessageRejected) and rejected.text.startswith(f"{BATTERY}: ")
    (broken,) = read(it, b"{")
    assert isinstance(broken, FrameRejected) and broken.link == "rosbridge"


def test_of_transforms_each_value_is_taken_as_often_as_poses_and_no_other_message_is_recorded() -> None:
    adapter = nav2_adapter.adapter()
    feeds = list(adapter.feeds("robot_0", ["floor_0"]))
    it = FrameReader("rosbridge", Limit(64.0, ""), {"robot_0": adapter}, feeds, never)
    found = [it.read(transform(n), False, n / 50) for n in range(50)]
    taken = [event for one in found if isinstance(one, tuple) for event in one]
    assert 8 <= sum(isinstance(event, OriginReported) for event in taken) <= 10
    assert 8 <= sum(isinstance(event, OdometryReported) for event in taken) <= 10
    assert sum(isinstance(one, StreamTaken) for one in found) == 50 - len(taken)


def transform(n: int) -> bytes:
    """A message of one of two publishers in turn."""
    parent, child = [("map", "odom"), ("odom", "base_link")][n % 2]
    moved = {"translation": {"x": 1.0, "y": 0.0, "z": 0.0}, "rotation": {"x": 0, "y": 0, "z": 0, "w": 1}}
    return said(
        "/tf", transforms=[{"header": {"frame_id": parent}, "child_frame_id": child, "transform": moved}]
    )


def test_words_of_the_bridge_are_logged_and_shown() -> None:
    warned = list[str]()
    (shown,) = read(reader(warned), b'{"op":"status","level":"error","msg":"no such topic"}')
    assert isinstance(shown, FrameRejected) and "no such topic" in shown.text
    assert warned == ["bridge (error): no such topic"]


def test_what_is_over_the_limit_is_named_with_the_key_that_lets_it_in() -> None:
    it = reader()
    (rejected,) = it.too_large(said(BATTERY, data=1.0)[:60], False, 70_000_000, 5.0)
    assert isinstance(rejected, MessageRejected)
    assert "70.0 MB exceeds the limit of 64 MB: raise rosbridge.max_message_mb" in rejected.text
    assert it.counter.dropped == 1
    (unknown,) = it.too_large(b"\x00", True, 70_000_000, 5.0)
    assert isinstance(unknown, FrameRejected)


def test_of_the_log_of_robots_only_their_errors_are_news_and_once() -> None:
    it = reader()
    line = {"level": 8, "name": "/robot_0/r", "msg": "lost", "header": {"stamp": {"secs": 1, "nsecs": 0}}}
    assert read(it, said(ROSOUT, **line | {"level": 4, "msg": "a warning"})) == ()
    assert read(it, said(ROSOUT, **line)) == (ErrorReported(R0, 5.0, "lost", stamp=1.0),)
    assert read(it, said(ROSOUT, **line)) == ()
    assert [one.text for one in it.counter.log] == ["a warning", "lost"]

"""The doctor's judgement of a robot and its topics: the true fault is named, with the line that mends it."""

from typing import Any

import pytest

from fleet_tui.features.doctor.causes import Cause
from fleet_tui.features.doctor.topics import robot_findings
from fleet_tui.links.discovery.facts import BridgeFacts
from fleet_tui.links.discovery.finding import Finding, Verdict
from tests.support.bridge_facts import mute, well, with_rosapi, with_topics, without
from tests.support.watched_store import config_of

CONFIG = config_of("ws://site:9090", 2)
WELL = well(CONFIG)
BATTERY, GRAPH = "/robot_0/battery", "/robot_0/floor_0/graph"


def judged(facts: BridgeFacts, *causes: Cause) -> dict[str, Finding]:
    return {one.check: one for one in robot_findings(CONFIG, CONFIG.robots[0], facts, causes)}


def test_all_is_well_with_a_robot_that_is_heard() -> None:
    found = judged(WELL)
    assert {one.verdict for one in found.values()} == {Verdict.OK}
    assert found["battery"].measured == "10.0 Hz, last 0.1 s ago, std_msgs/Float32, by /robot_0/driver"
    assert found["graph of floor_0"].measured.startswith("received 0.10 s after a late subscription")


@pytest.mark.parametrize(
    ("topic", "changes", "verdict", "words"),
    [
        ("battery", {"rate": 0.1}, Verdict.WARN, "slower than offline_after"),
        ("pose", {"rate": 2.0}, Verdict.WARN, "poses should arrive at about 10 Hz"),
        (
            "battery",
            {"faults": 3, "problem": "no data"},
            Verdict.FAIL,
            "/robot_0/battery unreadable: no data",
        ),
        ("graph", {"retried": True}, Verdict.WARN, "received only without quality of service"),
        ("graph", {"fragmented": 2e6}, Verdict.WARN, "only as JSON fragments (2.0 MB)"),
        ("paused", {"count": 0}, Verdict.FAIL, "no messages on /robot_0/paused in 5.0 s"),
        ("battery", {"count": 0}, Verdict.FAIL, "no messages on /robot_0/battery in 5.0 s"),
        ("battery", {"count": 0, "waited": 0.5}, Verdict.SKIPPED, "not checked: out of time"),
        ("graph", {"count": 0, "held_by": "/rosbridge"}, Verdict.FAIL, "another client subscribed before"),
    ],
)
def test_what_came_of_a_topic(topic: str, changes: dict[str, Any], verdict: Verdict, words: str) -> None:
    found = judged(with_topics(WELL, (f"robot_0/{topic}", f"robot_0/floor_0/{topic}"), **changes))
    one = found.get(topic) or found[f"{topic} of floor_0"]
    assert one.verdict is verdict and words in one.measured


def test_a_topic_that_is_not_published_has_the_line_that_names_it() -> None:
    types = without(WELL.rosapi.topics, BATTERY)
    gone = judged(mute(with_rosapi(WELL, topics=types), BATTERY))["battery"]
    assert gone.verdict is Verdict.FAIL and "correct [profile.topics] battery" in gone.remedy
    renamed = {**types, f"{BATTERY}_state": "std_msgs/Float32"}
    near = judged(mute(with_rosapi(WELL, topics=renamed), BATTERY))["battery"]
    assert near.remedy.startswith(f"did you mean {BATTERY}_state? Set [profile.topics] battery")
    unpublished = {**WELL.rosapi.publishers, BATTERY: ()}
    alone = judged(mute(with_rosapi(WELL, publishers=unpublished), BATTERY))["battery"]
    assert alone.measured == f"{BATTERY} has subscribers but no publisher"


def test_a_topic_of_another_type_and_one_of_two_publishers() -> None:
    other = judged(with_rosapi(WELL, topics={**WELL.rosapi.topics, BATTERY: "x/Y"}))["battery"]
    assert other.verdict is Verdict.FAIL and 'set [profile.types] battery = "x/Y"' in other.remedy
    both = {**WELL.rosapi.publishers, BATTERY: ("/a", "/b")}
    two = judged(with_rosapi(WELL, publishers=both))["battery"]
    assert (two.verdict, two.remedy) == (Verdict.WARN, "stop all but one of the 2 publishing nodes")


def test_a_robot_that_is_silent_or_not_there_is_told_once() -> None:
    found = judged(mute(WELL, *(one.topic for one in WELL.topics if one.wanted.robot == "robot_0")))
    assert (
        found["robot"].verdict is Verdict.FAIL and "published by /robot_0/driver" in found["robot"].measured
    )
    assert found["battery"].measured == "silent: see above"
    others = {name.replace("robot_0", "robot_O"): type_ for name, type_ in WELL.rosapi.topics.items()}
    gone = judged(mute(with_rosapi(WELL, topics=others, publishers={}), ""))
    assert gone["robot"].remedy.startswith("did you mean robot_O? Correct the name in robots[0].name")
    assert {one.verdict for check, one in gone.items() if check != "robot"} == {Verdict.SKIPPED}


def test_what_a_cause_explains_is_not_told_again() -> None:
    cause = Cause(Finding("", "", Verdict.FAIL, ""), "node /x silent", frozenset({BATTERY, GRAPH}))
    found = judged(mute(WELL, BATTERY, GRAPH), cause)
    for check in ("battery", "graph of floor_0"):
        assert (found[check].verdict, found[check].measured) == (Verdict.SKIPPED, "node /x silent: see above")
    assert found["pose"].verdict is Verdict.OK

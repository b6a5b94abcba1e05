"""Queries of rosapi: what is listed, by which ROS, and what a bad or missing answer costs."""

import math
import time

import pytest

from fleet_tui.links.discovery.facts import RosapiFacts
from fleet_tui.links.discovery.rosapi import (
    AT_ONCE_ROS1,
    ask_publishers,
    ask_service_types,
    ask_services,
    clock_ahead,
    look_around,
    subscribers,
)
from tests.support.asked_rosapi import AskedRosapi

TYPES = {"/a": "std_msgs/String", "/b": "std_msgs/Bool"}
ONE = {"topics": list(TYPES), "types": list(TYPES.values())}
FOREVER = math.inf


def rosapi(**more: object) -> AskedRosapi:
    found = {
        "topics": ONE,
        "services": {"services": ["/s"]},
        "nodes": {"nodes": ["/n"]},
        "get_ros_version": {"version": 1, "distro": "noetic"},
        **more,
    }
    return AskedRosapi(**{name: lambda _args, answer=answer: answer for name, answer in found.items()})


async def test_a_bridge_is_listed_with_its_ros() -> None:
    found = await look_around(rosapi().wire)
    assert (found.topics, found.services, found.nodes) == (TYPES, {"/s": None}, ("/n",))
    assert (found.ros, found.distro, found.problem, found.actions) == (1, "noetic", "", ())
    two = rosapi(
        get_ros_version={"version": 2, "distro": "jazzy"}, action_servers={"action_servers": ["/go"]}
    )
    assert (await look_around(two.wire)).actions == ("/go",)


@pytest.mark.parametrize(("spelling", "ros"), [("std_msgs/msg/String", 2), ("std_msgs/String", 1)])
async def test_an_old_rosapi_is_known_by_the_spelling_of_types(spelling: str, ros: int) -> None:
    old = rosapi(get_ros_version="does not exist", topics={"topics": ["/a"], "types": [spelling]})
    assert (await look_around(old.wire)).ros == ros


async def test_no_answer_and_an_error_are_problems() -> None:
    silent = rosapi()
    silent.deaf.add("topics")
    assert (await look_around(silent.wire)).is_silent
    silent.lost = "connection lost"
    assert (await look_around(silent.wire)).problem == "connection lost"
    assert (await look_around(AskedRosapi().wire)).is_absent


async def test_lists_that_are_none_are_empty() -> None:
    found = await look_around(
        rosapi(services="busy", nodes={"nodes": 7}, topics={"topics": [1], "types": None}).wire
    )
    assert (found.topics, found.services, found.nodes, found.problem) == ({}, {}, (), "")


async def test_publishers_are_asked_of_listed_topics_alone_and_few_at_once() -> None:
    topics = {f"/t{n}": "" for n in range(100)}
    wire, counted = AskedRosapi(publishers=lambda args: {"publishers": [f"{args['topic']}/node"]}), []
    facts = RosapiFacts(topics, publishers={"/old": ("/n",)})
    found = await ask_publishers(wire.wire, facts, [*topics, "/stranger"], FOREVER, lambda: counted.append(1))
    assert found.publishers == {"/old": ("/n",), **{name: (f"{name}/node",) for name in topics}}
    assert wire.most_open == 2 and len(counted) == len(wire.asked) == 100
    old = rosapi(publishers={"publishers": ["/n"]})
    await look_around(old.wire)
    await ask_publishers(old.wire, facts, topics, FOREVER)
    assert old.most_open == AT_ONCE_ROS1


async def test_no_more_than_two_questions_at_once_go_to_rosapi_before_its_version_is_known() -> None:
    asked = rosapi()
    await look_around(asked.wire)
    assert asked.most_open == 2


async def test_what_is_not_answered_or_not_in_time_stays_unknown() -> None:
    wire = AskedRosapi(publishers=lambda args: {"publishers": None if args["topic"] == "/a" else ["/n"]})
    facts = RosapiFacts(TYPES)
    assert (await ask_publishers(wire.wire, facts, TYPES, FOREVER)).publishers == {"/b": ("/n",)}
    assert (await ask_publishers(wire.wire, facts, TYPES, time.monotonic() - 1)).publishers == {}
    assert len(wire.asked) == 2


async def test_services_are_asked_for_their_types_and_nodes() -> None:
    wire = AskedRosapi(
        service_type=lambda _: {"type": "std_srvs/Trigger"}, service_node=lambda _: {"node": "/n"}
    )
    facts = RosapiFacts(services={"/s": None, "/other": None})
    found = await ask_services(wire.wire, facts, ["/s", "/stranger"], FOREVER)
    assert found.services == {"/s": "std_srvs/Trigger", "/other": None} and found.owners == {"/s": "/n"}
    wire.deaf.add("service_type")
    assert (await ask_service_types(wire.wire, facts, ["/s"], FOREVER)).services["/s"] == ""


async def test_subscribers_and_the_clock() -> None:
    wire = AskedRosapi(
        subscribers=lambda _: {"subscribers": ["/rosbridge"]},
        get_time=lambda _: {"time": {"secs": int(time.time()) + 60, "nsecs": 0}},
    )
    assert await subscribers(wire.wire, "/a", FOREVER) == ["/rosbridge"]
    ahead = await clock_ahead(wire.wire)
    assert ahead is not None and ahead == pytest.approx(60, abs=2)
    assert (
        await clock_ahead(AskedRosapi().wire) is None
        and await subscribers(AskedRosapi().wire, "/a", FOREVER) == []
    )

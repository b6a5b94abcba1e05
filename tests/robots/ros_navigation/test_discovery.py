"""Robots by their namespaces, their topics and their floors."""

import pytest

from fleet_tui.robots.discovery import Discovery, Listed
from fleet_tui.robots.nav2.vocabulary import VOCABULARY
from fleet_tui.robots.ros_navigation.discovery import (
    MAP,
    TEXT,
    find_floors,
    find_topic,
    namespaces,
    of_robots,
)

ODOM = "nav_msgs/msg/Odometry"


def test_namespaces_are_what_stands_before_the_name_and_may_have_parts() -> None:
    assert namespaces(["/a/b/odom", "/odom", "/c/odometry", "/codom"], ["odom"]) == {"a/b", ""}


def test_no_namespace_is_a_robot_only_where_there_is_no_other() -> None:
    assert of_robots({"", "r10", "r9"}) == ["r9", "r10"]
    assert of_robots({""}) == [""]


@pytest.mark.parametrize(
    ("spaces", "topics", "chosen"),
    [
        (["a"], {"/a/odom": ODOM}, None),
        (["a"], {"/a/wheels/odom": ODOM}, "/{robot}/wheels/odom"),
        ([""], {"/odom": ODOM}, "/odom"),
        (["a"], {"/b/odom": ODOM}, ""),
        (["a"], {}, ""),
    ],
)
def test_a_topic_is_named_where_it_is_not_the_usual_one(
    spaces: list[str], topics: dict[str, str], chosen: str | None
) -> None:
    found = Discovery()
    find_topic(found, "odometry", VOCABULARY, spaces, Listed(topics, {}))
    assert found.topics.get("odometry") == chosen
    assert bool(found.notes) == (chosen == "")


@pytest.mark.parametrize(
    ("topics", "floors", "template"),
    [
        ({"/map": MAP}, ["floor_0"], None),
        ({"/hall/map": MAP, "/roof/map": MAP}, ["hall", "roof"], "/{floor}/map"),
        ({"/a/map": MAP}, ["floor_0"], "/{robot}/map"),
        ({}, ["floor_0"], ""),
    ],
)
def test_floors_by_their_maps(topics: dict[str, str], floors: list[str], template: str | None) -> None:
    found = Discovery({"a": []})
    find_floors(found, ["a"], Listed(topics, {}))
    assert (found.robots["a"], found.topics.get("map")) == (floors, template)
    assert bool(found.live_maps) == bool(topics)


def test_which_floor_a_robot_is_on_is_asked_of_a_person_where_nothing_tells() -> None:
    maps = {"/hall/map": MAP, "/roof/map": MAP}
    told, untold = Discovery({"a": []}), Discovery({"a": []})
    find_floors(told, ["a"], Listed({**maps, "/a/current_floor": TEXT}, {}))
    assert told.topics["floor"] == "/{robot}/current_floor" and not told.notes
    find_floors(untold, ["a"], Listed(maps, {}))
    assert "no topic reports it" in untold.notes["topics"][0]

"""Transforms as places of robots: whose they are, and which count."""

import json
from typing import Any

import msgspec
import pytest

from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import OdometryReported, OriginReported, Place
from fleet_tui.robots.nav2.vocabulary import VOCABULARY
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros_navigation.transforms import read_places
from fleet_tui.text.errors import WireError

NO_TURN = {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}


def transform(parent: str, child: str, x: float = 1.0, turn: Any = NO_TURN) -> dict[str, Any]:
    moved = {"translation": {"x": x, "y": 0.0, "z": 0.1}, "rotation": turn}
    header = {"frame_id": parent, "stamp": {"sec": 7, "nanosec": 0}}
    return {"header": header, "child_frame_id": child, "transform": moved}


def read(
    *transforms: object, robots: tuple[str, ...] = ("r1",), fixed: bool = False, **more: Any
) -> list[Place]:
    places = read_places(Names(VOCABULARY, Profile(**more)))
    return list(places(robots, msgspec.Raw(json.dumps({"transforms": transforms}).encode()), 5.0, fixed))


def test_a_robot_alone_on_its_topic_needs_no_prefix() -> None:
    assert read(transform("map", "odom"), transform("/odom", "/base_footprint", 2.0)) == [
        OriginReported("r1", 5.0, Pose(1.0, 0.0), "map"),
        OdometryReported("r1", 5.0, Pose(2.0, 0.0), 7.0, is_transform=True),
    ]


def test_of_several_each_is_known_by_its_prefix_and_others_are_left_out() -> None:
    found = read(
        transform("map", "r2/odom"),
        transform("r1/odom", "r1/base_link"),
        transform("r9/odom", "r9/base_link"),
        transform("odom", "base_link"),
        robots=("r1", "r2"),
    )
    assert [(type(one), one.robot) for one in found] == [(OriginReported, "r2"), (OdometryReported, "r1")]


def test_one_alone_is_not_placed_by_another_robot_of_the_same_topic() -> None:
    assert read(transform("map", "r2/odom"), transform("r2/odom", "r2/base_link")) == []


def test_without_an_odometry_frame_the_place_on_the_map_is_both() -> None:
    assert read(transform("map", "base_link", 4.0)) == [
        OriginReported("r1", 5.0, Pose(4.0, 0.0), "map"),
        OdometryReported("r1", 5.0, Pose(0.0, 0.0), 7.0, is_transform=True),
    ]


def test_a_base_of_another_name_is_that_of_the_profile() -> None:
    arm = transform("odom", "chassis")
    assert read(arm) == []
    assert len(read(arm, base_frame="chassis")) == 1
    prefixed = transform("r1/odom", "r1/chassis")
    assert len(read(prefixed, robots=("r1", "r2"), base_frame="{robot}/chassis")) == 1


def test_joints_wheels_and_lasers_are_no_places() -> None:
    assert read(transform("base_footprint", "base_link"), transform("base_link", "laser")) == []


def test_an_origin_that_never_changes_is_told_as_such() -> None:
    assert read(transform("map", "odom"), fixed=True) == [
        OriginReported("r1", 5.0, Pose(1.0, 0.0), "map", is_fixed=True)
    ]


@pytest.mark.parametrize(
    "bad", [transform("map", "odom", 1e300), transform("map", "odom", turn={**NO_TURN, "w": 0.0})]
)
def test_what_is_no_transform_is_bad_data(bad: dict[str, Any]) -> None:
    with pytest.raises(WireError):
        read(bad)

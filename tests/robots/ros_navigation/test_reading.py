"""Messages of navigating robots of either ROS as facts."""

import json
from typing import Any

import msgspec
import pytest

from fleet_tui.model.events import BatteryReported
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation_events import (
    FloorReported,
    LocalisationReported,
    OdometryReported,
    PlanReported,
    Unmeasured,
)
from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.robots.nav2.vocabulary import VOCABULARY
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros_navigation import reading
from fleet_tui.text.errors import WireError

HERE = {"position": {"x": 1.0, "y": 2.0, "z": 0.0}, "orientation": {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}}
ROS1 = {"stamp": {"secs": 3, "nsecs": 0}, "frame_id": "map"}
ROS2 = {"stamp": {"sec": 3, "nanosec": 0}, "frame_id": "map"}


def names(**profile: Any) -> Names:
    return Names(VOCABULARY, Profile(**profile))


def facts(read: reading.Read, message: object) -> list[object]:
    return list(read("r1", msgspec.Raw(json.dumps(message).encode()), 5.0))


@pytest.mark.parametrize("header", [ROS1, ROS2])
def test_odometry_of_either_ros(header: dict[str, Any]) -> None:
    message = {"header": header, "pose": {"pose": HERE, "covariance": []}, "child_frame_id": "base"}
    assert facts(reading.read_odometry(names()), message) == [
        OdometryReported("r1", 5.0, Pose(1.0, 2.0), 3.0)
    ]
    scaled = facts(reading.read_odometry(names(scales={"odometry": 0.001})), message)
    assert scaled == [OdometryReported("r1", 5.0, Pose(0.001, 0.002), 3.0)]


@pytest.mark.parametrize(
    ("linear", "angular", "speed"),
    [
        ({"x": -0.3, "y": 0.4, "z": 0.0}, {"x": 0.0, "y": 0.0, "z": -1.0}, Speeds(-0.3, 0.4, -1.0)),
        ({"x": 0.5, "y": None, "z": 0.0}, {"x": 0.0, "y": 0.0, "z": 0.0}, None),
        ({}, {}, None),
    ],
)
def test_the_speed_of_an_odometry(
    linear: dict[str, float | None], angular: dict[str, float | None], speed: Speeds | None
) -> None:
    twist = {"twist": {"linear": linear, "angular": angular}, "covariance": []}
    message = {"header": ROS2, "pose": {"pose": HERE, "covariance": []}, "twist": twist}
    assert facts(reading.read_odometry(names()), message) == [
        OdometryReported("r1", 5.0, Pose(1.0, 2.0), 3.0, speed=speed)
    ]


@pytest.mark.parametrize(
    ("covariance", "variance"),
    [([0.5] * 36, 1.0), ([None] * 36, None), ([0.5], None), ([], None), ([0.5] * 7 + [None] * 29, None)],
)
def test_how_sure_a_localisation_is(covariance: list[float | None], variance: float | None) -> None:
    message = {"header": ROS2, "pose": {"pose": HERE, "covariance": covariance}}
    (fact,) = facts(reading.read_localisation(names()), message)
    assert fact == LocalisationReported("r1", 5.0, Pose(1.0, 2.0), "map", 3.0, variance)


def test_a_battery_that_is_not_measured_is_no_empty_one() -> None:
    assert facts(reading.read_battery(names()), {"percentage": None}) == [Unmeasured("r1", 5.0, "battery")]
    scaled = reading.read_battery(names(scales={"battery": 100.0}))
    assert facts(scaled, {"percentage": 0.5}) == [BatteryReported("r1", 5.0, 50.0)]
    for beyond in (-0.1, 1.02):
        with pytest.raises(WireError, match="not between 0 and 100"):
            facts(scaled, {"percentage": beyond})


def test_a_floor_has_no_slash_and_a_path_leads_to_its_end() -> None:
    assert facts(reading.read_floor(names()), {"data": "/hall"}) == [FloorReported("r1", 5.0, "hall")]
    path = {"poses": [{"pose": None}, {"pose": HERE}]}
    assert facts(reading.read_plan(names()), path) == [PlanReported("r1", 5.0, Pose(1.0, 2.0))]
    assert facts(reading.read_plan(names()), {"poses": []}) == []
    far = {**HERE, "position": {"x": 1e300, "y": 0.0, "z": 0.0}}
    with pytest.raises(WireError, match=r"poses\[-1\]"):
        facts(reading.read_plan(names()), {"poses": [{"pose": far}]})

"""Requests and messages are completed as the bridge does, and refused in its words."""

from typing import Any

import pytest

from fleet_tui.simulator.ros.definitions import MESSAGES
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.ros.errors import ServiceError
from fleet_tui.simulator.ros.filling import fill
from fleet_tui.simulator.ros.ros2 import ROS2

NOW = 12.5


def filled(type_: str, given: object, dialect: Dialect = ROS1) -> Any:
    return fill(dialect, type_, MESSAGES[type_], given, NOW)


def test_what_is_missing_is_zero_and_a_stamp_is_now() -> None:
    pose = filled("geometry_msgs/PoseStamped", {"pose": {"position": {"x": 3}}})
    assert pose["pose"]["position"] == {"x": 3.0, "y": 0.0, "z": 0.0}
    assert pose["header"] == {"seq": 0, "stamp": {"secs": 12, "nsecs": 500_000_000}, "frame_id": ""}
    given = filled("std_msgs/Header", {"stamp": {"sec": 7}}, ROS1)
    assert given["stamp"] == {"secs": 7, "nsecs": 0}, "names of both generations are read"


@pytest.mark.parametrize("given", [None, 7, "x", []])
def test_nothing_is_all_zeros_and_a_list_is_in_the_order_of_the_fields(given: object) -> None:
    assert filled("geometry_msgs/Point", given) == {"x": 0.0, "y": 0.0, "z": 0.0}
    assert filled("geometry_msgs/Point", [1, 2]) == {"x": 1.0, "y": 2.0, "z": 0.0}


@pytest.mark.parametrize(
    ("type_", "given", "words"),
    [
        ("std_msgs/Bool", {"dta": True}, "Message type std_msgs/Bool does not have a field dta"),
        ("geometry_msgs/Pose", {"position": {"w": 1}}, "does not have a field position.w"),
        ("std_msgs/Int32", {"data": True}, "requires a int32 for field data, but got a <class 'bool'>"),
        ("std_msgs/Int32", {"data": 2**31}, r"field data exceeds specified width \[int32\]"),
        ("geometry_msgs/Pose", {"position": 7}, "for field position"),
        ("nav_msgs/OccupancyGrid", {"data": "x"}, r"int8\[\]"),
    ],
)
def test_what_does_not_fit_is_refused_with_its_field(type_: str, given: object, words: str) -> None:
    with pytest.raises(ServiceError, match=words):
        filled(type_, given)


def test_arrays_of_fixed_length_are_filled_by_one_number_or_all() -> None:
    one = filled("geometry_msgs/PoseWithCovariance", {"covariance": [2.0]})["covariance"]
    assert list(one) == [2.0] * 36
    with pytest.raises(ServiceError):
        filled("geometry_msgs/PoseWithCovariance", {"covariance": [1.0, 2.0]})
    uuid = filled("unique_identifier_msgs/UUID", {"uuid": "AQID" + "AAAA" * 4 + "AA=="}, ROS2)["uuid"]
    assert uuid.tolist() == [1, 2, 3] + [0] * 13

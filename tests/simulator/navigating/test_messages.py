"""Messages of robots that navigate, in both dialects: complete, and NaN for what is not measured."""

import math

import numpy as np
import pytest

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.messages import grid, headers
from fleet_tui.simulator.navigating import messages
from fleet_tui.simulator.ros.definitions import MESSAGES
from fleet_tui.simulator.ros.dialect import ROS1, Dialect
from fleet_tui.simulator.ros.encoding import encode
from fleet_tui.simulator.ros.ros2 import ROS2
from tests.support.navigating import FLOOR, robot

DIALECTS = pytest.mark.parametrize("dialect", [ROS1, ROS2], ids=["ros1", "ros2"])


@DIALECTS
def test_each_has_every_field_of_its_type(dialect: Dialect) -> None:
    it, header = robot(), headers(dialect)
    it.way = [(1.0, 2.0)]
    for type_, message in {
        "nav_msgs/Odometry": messages.odometry(it, dialect, header(1.0)),
        "geometry_msgs/PoseWithCovarianceStamped": messages.localisation(it.pose, 0.5, dialect, header(1.0)),
        "sensor_msgs/BatteryState": messages.battery(it, header(1.0)),
        "nav_msgs/Path": messages.path(it, header(1.0)),
        "nav_msgs/OccupancyGrid": grid(FLOOR.cells, (0.0, 0.0), header(1.0), dialect.time(1.0)),
    }.items():
        assert set(message) == set(MESSAGES[type_])
        assert encode(dialect, dialect.short(dialect.message_type(type_)), message)


def test_headers_count_on_ros_1_and_have_a_frame() -> None:
    header = headers(ROS1, "odom")
    assert [header(float(n))["seq"] for n in range(3)] == [1, 2, 3]
    assert header(7.0)["frame_id"] == "odom" and "seq" not in headers(ROS2)(1.0)


def test_a_covariance_has_the_variance_where_it_belongs() -> None:
    found = messages.localisation(Pose(1.0, 2.0, 0.5), 0.25, ROS1, {})["pose"]["covariance"]
    matrix = np.array(found).reshape(6, 6)
    assert [matrix[n, n] for n in (0, 1, 5)] == [0.25] * 3 and matrix.sum() == 0.75


def test_a_battery_is_a_share_of_one_by_default_and_charges_at_its_dock() -> None:
    it = robot()
    it.battery, it.docked = 50.0, True
    found = messages.battery(it, {})
    assert found["percentage"] == 0.5 and found["power_supply_status"] == messages.CHARGING
    assert math.isnan(found["current"])
    it.percent, it.docked = math.nan, False
    found = messages.battery(it, {})
    assert math.isnan(found["percentage"]) and found["power_supply_status"] == messages.DISCHARGING


def test_a_path_begins_where_the_robot_is() -> None:
    it = robot()
    it.way = [(1.0, 2.0), (3.0, 4.0)]
    spots = [
        (one["pose"]["position"]["x"], one["pose"]["position"]["y"]) for one in messages.path(it, {})["poses"]
    ]
    assert spots == [(it.pose.x, it.pose.y), *it.way]

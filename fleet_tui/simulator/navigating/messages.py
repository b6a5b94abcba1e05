"""The messages of robots that navigate, for both versions of ROS. Pure."""

import math

import numpy as np

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.messages import Message, float32, solid
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.ros.dialect import Dialect

# sensor_msgs/BatteryState
CHARGING = 1
DISCHARGING = 2
LION = 2
UNMEASURED = dict.fromkeys(("temperature", "current", "charge", "capacity", "design_capacity"), math.nan)


def odometry(robot: NavigatingRobot, dialect: Dialect, header: Message) -> Message:
    """nav_msgs/Odometry in the robot's own frame; values that it does not measure are NaN."""
    # Motions that a planar robot cannot make have no variance; its roll and pitch are not measured.
    spread = _diagonal(dialect, 0.01, 0.01, 0.0, math.nan, math.nan, 0.03)
    metres, radians = robot.speed
    twist = {"linear": _vector(metres), "angular": {**_vector(0.0), "z": radians}}
    return {
        "header": header,
        "child_frame_id": f"{robot.name}/base_link",
        "pose": {"pose": solid(robot.odom), "covariance": spread},
        "twist": {"twist": twist, "covariance": dialect.fixed([0.0] * 36)},
    }


def localisation(pose: Pose, variance: float, dialect: Dialect, header: Message) -> Message:
    """geometry_msgs/PoseWithCovarianceStamped."""
    spread = _diagonal(dialect, variance, variance, 0.0, 0.0, 0.0, variance)
    return {"header": header, "pose": {"pose": solid(pose), "covariance": spread}}


def battery(robot: NavigatingRobot, header: Message) -> Message:
    """sensor_msgs/BatteryState."""
    return {
        "header": header,
        "voltage": float32(10.5 + 0.02 * robot.battery),
        **UNMEASURED,
        "percentage": float32(robot.percent * robot.battery),
        "power_supply_status": CHARGING if robot.docked else DISCHARGING,
        "power_supply_health": 0,
        "power_supply_technology": LION,
        "present": True,
        "cell_voltage": [],
        "cell_temperature": [],
        "location": "",
        "serial_number": "",
    }


def path(robot: NavigatingRobot, header: Message) -> Message:
    """nav_msgs/Path from where it is to its goal."""
    spots = [(robot.pose.x, robot.pose.y), *robot.way]
    return {"header": header, "poses": [{"header": header, "pose": solid(Pose(*spot))} for spot in spots]}


def _diagonal(dialect: Dialect, *values: float) -> object:
    """A matrix of six rows as an array of fixed length."""
    return dialect.fixed(np.diag(values).ravel().tolist())


def _vector(x: float) -> Message:
    return {"x": x, "y": 0.0, "z": 0.0}

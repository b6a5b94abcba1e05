"""Poses as ROS's messages have them. Pure."""

import math
from typing import Any

from fleet_tui.model.geometry import Pose, yaw_of_quaternion

Message = dict[str, Any]

FRAME = "map"


def solid(pose: Pose) -> Message:
    """A pose in space: geometry_msgs/Pose."""
    half = pose.yaw / 2.0
    return {
        "position": {"x": pose.x, "y": pose.y, "z": 0.0},
        "orientation": {"x": 0.0, "y": 0.0, "z": math.sin(half), "w": math.cos(half)},
    }


def stamped(pose: Pose) -> Message:
    """A pose on the map without a time: geometry_msgs/PoseStamped."""
    return {"header": {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": FRAME}, "pose": solid(pose)}


def flat(pose: Message) -> Pose:
    """A pose on the plane; a quaternion of zeros is no rotation."""
    turn = pose["orientation"]
    try:
        yaw = yaw_of_quaternion(turn["x"], turn["y"], turn["z"], turn["w"])
    except ValueError:
        yaw = 0.0
    return Pose(pose["position"]["x"], pose["position"]["y"], yaw)

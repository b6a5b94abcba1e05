"""Destinations of orders, as the poses that navigation stacks take."""

import math
from collections.abc import Mapping

from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop
from fleet_tui.model.robot import Robot
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message


def pose_of_stop(robot: Robot, stop: Stop, before: Pose | None) -> Pose:
    """Return the pose of a stop: with its own heading, else that of the way from `before`. Raises
    CommandError."""
    if stop.pose is not None:
        return stop.pose
    robot_map = robot.maps.get(robot.floor or "")
    if robot_map is None or robot_map.graph is None or stop.vertex not in robot_map.graph.vertices:
        raise CommandError(
            Message(
                "position of vertex {vertex} unknown: no graph of its floor contains it", vertex=stop.vertex
            )
        )
    vertex = robot_map.graph.vertices[stop.vertex]
    if before is None:
        return Pose(vertex.x, vertex.y)
    dx, dy = vertex.x - before.x, vertex.y - before.y
    return Pose(vertex.x, vertex.y, math.atan2(dy, dx) if math.hypot(dx, dy) > 0.1 else before.yaw)


def stamped(pose: Pose) -> Mapping[str, object]:
    """Return a geometry_msgs/PoseStamped without a stamp: the robot uses its current map transform."""
    return {
        "header": {"frame_id": "map"},
        "pose": {
            "position": {"x": pose.x, "y": pose.y, "z": 0.0},
            "orientation": {"x": 0.0, "y": 0.0, "z": math.sin(pose.yaw / 2), "w": math.cos(pose.yaw / 2)},
        },
    }

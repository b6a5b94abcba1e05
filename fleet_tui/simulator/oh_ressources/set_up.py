"""Set-up of the source's robots: topics that a site may have, and that no profile names by default."""

from collections.abc import Callable, Mapping
from typing import Any

from fleet_tui.model.geometry import Pose, yaw_of_quaternion
from fleet_tui.simulator.robot import SimRobot

Message = dict[str, Any]


def _take_pose(robot: SimRobot, message: Message) -> None:
    """Take a pose on its floor; one in a foreign frame is dropped silently."""
    if message["header"]["frame_id"].lstrip("/") == robot.floor.name:
        robot.belief.place(_flat(message["pose"]["pose"]), robot.pose)


def _take_goal(robot: SimRobot, message: Message) -> None:
    if message["header"]["frame_id"].lstrip("/") == robot.floor.name:
        robot.visit(_flat(message["pose"]))


def _cancel_goal(robot: SimRobot, message: Message) -> None:
    """Stop; the only id known here is the empty one, for every goal."""
    if not message["id"]:
        robot.visit(None)


def _flat(pose: Message) -> Pose:
    turn, at = pose["orientation"], pose["position"]
    try:
        yaw = yaw_of_quaternion(turn["x"], turn["y"], turn["z"], turn["w"])
    except ValueError:
        yaw = 0.0
    return Pose(at["x"], at["y"], yaw)


SUBSCRIPTIONS: Mapping[str, tuple[str, Callable[[SimRobot, Message], None]]] = {
    "initialpose": ("geometry_msgs/PoseWithCovarianceStamped", _take_pose),
    "goal": ("geometry_msgs/PoseStamped", _take_goal),
    "goal_cancel": ("actionlib_msgs/GoalID", _cancel_goal),
}
"""Type of each topic, and the function that takes its messages."""

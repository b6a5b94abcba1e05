"""The messages of move_base, as ROS 1 has them. Pure."""

from typing import Any

from fleet_tui.simulator.navigating.poses import solid
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.ros.actionlib import GoalReport

Message = dict[str, Any]

GIGA = 10**9


def goal_status(status: GoalReport) -> Message:
    """actionlib_msgs/GoalStatus."""
    stamp = {"secs": status.stamp // GIGA, "nsecs": status.stamp % GIGA}
    return {"goal_id": {"stamp": stamp, "id": status.id}, "status": status.status, "text": status.text}


def statuses(listed: list[GoalReport], header: Message) -> Message:
    """actionlib_msgs/GoalStatusArray."""
    return {"header": header, "status_list": [goal_status(status) for status in listed]}


def result(status: GoalReport, header: Message) -> Message:
    """move_base_msgs/MoveBaseActionResult."""
    return {"header": header, "status": goal_status(status), "result": {}}


def feedback(status: GoalReport, robot: NavigatingRobot, header: Message, at: Message) -> Message:
    """move_base_msgs/MoveBaseActionFeedback; `at` is the header of the robot's pose."""
    position = {"header": at, "pose": solid(robot.belief.of(robot.pose))}
    return {"header": header, "status": goal_status(status), "feedback": {"base_position": position}}

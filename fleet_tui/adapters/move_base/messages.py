"""Messages of actionlib and move_base as typed structs."""

from typing import Any

import msgspec

from fleet_tui.adapters.ros.messages import PoseStamped, Stamp


class ActionlibGoalId(msgspec.Struct, frozen=True):
    """actionlib_msgs/GoalID. An empty id means all goals."""

    id: str
    stamp: Stamp = Stamp()


class ActionlibGoalStatus(msgspec.Struct, frozen=True):
    """actionlib_msgs/GoalStatus."""

    goal_id: ActionlibGoalId
    status: int
    text: str = ""


class ActionlibStatusArray(msgspec.Struct, frozen=True):
    """actionlib_msgs/GoalStatusArray, its goals unread: one bad one must not cost the others."""

    status_list: list[Any]


class MoveBaseFeedback(msgspec.Struct, frozen=True):
    """move_base_msgs/MoveBaseFeedback: the robot's pose."""

    base_position: PoseStamped


class ActionFeedback(msgspec.Struct, frozen=True):
    """move_base_msgs/MoveBaseActionFeedback."""

    feedback: MoveBaseFeedback

"""Messages of actionlib and move_base as typed structs."""

from typing import Any

import msgspec

from fleet_tui.adapters.ros.messages import Header, RosPose, Stamp


class ActionlibGoalId(msgspec.Struct, frozen=True):
    """actionlib_msgs/GoalID. An empty id stands for all goals."""

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


class Posed(msgspec.Struct, frozen=True):
    """geometry_msgs/PoseStamped."""

    header: Header
    pose: RosPose


class MoveBaseFeedback(msgspec.Struct, frozen=True):
    """move_base_msgs/MoveBaseFeedback: where the robot is."""

    base_position: Posed


class ActionFeedback(msgspec.Struct, frozen=True):
    """move_base_msgs/MoveBaseActionFeedback."""

    feedback: MoveBaseFeedback

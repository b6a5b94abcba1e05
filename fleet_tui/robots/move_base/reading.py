"""Messages of move_base as events."""

import hashlib
import re
from collections.abc import Iterable
from typing import Any

import msgspec

from fleet_tui.model import events
from fleet_tui.model.navigation import Goal
from fleet_tui.model.navigation_events import Alive, GoalsReported, LocalisationReported, TargetReported
from fleet_tui.model.order import OrderState
from fleet_tui.robots.parts import read_all
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.facts import pose_of
from fleet_tui.robots.ros.messages import PoseStamped, Stamp
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros_navigation.reading import Read
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import EMPTY, Message, verbatim
from fleet_tui.text.limits import MOST_ORDERS, truncate


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


ACTION = "move_base"
"""The one action that such robots have."""
OWN_NAME = re.compile(r"fleet-tui-([0-9a-f]{8})-[0-9a-f-]{27}")
"""Names of goals that consoles gave."""
LONGEST_ID = 500
STATES = {
    0: OrderState.QUEUED,
    1: OrderState.IN_PROCESS,
    2: OrderState.CANCELLED,
    3: OrderState.DONE,
    4: OrderState.FAILED,
    5: OrderState.REFUSED,
    6: OrderState.IN_PROCESS,
    # Cancelled before it was begun. One whose goal never arrived stays listed so.
    7: OrderState.CANCELLED,
    8: OrderState.CANCELLED,
    9: OrderState.LOST,
}
"""States of a goal (actionlib_msgs/GoalStatus). One that is being preempted still drives."""
PREEMPTING = 6
WORDS = (
    "pending",
    "active",
    "preempted",
    "succeeded",
    "aborted",
    "rejected",
    "preempting",
    "recalling",
    "recalled",
    "lost",
)
REPLACED = re.compile(r"because another goal was rec(?:ie|ei)ved")
"""Text of a goal that was replaced by a newer one, as actionlib for C++ and for Python spell it."""


def read_status(names: Names) -> Read:
    """Read an actionlib_msgs/GoalStatusArray, sent five times a second."""
    read, read_one = (
        ros.reader(ActionlibStatusArray, names.paths("status")),
        ros.reader(ActionlibGoalStatus),
    )

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        listed, faults = read(msg).status_list, list[str]()
        goals = []
        for one in read_all(read_one, listed[-MOST_ORDERS:], Message("status_list"), MOST_ORDERS, faults):
            try:
                goals.append(_goal(one))
            except WireError as problem:
                faults.append(str(problem))
        yield GoalsReported(robot, at, ACTION, tuple(goals), verbatim(faults[0]) if faults else EMPTY)
        yield Alive(robot, at)

    return facts


def _goal(one: ActionlibGoalStatus) -> Goal:
    state, id_ = STATES.get(one.status), one.goal_id.id
    if state is OrderState.CANCELLED and REPLACED.search(one.text):
        state = OrderState.REPLACED
    word = WORDS[one.status] if 0 <= one.status < len(WORDS) else f"status {one.status}"
    return Goal(
        short_id(id_),
        id_,
        ACTION,
        state,
        word,
        one.goal_id.stamp.seconds,
        is_ending=one.status == PREEMPTING,
        said=truncate(one.text),
    )


def short_id(id_: str) -> str:
    """Return eight digits for a goal's id, as people write it: the first ones of a console's goal, a hash of
    any other. Raises WireError."""
    if not id_:
        # To cancel a goal of this id would cancel all goals.
        raise WireError("goal_id.id is empty, which means all goals")
    if len(id_) > LONGEST_ID:
        raise WireError(f"goal_id.id has {len(id_):,} characters")
    own = OWN_NAME.fullmatch(id_)
    return own[1] if own else hashlib.sha256(id_.encode(errors="replace")).hexdigest()[:8]


def read_target(names: Names) -> Read:
    """Read a geometry_msgs/PoseStamped: the target of the goal that has just begun."""
    read = ros.reader(ros.PoseStamped, names.paths("target"))

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        yield TargetReported(robot, at, pose_of(read(msg).pose, "pose"))

    return facts


def read_feedback(names: Names) -> Read:
    """Read a move_base_msgs/MoveBaseActionFeedback."""
    read = ros.reader(ActionFeedback, names.paths("feedback"))

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        placed = read(msg).feedback.base_position
        pose = pose_of(placed.pose, "feedback.base_position.pose")
        yield Alive(robot, at)
        header = placed.header
        yield LocalisationReported(
            robot, at, pose, header.frame_id, header.stamp.seconds, None, is_feedback=True
        )

    return facts

"""Messages of Nav2 as events."""

import base64
import binascii
from collections.abc import Iterable

from fleet_tui.model import events, navigation_events
from fleet_tui.model.navigation import Goal, Progress
from fleet_tui.model.order import DOCKING, OrderState
from fleet_tui.robots.parts import read_all
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros import navigation as nav
from fleet_tui.robots.ros.facts import pose_of
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros_navigation.reading import Read
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import EMPTY, Message, verbatim
from fleet_tui.text.limits import LONGEST_NAME, MOST_ORDERS, truncate

STATES = {
    1: OrderState.QUEUED,
    2: OrderState.IN_PROCESS,
    3: OrderState.IN_PROCESS,
    4: OrderState.DONE,
    5: OrderState.CANCELLED,
    6: OrderState.FAILED,
}
"""States of a goal (action_msgs/GoalStatus). One that is being cancelled still drives."""
FARTHEST = 1e6
MOST_COUNTED = 10**6
"""Metres, and recoveries, above which a number is invalid."""
CANCELLING = 3
WORDS = {1: "accepted", 2: "executing", 3: "cancelling", 4: "succeeded", 5: "cancelled", 6: "aborted"}
LEADING = "follow_waypoints"
"""The action that drives by goals of another one."""
LABELS = {"dock_robot": DOCKING, "undock_robot": "undocking"}
"""Goals without a stop."""
MONITOR = {0: "", 1: "stop", 2: "slowdown", 3: "approach", 4: "limit"}
"""Actions of a collision monitor (nav2_msgs/CollisionMonitorState)."""


def read_blocked(names: Names) -> Read:
    """Read a nav2_msgs/CollisionMonitorState."""
    read = ros.reader(nav.CollisionMonitorState, names.paths("blocked"))

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        message = read(msg)
        action = MONITOR.get(message.action_type, f"action {message.action_type}")
        yield navigation_events.BlockedReported(
            robot, at, action, truncate(message.polygon_name, LONGEST_NAME)
        )

    return facts


def read_goals(action: str) -> Read:
    """Read the action_msgs/GoalStatusArray of an action, `action` being its key."""
    read, read_one = ros.reader(nav.GoalStatusArray), ros.reader(nav.GoalStatus)

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        listed, faults = read(msg).status_list, list[str]()
        found = read_all(read_one, listed[-MOST_ORDERS:], Message("status_list"), MOST_ORDERS, faults)
        goals = []
        for one in found:
            try:
                goals.append(_goal(action, one))
            except WireError as problem:
                faults.append(str(problem))
        yield navigation_events.GoalsReported(
            robot, at, action, tuple(goals), verbatim(faults[0]) if faults else EMPTY
        )

    return facts


def _goal(action: str, one: nav.GoalStatus) -> Goal:
    uuid = one.goal_info.goal_id.uuid
    word = WORDS.get(one.status, f"status {one.status}")
    stamp = one.goal_info.stamp.seconds
    label = LABELS.get(action, "")
    state, is_ending = STATES.get(one.status), one.status == CANCELLING
    return Goal(
        short_id(uuid),
        uuid,
        action,
        state,
        word,
        stamp,
        label=label,
        leads=action == LEADING,
        is_ending=is_ending,
    )


def _is_placed(pose: ros.RosPose) -> bool:
    """Tell whether a pose was ever set: one without a rotation is no bad data before the first plan."""
    turn = pose.orientation
    return any((turn.x, turn.y, turn.z, turn.w))


def short_id(uuid: str) -> str:
    """The first eight digits of a goal's id, as people write it. Raises WireError."""
    try:
        found = base64.b64decode(uuid, validate=True)
    except (binascii.Error, ValueError):
        found = b""
    if len(found) != 16:
        raise WireError(f"goal_id.uuid: {truncate(uuid, LONGEST_NAME)!r} is not a 16-byte id")
    if not any(found):
        # To cancel a goal of this id would cancel all goals.
        raise WireError("goal_id.uuid is all zeros, which means all goals")
    return found.hex()[:8]


def read_feedback() -> Read:
    read = ros.reader(nav.FeedbackMessage)

    def facts(robot: str, msg: object, at: float) -> Iterable[events.Event]:
        message = read(msg)
        feedback, goal = message.feedback, short_id(message.goal_id.uuid)
        left, elapsed = feedback.estimated_time_remaining, feedback.navigation_time
        metres = feedback.distance_remaining
        progress = Progress(
            goal,
            # 0 means "unknown": before the first plan, and while the robot does not move.
            metres if metres and 0.0 < metres <= FARTHEST else None,
            left.seconds if left and left.seconds > 0.0 else None,
            elapsed.seconds if elapsed else None,
            feedback.number_of_recoveries
            if 0 <= (feedback.number_of_recoveries or 0) <= MOST_COUNTED
            else None,
            feedback.current_waypoint,
        )
        yield navigation_events.ProgressReported(robot, at, progress)
        if (here := feedback.current_pose) is not None and _is_placed(here.pose):
            pose, header = pose_of(here.pose, "current_pose"), here.header
            yield navigation_events.LocalisationReported(
                robot, at, pose, header.frame_id, header.stamp.seconds, None, is_feedback=True
            )

    return facts

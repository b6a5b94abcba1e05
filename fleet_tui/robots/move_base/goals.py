"""Orders and cancellations of move_base as messages."""

from collections.abc import Sequence
from uuid import UUID

from fleet_tui.model.order import Stop
from fleet_tui.model.robot import Robot
from fleet_tui.orders.goals import active
from fleet_tui.robots.adapter import Publication
from fleet_tui.robots.move_base.reading import ACTION
from fleet_tui.robots.ros.names import Names
from fleet_tui.robots.ros_navigation.places import pose_of_stop, stamped
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message

NO_STAMP = {"secs": 0, "nsecs": 0}
"""Stamp of a goal: taken now, by the robot's clock. In a cancellation any other stamp would mean every goal
up to it, too."""
ALL = ""
"""The id of all goals."""


def order(names: Names, robot: Robot, stops: Sequence[Stop], unique: str) -> tuple[Publication]:
    """Return the goal that leads to a stop, under a name of its own. Raises CommandError."""
    if len(stops) != 1:
        raise CommandError(Message("a move_base goal has one stop"))
    topic = names.topic("goal", robot.name)
    if not topic:
        raise CommandError(
            Message("no goals for this robot: [{table}.topics] goal is empty", table=names.table)
        )
    pose = pose_of_stop(robot, stops[0], robot.pose.value if robot.pose else None)
    name = f"fleet-tui-{UUID(hex=unique)}"
    message = {
        "header": {"stamp": NO_STAMP, "frame_id": ""},
        "goal_id": {"stamp": NO_STAMP, "id": name},
        "goal": {"target_pose": {**stamped(pose), "header": {"stamp": NO_STAMP, "frame_id": "map"}}},
    }
    return (Publication(topic, names.type("goal"), message, name),)


def cancel(names: Names, robot: Robot, order_id: str) -> list[Publication]:
    """Return the cancellation of one goal, from any client. Raises CommandError for an unknown one."""
    found = [goal.uuid for listed in robot.goals.values() for goal in listed if goal.id == order_id]
    if len(found) != 1:
        known = (
            Message("{count} goals match {order_id}", count=len(found), order_id=order_id)
            if found
            else Message("unknown goal {order_id}", order_id=order_id)
        )
        raise CommandError(Message("{problem}: see the queue of {name}", problem=known, name=robot.name))
    return _cancel(names, robot, found)


def cancel_own(names: Names, robot: Robot) -> list[Publication]:
    """Return the cancellation of each goal of this console."""
    own = [goal.uuid for goal in active(robot.goals) if goal.is_ours]
    return _cancel(names, robot, [*own, *_not_listed_yet(robot)])


def cancel_all(names: Names, robot: Robot) -> list[Publication]:
    """Return the cancellation of all goals of all clients: each by its id, or all at once if the robot has
    never listed them."""
    if ACTION not in robot.goals:
        return _cancel(names, robot, [ALL])
    return _cancel(names, robot, [*(goal.uuid for goal in active(robot.goals)), *_not_listed_yet(robot)])


def _not_listed_yet(robot: Robot) -> list[str]:
    """Return the goal that this console has just given: its cancellation may even arrive before it."""
    return [robot.named] if robot.named else []


def _cancel(names: Names, robot: Robot, ids: Sequence[str]) -> list[Publication]:
    topic, type_ = names.topic("cancel", robot.name), names.type("cancel")
    if not topic:
        raise CommandError(
            Message("no cancel for this robot: [{table}.topics] cancel is empty", table=names.table)
        )
    return [Publication(topic, type_, {"stamp": NO_STAMP, "id": id_}) for id_ in dict.fromkeys(ids)]

"""Orders and cancellations of Nav2 as goals and calls, and the meaning of their answers."""

from collections.abc import Mapping, Sequence

from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop
from fleet_tui.model.robot import Robot
from fleet_tui.orders.goals import active
from fleet_tui.robots.adapter import ActionGoal, ServiceCall
from fleet_tui.robots.nav2.vocabulary import ACTIONS, MOTIONS
from fleet_tui.robots.ros.names import Names, cancel_service
from fleet_tui.robots.ros_navigation.places import pose_of_stop, stamped
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message

NO_STAMP = {"sec": 0, "nanosec": 0}
ALL = "AAAAAAAAAAAAAAAAAAAAAA=="
"""The id of all goals: sixteen zeros."""
CANCEL_TYPE = "action_msgs/srv/CancelGoal"
NO_ERROR = 0
UNKNOWN_GOAL = 2
"""Return codes of a cancellation. One of all goals reports no error if there are none."""


def order(names: Names, robot: Robot, stops: Sequence[Stop], _unique: str) -> tuple[ActionGoal]:
    """Return the goal that leads to the stops in sequence. Raises CommandError."""
    poses, here = list[Pose](), robot.pose.value if robot.pose else None
    if not stops:
        raise CommandError(Message("an order needs a destination"))
    for stop in stops:
        here = pose_of_stop(robot, stop, here)
        poses.append(here)
    if len(poses) == 1:
        args: dict[str, object] = {"pose": stamped(poses[0]), "behavior_tree": ""}
        return (_goal(names, "navigate_to_pose", robot, args),)
    return (_goal(names, "follow_waypoints", robot, {"poses": [stamped(pose) for pose in poses]}),)


def _goal(names: Names, key: str, robot: Robot, args: Mapping[str, object]) -> ActionGoal:
    name = names.action(key, robot.name)
    if not name:
        raise CommandError(
            Message("this robot has no {key}: [{table}.actions] {key} is empty", key=key, table=names.table)
        )
    return ActionGoal(name, names.action_type(key), args)


def cancel(names: Names, robot: Robot, order_id: str) -> tuple[ServiceCall]:
    """Return the call that cancels one goal, from any client. Raises CommandError for an unknown one."""
    found = [goal for listed in robot.goals.values() for goal in listed if goal.id == order_id]
    if len(found) != 1:
        known = (
            Message("{count} goals match {order_id}", count=len(found), order_id=order_id)
            if found
            else Message("unknown goal {order_id}", order_id=order_id)
        )
        raise CommandError(Message("{problem}: see the queue of {name}", problem=known, name=robot.name))
    return (_cancel(names, robot, found[0].action, found[0].uuid),)


def cancel_own(names: Names, robot: Robot) -> list[ServiceCall]:
    """Return the calls that cancel each goal of this console, those that drive by others first."""
    under_way = sorted(active(robot.goals), key=lambda goal: ACTIONS.index(goal.action))
    return [_cancel(names, robot, goal.action, goal.uuid) for goal in under_way if goal.is_ours]


def cancel_all(names: Names, robot: Robot) -> list[ServiceCall]:
    """Return the calls that cancel all goals of all clients: of each action that ever had one, of those that
    orders use, and then of all others that move the robot, of which no end of those is the end."""
    used = {"follow_waypoints", "navigate_to_pose", *robot.goals}
    keys = [key for key in ACTIONS if key in used and names.action(key, robot.name)]
    motions = [key for key in MOTIONS if key not in keys and names.action(key, robot.name)]
    return [_cancel(names, robot, key, ALL) for key in keys] + [
        _cancel(names, robot, key, ALL)._replace(server=names.action(key, robot.name)) for key in motions
    ]


def stopped_motion(call: ServiceCall, values: object, robot: Robot, sent_at: float) -> str:
    """Return the name of the action of which a pause ended a goal that no navigation had given, else ""."""
    if not call.server or not isinstance(values, Mapping) or not values.get("goals_canceling"):
        return ""
    if active(robot.goals) or any(gone.at >= sent_at for gone in robot.gone):
        return ""
    return call.server.rpartition("/")[2]


def unknown_goals(
    names: Names, call: ServiceCall, values: object, robot: Robot, sent_at: float
) -> tuple[str, ...]:
    """Return the ids of goals that were active in the last list before a cancellation was sent, and that are
    not active according to its answer."""
    if not isinstance(values, Mapping) or values.get("goals_canceling"):
        return ()
    code = values.get("return_code")
    return tuple(
        goal.uuid
        for goal in active(robot.goals)
        if (code == UNKNOWN_GOAL and call == _cancel(names, robot, goal.action, goal.uuid))
        or (code in (NO_ERROR, UNKNOWN_GOAL) and call == _cancel(names, robot, goal.action, ALL))
        if goal.listed_at < sent_at and not goal.is_ending
    )


def _cancel(names: Names, robot: Robot, action: str, uuid: str) -> ServiceCall:
    # Complete: the bridge fills gaps with zeros, and an all-zero id means all goals.
    info = {"goal_id": {"uuid": uuid}, "stamp": NO_STAMP}
    service = cancel_service(names.action(action, robot.name))
    return ServiceCall(service, CANCEL_TYPE, {"goal_info": info})

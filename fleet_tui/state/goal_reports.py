"""Reports of goals: those that a robot's action servers list, and their targets."""

import math
from collections.abc import Collection
from typing import assert_never

from msgspec.structs import replace

from fleet_tui.model import events, navigation_events
from fleet_tui.model.geometry import Pose
from fleet_tui.model.order import Stop
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.orders.goals import active, queue_of, with_reported, with_stops, without
from fleet_tui.state.reports import apply_report
from fleet_tui.text.language import EMPTY, Message

JUST_BEGUN = 1.0
"""Seconds within which a new goal is listed and its target is reported, in either order."""
MOTIONS_KEPT = 8
"""Motions that pauses ended, of which as many may be kept as one pause can end."""
AT_VERTEX = 0.5
"""Metres from a vertex within which a path ends at it."""


def apply_goals(robot: Robot, event: navigation_events.GoalFact) -> Robot:
    """Apply one report about goals to their robot."""
    match event:
        case navigation_events.GoalsReported():
            return _take_goals(robot, event)
        case navigation_events.GoalsUnknown():
            return _without_goals(robot, event.uuids, event.at)
        case navigation_events.MotionStopped():
            new = Reading(event.motion, event.at)
            return replace(robot, stopped_motions=(*robot.stopped_motions, new)[-MOTIONS_KEPT:])
        case navigation_events.PlanReported():
            return _take_plan(robot, event)
        case navigation_events.TargetReported():
            return _take_target(with_sign_of_life(robot, event.at), event)
        case _:
            assert_never(event)


def with_sign_of_life(robot: Robot, at: float) -> Robot:
    return replace(robot, last_received=max(robot.last_received or at, at))


def _take_goals(robot: Robot, event: navigation_events.GoalsReported) -> Robot:
    last, before = robot.orders.last_serial, robot.queue.at if robot.queue else math.inf
    goals = with_reported(robot.goals, event.action, event.goals, event.at, last, not event.fault)
    is_listed = any(goal.uuid == robot.named for goal in event.goals)
    # A tour may be listed after its first leg: the leg was an order until then, and has not ended.
    legs = {goal.id for listed in goals.values() for goal in listed if goal.is_leg}
    traces = {id_: trace for id_, trace in robot.traces.items() if id_ not in legs}
    robot = replace(robot, goals=goals, traces=traces, named="" if is_listed else robot.named)
    robot = with_queue(robot, event.at, event.fault)
    if robot.target is not None and robot.target.at > before:
        return _led_to(robot, robot.target.value, event.at)
    return robot


def _take_target(robot: Robot, event: navigation_events.TargetReported) -> Robot:
    """Assign the target to a goal that has just begun; it may be listed before or after."""
    robot = replace(robot, target=Reading(event.pose, event.at))
    return _led_to(robot, event.pose, event.at - JUST_BEGUN)


def _led_to(robot: Robot, pose: Pose, since: float) -> Robot:
    """Record the target of the goal that was first seen active at `since` or later."""
    begun = {goal.id for goal in active(robot.goals) if goal.begun_at is not None and goal.begun_at >= since}
    current = robot.orders.current
    if current is None or current.id not in begun or current.stops or current.label:
        return robot
    return know_stops(robot, current.id, (_stop_at(robot, pose),))


def with_queue(robot: Robot, at: float, fault: Message = EMPTY) -> Robot:
    """Compare the goals with the earlier ones like a queue; the message is latched, so no sign of life."""
    offset, last = robot.clock.offset if robot.clock else None, robot.orders.last_serial
    queue = queue_of(robot.goals, at, offset, last)
    report = events.QueueReported(robot.name, at, queue, fault)
    return replace(apply_report(robot, report), last_received=robot.last_received)


def _without_goals(robot: Robot, uuids: Collection[str], at: float) -> Robot:
    goals = without(robot.goals, uuids)
    return robot if goals == robot.goals else with_queue(replace(robot, goals=goals), at)


def without_unlisted(robot: Robot, since: float, now: float) -> Robot:
    """Drop the goals not reported since the link came up, at `since`: lists are latched, so an action server
    that lists none was restarted, and its goals are gone."""
    driven = robot.progress.value.goal if robot.progress and robot.progress.at >= since else ""
    gone = [goal.uuid for goal in active(robot.goals) if goal.listed_at < since and goal.id != driven]
    return _without_goals(robot, gone, now) if gone else robot


def without_ended(robot: Robot, now: float) -> Robot:
    """Drop the goals that ended a while ago: their action server sends no message for that."""
    if robot.queue is None or not any(order.is_over for order in robot.orders.orders):
        return robot
    offset, last = robot.clock.offset if robot.clock else None, robot.orders.last_serial
    queue = queue_of(robot.goals, now, offset, last)
    if len(queue.orders) == len(robot.orders.orders):
        return robot
    return replace(robot, queue=Reading(queue, robot.queue.at))


def know_stops(robot: Robot, order_id: str, stops: tuple[Stop, ...], is_ours: bool = False) -> Robot:
    """Record the target of a goal, which its action server does not report, and whether this console gave
    it."""
    goals = with_stops(robot.goals, order_id, stops, is_ours)
    if goals == robot.goals or robot.queue is None:
        return robot
    orders = tuple(
        replace(order, stops=stops, label="") if order.id == order_id else order
        for order in robot.orders.orders
    )
    traces = {
        id_: replace(trace, order=replace(trace.order, stops=stops)) if id_ == order_id else trace
        for id_, trace in robot.traces.items()
    }
    queue = replace(robot.queue.value, orders=orders)
    return replace(robot, goals=goals, traces=traces, queue=Reading(queue, robot.queue.at))


def _take_plan(robot: Robot, event: navigation_events.PlanReported) -> Robot:
    """Use the end of the path as the target of a goal of unknown target."""
    current = robot.orders.current
    if current is None or current.stops or current.label:
        return robot
    return know_stops(robot, current.id, (_stop_at(robot, event.end),))


def _stop_at(robot: Robot, pose: Pose) -> Stop:
    robot_map = robot.maps.get(robot.floor or "")
    vertices = robot_map.graph.vertices.values() if robot_map and robot_map.graph else ()
    near = [(math.dist((one.x, one.y), (pose.x, pose.y)), one.id) for one in vertices]
    metres, vertex = min(near, default=(math.inf, ""))
    return Stop(vertex) if metres <= AT_VERTEX else Stop(pose=pose)

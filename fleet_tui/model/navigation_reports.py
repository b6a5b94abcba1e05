"""Reports of navigating robots: how each one changes what is known of its robot."""

import math
from collections.abc import Collection
from typing import assert_never

from msgspec.structs import replace

from fleet_tui.model import events, navigation_events
from fleet_tui.model.bounds import LONGEST_NAME, brief
from fleet_tui.model.geometry import Pose
from fleet_tui.model.goals import active, queue_of, with_reported, with_stops, without
from fleet_tui.model.navigation import Blocked, Progress
from fleet_tui.model.order import Stop
from fleet_tui.model.reports import apply_report, set_clock
from fleet_tui.model.robot import Reading, Robot

AT_VERTEX = 0.5
"""Metres from a vertex within which a path ends at it."""


def apply_navigation(robot: Robot, event: navigation_events.Navigation) -> Robot:
    """Apply one report of a navigating robot to it."""
    match event:
        case navigation_events.OdometryReported():
            return _take_odometry(robot, event)
        case navigation_events.LocalisationReported():
            return _take_localisation(robot, event)
        case navigation_events.BlockedReported():
            before = robot.blocked
            goes_on = before is not None and before.value.action == event.action
            since = before.value.since if before is not None and goes_on else event.at
            blocked = Blocked(event.action, brief(event.polygon, LONGEST_NAME), since)
            return _heard(replace(robot, blocked=Reading(blocked, event.at)), event.at)
        case navigation_events.ProgressReported():
            progress = _merged(robot, event.progress)
            return _heard(replace(robot, progress=Reading(progress, event.at)), event.at)
        case navigation_events.GoalsReported():
            return _take_goals(robot, event)
        case navigation_events.GoalsUnknown():
            return _without_goals(robot, event.uuids, event.at)
        case navigation_events.PlanReported():
            return _take_plan(robot, event)
        case navigation_events.FloorReported():
            return replace(robot, own_floor=brief(event.floor, LONGEST_NAME))
        case navigation_events.Unmeasured():
            names = robot.unmeasured
            told = names if event.value in names else (*names, event.value)
            return _heard(replace(robot, unmeasured=told), event.at)
        case _:
            assert_never(event)


def _merged(robot: Robot, told: Progress) -> Progress:
    """Of a goal with several stops one message tells the stop, others how far its leg is."""
    if robot.progress is None:
        return told
    known = robot.progress.value
    if told.stop is not None:
        return replace(known, goal=told.goal, stop=told.stop)
    goals = (goal for listed in robot.goals.values() for goal in listed)
    is_leg = any(goal.id == told.goal and goal.is_leg for goal in goals)
    return replace(told, goal=known.goal, stop=known.stop) if is_leg else told


def _heard(robot: Robot, at: float) -> Robot:
    return replace(robot, heard=max(robot.heard or at, at))


def _take_odometry(robot: Robot, event: navigation_events.OdometryReported) -> Robot:
    """A robot moves as its wheels tell, from where its localisation put it last."""
    robot = replace(robot, odometry=event.pose)
    if robot.anchor is None and robot.located is not None:
        robot = replace(robot, anchor=robot.located.after(event.pose.inverse))
    if robot.anchor is None:
        # It lives, though nobody knows where.
        clock = robot.clock if event.stamp is None else set_clock(robot.clock, event.at, event.stamp)
        return _heard(replace(robot, clock=clock), event.at)
    placed = robot.anchor.after(event.pose)
    return apply_report(robot, events.PoseReported(robot.name, event.at, placed, robot.frame_id, event.stamp))


def _take_localisation(robot: Robot, event: navigation_events.LocalisationReported) -> Robot:
    """The last value is latched: it is no sign of life, and may be old. Where wheels tell, they say when the
    robot was there."""
    if event.variance is not None:
        robot = replace(robot, variance=Reading(event.variance, event.at))
    frame_id = brief(event.frame_id.lstrip("/"), LONGEST_NAME)
    robot = replace(robot, located=event.pose, frame_id=frame_id)
    if robot.odometry is not None:
        robot = replace(robot, anchor=event.pose.after(robot.odometry.inverse))
        return replace(robot, pose=Reading(event.pose, robot.pose.at)) if robot.pose else robot
    placed = events.PoseReported(robot.name, event.at, event.pose, frame_id, None)
    return replace(apply_report(robot, placed), heard=robot.heard)


def _take_goals(robot: Robot, event: navigation_events.GoalsReported) -> Robot:
    goals = with_reported(robot.goals, event.action, event.goals, event.at, not event.fault)
    return _with_queue(replace(robot, goals=goals), event.at, event.fault)


def _with_queue(robot: Robot, at: float, fault: str = "") -> Robot:
    """Compare the goals with those of before as a queue is compared; the message is latched, and no life."""
    queue = queue_of(robot.goals, at, robot.clock.offset if robot.clock else None)
    heard = robot.heard
    return replace(apply_report(robot, events.QueueReported(robot.name, at, queue, fault)), heard=heard)


def _without_goals(robot: Robot, uuids: Collection[str], at: float) -> Robot:
    goals = without(robot.goals, uuids)
    return robot if goals == robot.goals else _with_queue(replace(robot, goals=goals), at)


def without_unlisted(robot: Robot, since: float, now: float) -> Robot:
    """Let go the goals that nothing was heard of since the link came up, at `since`: lists are latched, so
    an action server that lists none was started anew, and its goals went with it."""
    heard = robot.progress.value.goal if robot.progress and robot.progress.at >= since else ""
    gone = [goal.uuid for goal in active(robot.goals) if goal.listed_at < since and goal.id != heard]
    return _without_goals(robot, gone, now) if gone else robot


def without_ended(robot: Robot, now: float) -> Robot:
    """Let go the goals that ended a while ago: no message of their action server tells it."""
    if robot.queue is None or not any(order.is_over for order in robot.orders.orders):
        return robot
    queue = queue_of(robot.goals, now, robot.clock.offset if robot.clock else None)
    if len(queue.orders) == len(robot.orders.orders):
        return robot
    return replace(robot, queue=Reading(queue, robot.queue.at))


def know_stops(robot: Robot, order_id: str, stops: tuple[Stop, ...], is_ours: bool = False) -> Robot:
    """Note where a goal leads to, which its action server does not tell, and whether this console gave it."""
    goals = with_stops(robot.goals, order_id, stops, is_ours)
    if goals == robot.goals or robot.queue is None:
        return robot
    orders = tuple(
        replace(order, stops=stops) if order.id == order_id else order for order in robot.orders.orders
    )
    traces = {
        id_: replace(trace, order=replace(trace.order, stops=stops)) if id_ == order_id else trace
        for id_, trace in robot.traces.items()
    }
    queue = replace(robot.queue.value, orders=orders)
    return replace(robot, goals=goals, traces=traces, queue=Reading(queue, robot.queue.at))


def _take_plan(robot: Robot, event: navigation_events.PlanReported) -> Robot:
    """The path ends where a goal of unknown target leads to."""
    current = robot.orders.current
    if current is None or current.stops or current.label:
        return robot
    return know_stops(robot, current.id, (_stop_at(robot, event.end),))


def _stop_at(robot: Robot, pose: Pose) -> Stop:
    chart = robot.charts.get(robot.floor or "")
    vertices = chart.graph.vertices.values() if chart and chart.graph else ()
    near = [(math.dist((one.x, one.y), (pose.x, pose.y)), one.id) for one in vertices]
    metres, vertex = min(near, default=(math.inf, ""))
    return Stop(vertex) if metres <= AT_VERTEX else Stop(pose=pose)

"""Reports of navigating robots: the effect of each on its robot."""

from typing import assert_never

from msgspec.structs import replace

from fleet_tui.model import events, navigation_events
from fleet_tui.model.navigation import STANDS_FOR, Blocked, Progress, ReportedMotion
from fleet_tui.model.robot import Logged, Reading, Robot
from fleet_tui.model.ros_logs import cause_of
from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.situation.movement import strayed
from fleet_tui.state.goal_reports import apply_goals, with_sign_of_life
from fleet_tui.state.reports import SiteClock, apply_report, clocked, relocation
from fleet_tui.text.language import verbatim
from fleet_tui.text.limits import LONGEST_NAME, truncate

LINES_KEPT = 100
REPEATED_WITHIN = 1.0
"""Lines kept of a robot's log, and the seconds within which a cause is told once: a controller repeats one
twenty times a second."""


def apply_navigation(
    robot: Robot, event: navigation_events.Navigation, site: SiteClock | None = None
) -> Robot:
    """Apply one report of a navigating robot to it; `site` dates the stamp of its first one."""
    if isinstance(event, navigation_events.OwnWord):
        return _take_word(robot, event)
    if isinstance(event, navigation_events.GoalFact):
        return apply_goals(robot, event)
    match event:
        case navigation_events.OdometryReported():
            return _take_odometry(robot, event, site)
        case navigation_events.LocalisationReported():
            return _take_localisation(robot, event, site)
        case navigation_events.OriginReported():
            return _take_origin(robot, event)
        case navigation_events.BlockedReported():
            before = robot.blocked
            goes_on = before is not None and before.value.action == event.action
            since = before.value.since if before is not None and goes_on else event.at
            blocked = Blocked(event.action, truncate(event.polygon, LONGEST_NAME), since)
            return with_sign_of_life(replace(robot, blocked=Reading(blocked, event.at)), event.at)
        case navigation_events.ProgressReported():
            progress = _merged(robot, event.progress)
            return with_sign_of_life(replace(robot, progress=Reading(progress, event.at)), event.at)
        case navigation_events.Alive():
            return with_sign_of_life(robot, event.at)
        case _:
            assert_never(event)


def _take_word(robot: Robot, event: navigation_events.OwnWord) -> Robot:
    match event:
        case navigation_events.ErrorReported():
            return _take_error(robot, event)
        case navigation_events.FloorReported():
            return replace(robot, own_floor=truncate(event.floor, LONGEST_NAME))
        case navigation_events.ModeReported():
            return replace(robot, mode=Reading(truncate(event.mode, LONGEST_NAME), event.at))
        case navigation_events.ServersReported():
            return _take_servers(robot, event)
        case navigation_events.Unmeasured():
            names = robot.unmeasured
            new = names if event.value in names else (*names, event.value)
            return with_sign_of_life(replace(robot, unmeasured=new), event.at)
        case _:
            assert_never(event)


def _take_servers(robot: Robot, event: navigation_events.ServersReported) -> Robot:
    before = robot.servers.value if robot.servers is not None else None
    servers = event.servers
    if servers is not None:
        goes_on = before is not None and before.is_active is servers.is_active
        servers = replace(servers, since=before.since if before is not None and goes_on else event.at)
    return replace(robot, servers=Reading(servers, event.at))


def _take_error(robot: Robot, event: navigation_events.ErrorReported) -> Robot:
    clock, at = robot.clock, event.at
    if clock is not None and event.stamp is not None:
        # A bridge sends the last lines again to who begins to listen.
        at = min(at, event.stamp + clock.offset)
    if event.is_diagnosed:
        return replace(robot, diagnosed=Reading(truncate(event.text), at))
    line = Logged(verbatim(truncate(event.text)), at, event.is_warning)
    cause = cause_of(line.text)
    if any(at - one.at < REPEATED_WITHIN and cause_of(one.text) == cause for one in robot.logged):
        return robot
    return replace(robot, logged=(*robot.logged, line)[-LINES_KEPT:])


def _merged(robot: Robot, new: Progress) -> Progress:
    """Merge progress messages: of a goal with several stops one gives the stop, others the distance on its
    leg."""
    if robot.progress is None:
        return new
    known = robot.progress.value
    if new.stop is not None:
        return replace(known, goal=new.goal, stop=new.stop)
    goals = (goal for listed in robot.goals.values() for goal in listed)
    is_leg = any(goal.id == new.goal and goal.is_leg for goal in goals)
    return replace(new, goal=known.goal, stop=known.stop) if is_leg else new


def _take_odometry(robot: Robot, event: navigation_events.OdometryReported, site: SiteClock | None) -> Robot:
    """Move a robot by its wheel odometry, from its last localised pose."""
    if event.speed is not None:
        robot = _with_motion(robot, event.speed, event.at)
    # Another odometry than that of the anchor drifts otherwise: it places nothing.
    is_other = event.is_transform != (robot.located_by == "transforms")
    if not is_other:
        robot = replace(robot, odometry=event.pose, odometry_at=event.at)
        if robot.anchor is None and robot.located is not None:
            robot = replace(robot, anchor=robot.located.after(event.pose.inverse))
    if robot.anchor is None or is_other:
        # It is alive, but its position is unknown.
        clock, _, spoke_at = clocked(robot, event.at, event.stamp, site)
        robot = replace(robot, clock=clock)
        return robot if spoke_at is None else with_sign_of_life(robot, spoke_at)
    placed = robot.anchor.after(event.pose)
    is_adrift = robot.located is not None and strayed(robot.located, placed)
    robot = replace(robot, adrift_at=(robot.adrift_at or event.at) if is_adrift else None)
    report = events.PoseReported(robot.name, event.at, placed, robot.frame_id, event.stamp)
    return apply_report(robot, report, site)


REST_METRES = 0.02
REST_RADIANS = 0.02
SMOOTHED_OVER = 1.0
MATTERS = 3.0
GAP = 5.0
"""Metres and radians per second below which a robot stands, seconds over which their noise is averaged, and
the multiple of them that counts: it must not take long to forget a drive. Seconds without a report after
which nobody knows what it did between."""


def _is_moving(speed: Speeds) -> bool:
    return speed.linear >= REST_METRES or abs(speed.turning) >= REST_RADIANS


def _mean(before: Reading[ReportedMotion] | None, speed: Speeds, at: float) -> Speeds:
    weight = 1.0 if before is None else min(1.0, (at - before.at) / SMOOTHED_OVER)
    known = Speeds() if before is None else before.value.mean
    limits = Speeds(REST_METRES, REST_METRES, REST_RADIANS)
    return Speeds(
        *(
            old + (max(-MATTERS * limit, min(MATTERS * limit, new)) - old) * weight
            for old, new, limit in zip(known, speed, limits, strict=True)
        )
    )


def _with_motion(robot: Robot, speed: Speeds, at: float) -> Robot:
    before = robot.motion
    mean = _mean(before, speed, at)
    # At rest speeds are noise about zero; one that brakes stands before the mean says so.
    is_moving = _is_moving(speed) and _is_moving(mean)
    if before is None and not is_moving:
        return robot
    is_same = before is not None and before.value.is_moving is is_moving and at - before.at <= GAP
    since = before.value.since if before is not None and is_same else at
    stood = before.value.stood if before is not None else None
    if not is_moving and at - since >= STANDS_FOR:
        stood = at
    return replace(robot, motion=Reading(ReportedMotion(is_moving, since, mean, stood), at))


def _take_origin(robot: Robot, event: navigation_events.OriginReported) -> Robot:
    """Place the odometry of a robot on its map as its transforms have it, unless a topic of its localisation
    does."""
    if robot.located_by == "topic":
        return robot
    odometry = robot.odometry if robot.located_by == "transforms" else None
    frame_id = truncate(event.frame_id, LONGEST_NAME)
    robot = replace(robot, anchor=event.origin, odometry=odometry, located_by="transforms", frame_id=frame_id)
    if odometry is None or event.is_fixed:
        return robot
    return replace(robot, located=event.origin.after(odometry), located_at=event.at)


WHEELS_UNHEARD = 2.0
"""Seconds after which the last odometry says nothing about the place of a new localised pose."""

REPEATED_POSE = 0.1
"""Seconds by which the pose of feedback must be newer than the one before."""

SCAN_DELAY = 0.3
"""Seconds by which a localised pose is stamped earlier: with the time of the scan that it is from."""


SETTLES_IN = 10.0
"""Seconds in which a localisation takes up a pose that was set by hand."""


def _true_at(robot: Robot, event: navigation_events.LocalisationReported, site: SiteClock | None) -> float:
    """Return the time of a localised pose: a latched one may be old."""
    known = robot.clock or site
    if event.stamp is None or known is None:
        return event.at
    return min(event.at, event.stamp + known.offset + SCAN_DELAY)


def _take_localisation(
    robot: Robot, event: navigation_events.LocalisationReported, site: SiteClock | None
) -> Robot:
    """Apply a localised pose. It is latched: no sign of life, and possibly old. With wheel odometry, that
    gives its time."""
    if event.is_feedback and robot.located_by in ("topic", "transforms"):
        return robot
    located_at = _true_at(robot, event, site)
    is_repeated = event.is_feedback and robot.located_by == "feedback" and robot.located_at is not None
    if is_repeated and located_at - (robot.located_at or 0.0) < REPEATED_POSE:
        return robot  # navigation has no newer one, and the wheels count on
    if robot.located_by == "transforms":
        robot = replace(robot, odometry=None, anchor=None)
    robot = replace(robot, located_by="feedback" if event.is_feedback else "topic")
    if event.variance is not None:
        is_settling = 0.0 <= located_at - robot.pose_set_at <= SETTLES_IN
        robot = replace(robot, variance=Reading(event.variance, located_at), is_settling=is_settling)
    frame_id = truncate(event.frame_id.lstrip("/"), LONGEST_NAME)
    jumped = relocation(robot, event.pose, frame_id, event.at)
    robot = replace(robot, located=event.pose, located_at=located_at, frame_id=frame_id)
    if robot.odometry is not None:
        # Wheels unheard for a while may have started anew from zero, as those of a restarted base: they count
        # from here on with their next message.
        heard = robot.odometry_at is None or event.at - robot.odometry_at <= WHEELS_UNHEARD
        anchor = event.pose.after(robot.odometry.inverse) if heard else None
        robot = replace(robot, anchor=anchor, relocated=jumped)
        return replace(robot, pose=Reading(event.pose, robot.pose.at)) if robot.pose else robot
    placed = events.PoseReported(robot.name, located_at, event.pose, frame_id, None)
    return replace(apply_report(robot, placed), last_received=robot.last_received)

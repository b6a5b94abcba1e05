"""Reports of fleet adapters: the effect of each on its robot."""

from typing import assert_never

from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.fleet import FleetState, with_robot
from fleet_tui.model.fleets.events import (
    FacilityReported,
    MemberFact,
    MemberReported,
    StatusReported,
    TaskReported,
)
from fleet_tui.model.fleets.facility import Facility
from fleet_tui.model.fleets.member import Member
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.state.clocks import site_clock
from fleet_tui.state.reports import SiteClock, apply_report, latest
from fleet_tui.state.task_reports import apply_task
from fleet_tui.text.limits import MOST_FACILITIES


def apply_member_fact(state: FleetState, event: MemberFact) -> FleetState:
    """Return the state after a report on a robot, known or not."""
    if isinstance(event, TaskReported):
        return apply_task(state, event)
    robot = state.robots.get(event.robot)
    if robot is None:
        return state
    match event:
        case FacilityReported():
            return _with_facility(state, replace(event.facility, link=robot.link))
        case MemberReported():
            return with_robot(state, _take_member(robot, event, site_clock(state, robot, event.at)))
        case StatusReported():
            return with_robot(state, _take_status(robot, event))
        case _:
            assert_never(event)


def _with_facility(state: FleetState, one: Facility) -> FleetState:
    if one.key not in state.facilities and len(state.facilities) >= MOST_FACILITIES:
        return state
    return replace(state, facilities={**state.facilities, one.key: one})


def _member(robot: Robot) -> Member:
    return robot.member.value if robot.member else Member()


def _take_member(robot: Robot, event: MemberReported, site: SiteClock | None) -> Robot:
    """Apply the report of a driver: all of it is as old as its stamp, the sign of life, too."""
    last = robot.last_received
    robot = apply_report(
        robot, events.PoseReported(robot.name, event.at, event.pose, event.floor, event.stamp), site
    )
    if event.stamp is not None and robot.pose is not None:
        spoke_at = None if robot.is_undated else robot.pose.at
        robot = replace(robot, last_received=latest(last, spoke_at))
    return _charged(_with_member(robot, replace(_member(robot), mode=event.mode, task=event.task)), event)


def _with_member(robot: Robot, member: Member) -> Robot:
    assert robot.pose is not None
    return replace(robot, member=Reading(member, robot.pose.at))


def _charged(robot: Robot, event: MemberReported | StatusReported) -> Robot:
    if event.percent is None or robot.pose is None:
        return robot
    return replace(robot, battery=Reading(event.percent, robot.pose.at))


def _take_status(robot: Robot, event: StatusReported) -> Robot:
    """Apply the report of an adapter. Its pose counts only for a robot without stamped ones: the adapter
    repeats the last one of a robot that is lost."""
    member = replace(_member(robot), status=event.status, task=event.task, issues=event.issues)
    is_stamped = robot.clock is not None
    if event.pose is not None and not is_stamped:
        placed = events.PoseReported(robot.name, event.at, event.pose, event.floor, None)
        return _charged(_with_member(apply_report(robot, placed), member), event)
    return replace(robot, member=Reading(member, event.at))

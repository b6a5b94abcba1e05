"""Facts about the localisation of a robot: it is uncertain, or gives no pose."""

import math

from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import NO_POSE, UNCERTAIN
from fleet_tui.situation.links import bridge_remedy
from fleet_tui.situation.navigation import NO_ODOMETRY, inactive
from fleet_tui.text.language import Message
from fleet_tui.text.units import age

LOST_ABOVE = 0.5
FOUND_BELOW = 0.3
"""Variance of x and y in square metres above which localisation is lost, and below which it is back."""
USUAL = 0.75
"""Variance that a localisation may report just after a pose was set by hand: about the 0.5 that come with it.
One that stands then reports no other until it drives."""


def uncertain(robot: Robot, limit: float = LOST_ABOVE) -> Fact | None:
    """Find that a localisation is too uncertain to drive by: not by what was only set here."""
    found = robot.variance
    if found is None or found.value <= limit or (found.value <= USUAL and robot.is_settling):
        return None
    metres = 2.0 * math.sqrt(found.value)
    return Fact(
        UNCERTAIN,
        robot.name,
        Message("{word}: within {metres} m", word=UNCERTAIN.word, metres=f"{metres:.1f}"),
        Priority.MEDIUM,
        found.at,
        short=Message("pose uncertain"),
        evidence=Message("within {metres} m, as its localisation says", metres=f"{metres:.1f}"),
        seen=found.at,
    )


def no_pose(state: FleetState, robot: Robot) -> Fact | None:
    """Find that a robot that reports its pose gives none, or none any more. Navigation that is not active
    says which one it waits for."""
    if "pose" not in robot.kind.reports or state.is_fresh(robot, "pose"):
        return None
    remedy = bridge_remedy(state, robot, robot.kind.pose_topic)
    if robot.pose is not None:
        text = Message("pose {age} old", age=age(state.now - robot.pose.at))
        since, evidence = robot.pose.at, Message("other reports arrive: the robot may have moved since")
        if _lacks_odometry(state, robot):
            topic = robot.kind.odometry_topic.replace("{robot}", robot.name)
            evidence = Message("no odometry on {topic}: the robot may have moved since", topic=topic)
            remedy = bridge_remedy(state, robot, robot.kind.odometry_topic) or NO_ODOMETRY
    elif inactive(state, robot) is None:
        topic = robot.kind.pose_topic.replace("{robot}", robot.name)
        text = NO_POSE.word
        since = state.began.get((robot.name, NO_POSE.name), state.now)
        evidence = Message(
            "other reports received, no pose{topic}: position unknown",
            topic=topic and Message(" on {topic}", topic=topic),
        )
    else:
        return None
    return Fact(
        NO_POSE, robot.name, text, Priority.MEDIUM, since, remedy=remedy, short=text, evidence=evidence
    )


def _lacks_odometry(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot that is placed by its odometry sends none: then its pose is old, not wrong."""
    if not robot.kind.odometry_topic or robot.located is None:
        return False
    silence = robot.kind.silence_of("pose", state.limits.offline_after) + state.behind
    return robot.odometry_at is None or state.now - robot.odometry_at > silence

"""Facts about the servers that drive a robot: whether they are active, and what they wait for."""

import re

from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation import DOWN, Servers
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import INACTIVE

NO_ODOMETRY = "Check its wheel odometry: the node of its base, the topic's name"
ASKED_WITHIN = 30.0
LOGGED_WITHIN = 60.0
"""Seconds for which an answer about the servers counts, which are asked every few seconds, and a line of the
log: the one that all are active again is no warning, and not read."""
_BOND_BROKEN = re.compile(r"SERVER (\w+) IS DOWN")
"""What the lifecycle manager logs of a node whose bond is broken."""


def inactive_cause(servers: Servers, is_counted: bool, is_placed: bool) -> tuple[str, str]:
    """Return why servers are not active, and what to do: a node that is down, else what they wait for as they
    start. `is_counted`: the robot has odometry, `is_placed`: a pose on the map."""
    if servers.state == DOWN:
        return f"{servers.node} down", f"Start {servers.node} again, then all of Nav2: see its log"
    if not is_counted:
        return "no odometry", NO_ODOMETRY
    if not is_placed:
        return "no pose yet: set one", "Set its pose: its navigation waits for it"
    if servers.node:
        return f"{servers.node} {servers.state}", f"See the log of {servers.node}, or start Nav2 again"
    return "paused or not started", "Start it: by RViz's Nav2 panel, or nav2_bringup with autostart"


def _logged(robot: Robot) -> Reading[Servers] | None:
    """Return the node whose end the lifecycle manager logged, for a console that may ask nobody."""
    for line in reversed(robot.logged):
        if found := _BOND_BROKEN.search(line.text):
            return Reading(Servers(False, found[1], DOWN, line.at), line.at)
    return None


def inactive(state: FleetState, robot: Robot) -> Fact | None:
    """Find that the servers that drive a robot are not active: they reject every goal."""
    answered, logged = robot.servers, _logged(robot)
    if answered is not None and state.now - answered.at <= ASKED_WITHIN:
        told, evidence = answered, "its lifecycle manager says so: every goal is rejected"
    elif logged is not None and state.now - logged.at <= LOGGED_WITHIN:
        told, evidence = logged, "the log of its lifecycle manager says so"
    else:
        return None
    if told.value.is_active or not state.is_online(robot):
        return None
    servers = told.value
    is_counted = not robot.kind.odometry_topic or robot.odometry_at is not None
    cause, remedy = inactive_cause(servers, is_counted, robot.pose is not None)
    return Fact(
        INACTIVE,
        robot.name,
        f"{INACTIVE.word}: {cause}",
        Priority.MEDIUM,
        servers.since,
        remedy=remedy,
        evidence=evidence,
        seen=told.at,
    )

"""Facts about the servers that drive a robot: whether they are active, and what they wait for."""

import math
import re

from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.navigation import DOWN, Servers
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import INACTIVE, NAVIGATION_SILENT
from fleet_tui.text.language import Message
from fleet_tui.text.units import age

NO_ODOMETRY = Message("Check its wheel odometry: the node of its base, the topic's name")
LOGGED_WITHIN = 60.0
"""Seconds for which a line of the log counts: the one that all are active again is no warning, and not
read."""
_BOND_BROKEN = re.compile(r"SERVER (\w+) IS DOWN")
"""What the lifecycle manager logs of a node whose bond is broken."""


def inactive_cause(servers: Servers, is_counted: bool, is_placed: bool) -> tuple[Message, Message]:
    """Return why servers are not active, and what to do: a node that is down, else what they wait for as they
    start. `is_counted`: the robot has odometry, `is_placed`: a pose on the map."""
    if servers.state == DOWN:
        return Message("{node} down", node=servers.node), Message(
            "Start {node} again, then all of Nav2: see its log", node=servers.node
        )
    if not is_counted:
        return Message("no odometry"), NO_ODOMETRY
    if not is_placed:
        return Message("no pose yet: set one"), Message("Set its pose: its navigation waits for it")
    if servers.node:
        return Message("{node} {state}", node=servers.node, state=servers.state), Message(
            "See the log of {node}, or start Nav2 again", node=servers.node
        )
    return Message("paused or not started"), Message(
        "Start it: by RViz's Nav2 panel, or nav2_bringup with autostart"
    )


def _logged(robot: Robot) -> Reading[Servers | None] | None:
    """Return the node whose end the lifecycle manager logged, for a console that may ask nobody."""
    for line in reversed(robot.logged):
        if found := _BOND_BROKEN.search(line.text):
            return Reading(Servers(False, found[1], DOWN, line.at), line.at)
    return None


def inactive(state: FleetState, robot: Robot) -> Fact | None:
    """Find that the servers that drive a robot are not active: they reject every goal."""
    told, logged = robot.servers, _logged(robot)
    if told is not None and told.value is not None and state.is_fresh(robot, "servers"):
        evidence = Message("its lifecycle manager says so: every goal is rejected")
    elif logged is not None and state.now - logged.at <= LOGGED_WITHIN:
        told, evidence = logged, Message("the log of its lifecycle manager says so")
    else:
        return None
    servers = told.value
    if servers is None or servers.is_active or not state.is_online(robot):
        return None
    is_counted = not robot.kind.odometry_topic or robot.odometry_at is not None
    cause, remedy = inactive_cause(servers, is_counted, robot.pose is not None)
    return Fact(
        INACTIVE,
        robot.name,
        Message("{word}: {cause}", word=INACTIVE.word, cause=cause),
        Priority.MEDIUM,
        servers.since,
        remedy=remedy,
        evidence=evidence,
        seen=told.at,
    )


CEASED_AFTER = 10.0
"""Seconds without feedback, which comes many times a second while a goal is driven, until it has ceased."""
NO_FEEDBACK = Message(
    "no feedback on its order, while the robot itself reports: its navigation server has probably crashed, or"
    " was stopped"
)
NO_LIST = Message(
    "its goals are not listed any more, while the robot itself reports: its navigation server has probably"
    " crashed, or was stopped"
)


def silent_navigation(state: FleetState, robot: Robot) -> Fact | None:
    """Find that the server that drives a robot says nothing of its order any more, though the robot reports:
    it crashed, or was stopped. That it answers again ends it only with a movement."""
    order, ceased = robot.orders.current, _ceased(state, robot)
    if ceased is not None and order is not None:
        since, evidence = ceased
        text = Message(
            "navigation silent for {age} ({order_text})",
            age=age(state.now - since),
            order_text=robot.order_text(order),
        )
    elif _is_unsteady(state, robot) and robot.place is not None:
        since = robot.place.at
        text = Message("navigation repeatedly silent, no movement for {age}", age=age(state.now - since))
        evidence = Message(
            "it answers each order for a moment, and the robot does not move:"
            " its navigation server has probably crashed each time"
        )
    else:
        return None
    return Fact(
        NAVIGATION_SILENT,
        robot.name,
        text,
        Priority.MEDIUM,
        since,
        short=NAVIGATION_SILENT.word,
        evidence=evidence,
    )


def _ceased(state: FleetState, robot: Robot) -> tuple[float, Message] | None:
    """Return the time (monotonic) since which a robot that reports otherwise gives no feedback on its current
    order, or lists none; None while it does, if it never did, and if silence has another cause."""
    order, link = robot.orders.current, state.links[robot.link]
    if order is None or link.phase is not Phase.UP:
        return None
    if not state.is_online(robot) or not state.is_fresh(robot, "pose"):
        return None
    if robot.queue is not None and robot.kind.keeps_goals and state.is_old(robot, "queue"):
        return max(robot.queue.at, link.since), NO_LIST
    if math.isinf(robot.kind.silence_of("progress", 0.0)):
        return None  # sent on change only
    if robot.progress is None or robot.progress.value.goal != order.id:
        return None
    since = max(robot.progress.at, link.since)
    return (since, NO_FEEDBACK) if state.now - since - state.behind >= CEASED_AFTER else None


def _is_unsteady(state: FleetState, robot: Robot) -> bool:
    """Tell whether its navigation fell silent and it has not moved since: a server that is started again
    answers each new order for a moment, and crashes again."""
    began, place = state.began.get((robot.name, "navigation")), robot.place
    return began is not None and place is not None and place.at <= began and bool(robot.orders.open)

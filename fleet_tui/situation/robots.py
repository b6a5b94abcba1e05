"""Facts about robots: what they say, and whether they say anything."""

from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import CONTACT, FleetState, obstacle_text, offline_text
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.model.navigation import blocked_text
from fleet_tui.model.robot import Robot
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import BAD_DATA, OBSTACLE, SILENT, STOP

BAD_FOR = 10.0
"""Seconds without bad data until it counts as over."""


def silent_from(state: FleetState, robot: Robot) -> float:
    """Return the monotonic second from which a robot counts as silent, if it sends nothing until then. What
    its bridge is late by may still be on its way; a new link restarts the silence of all its robots."""
    last, link = robot.last_received, state.links[robot.link]
    if robot.is_gone and robot.connection is not None and last is not None:
        return robot.connection.at
    return max(last or 0.0, link.ready_since) + state.patience(robot) + link.late


def silent(state: FleetState, robot: Robot) -> Fact | None:
    """Find that a robot has stopped speaking, or never did: while its link is up, and whatever its bridge is
    late by. One that sends only what nobody can read does speak."""
    since = silent_from(state, robot)
    if state.links[robot.link].phase is not Phase.UP or state.now <= since or is_unreadable(state, robot):
        return None
    return Fact(SILENT, robot.name, offline_text(state, robot), Priority.MEDIUM, since)


def is_unreadable(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot sends, and nothing that can be read: then it is not silent, and its power and its
    network are well."""
    if robot.fault_at is None or state.is_online(robot) or state.links[robot.link].phase is not Phase.UP:
        return False
    return state.now - robot.fault_at <= state.patience(robot)


def bad_data(state: FleetState, source: Robot | LinkState) -> Fact | None:
    """Find unreadable data from a robot or over a link, a short while ago."""
    if source.fault_at is None or state.now - source.fault_at >= BAD_FOR:
        return None
    is_all = isinstance(source, Robot) and is_unreadable(state, source)
    text = f"bad data x{source.faults}: {source.last_fault}"
    if is_all:
        text = f"all messages are bad, {source.faults} so far: {source.last_fault}"
    return Fact(BAD_DATA, source.name, text, Priority.MEDIUM if is_all else Priority.LOW, source.fault_at)


def bad_text(source: Robot | LinkState) -> str:
    """Return the short text of bad data."""
    return f"bad data x{source.faults}"


def absence_text(state: FleetState, robot: Robot) -> str:
    """Return the short text of a robot that is not online: why nothing is known of it."""
    return bad_text(robot) if is_unreadable(state, robot) else offline_text(state, robot)


def has_old_stamps(state: FleetState, robot: Robot) -> bool:
    """Tell whether poses of a robot arrive, and their stamps are old: its localisation is slow, or stands and
    its last pose is repeated."""
    if robot.clock is None or not state.is_online(robot) or not state.is_old(robot, "pose"):
        return False
    silence = robot.kind.silence_of("pose", state.limits.offline_after)
    return state.now - robot.clock.at <= silence + state.behind


def repeats_pose_at_rest(state: FleetState, robot: Robot) -> bool:
    """Tell whether poses with old stamps mean nothing: many localisations give a pose only after a movement,
    and the last one is repeated for as long as a robot without an order stands."""
    return robot.orders.current is None and has_old_stamps(state, robot)


def last_contact(state: FleetState, robot: Robot) -> Fact | None:
    """Find lasting contact with an obstacle, by its last report."""
    report = robot.obstacle
    if report is None or report.value <= _lasting(state):
        return None
    text, since = obstacle_text(state, robot, report), report.at - report.value
    return Fact(OBSTACLE, robot.name, text, Priority.HIGH, since)


def last_stop(state: FleetState, robot: Robot) -> Fact | None:
    """Find a lasting stop by its collision monitor or protective field, by its last report."""
    report = robot.blocked
    if report is None or not report.value.is_stopped or state.now - report.value.since <= _lasting(state):
        return None
    return Fact(STOP, robot.name, blocked_text(report.value, state.now), Priority.HIGH, report.value.since)


def _lasting(state: FleetState) -> float:
    return min(CONTACT, state.limits.obstacle_after)


def obstacle(state: FleetState, robot: Robot) -> Fact | None:
    """Find an obstacle that blocks a robot, by a fresh report: contact or a stop of a few seconds. Its alarm,
    which wants an acknowledgement, waits `obstacle_after`."""
    found = (last_contact(state, robot), last_stop(state, robot))
    return next((fact for fact in found if fact is not None and is_fresh(state, robot, fact)), None)


def is_blocked_for_long(state: FleetState, robot: Robot) -> bool:
    """Tell whether an obstacle blocks a robot for long enough to be an alarm."""
    fact = obstacle(state, robot)
    return fact is not None and state.now > fact.since + state.limits.obstacle_after


def is_fresh(state: FleetState, robot: Robot, fact: Fact) -> bool:
    """Tell whether the report of an obstacle, which is named as its fact, still holds."""
    return state.is_fresh(robot, fact.kind.name)


def blocked_robots(state: FleetState) -> list[str]:
    """Return the names of the robots that obstacles block."""
    return [name for name, robot in state.robots.items() if obstacle(state, robot) is not None]

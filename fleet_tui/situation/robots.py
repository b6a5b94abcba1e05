"""Facts about robots."""

from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import FleetState, offline_text
from fleet_tui.model.link import Phase
from fleet_tui.model.robot import Robot
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import SILENT


def silent_from(state: FleetState, robot: Robot) -> float:
    """Return the monotonic second from which a robot counts as silent, if it sends nothing until then. What
    its bridge is late by may still be on its way; a new link restarts the silence of all its robots."""
    last, link = robot.last_received, state.links[robot.link]
    if robot.is_gone and robot.connection is not None and last is not None:
        return robot.connection.at
    return max(last or 0.0, link.ready_since) + state.patience(robot) + link.late


def silent(state: FleetState, robot: Robot) -> Fact | None:
    """Find that a robot has stopped speaking, or never did: while its link is up, and whatever its bridge is
    late by."""
    since = silent_from(state, robot)
    if state.links[robot.link].phase is not Phase.UP or state.now <= since:
        return None
    return Fact(SILENT, robot.name, offline_text(state, robot), Priority.MEDIUM, since)

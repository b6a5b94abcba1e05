"""The clock of a site: dates the first message of a robot, whose own clock may be any, and paces others."""

import math
import statistics

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.state.reports import SiteClock

BROKER = ("mqtt://", "mqtts://")
DRIFT_HOLDS = 10.0
"""Seconds after the last answer of a bridge for which the pace of its site's clock is still as it was."""


def site_clock(state: FleetState, robot: Robot, at: float) -> SiteClock | None:
    """Return the clock of a robot's site, as its bridge tells it, else as most other robots have it; None if
    nothing tells, or if only others do and its own clock runs. A broker marks messages that it has kept: all
    others are new, whatever their stamps."""
    link = state.links[robot.link]
    if link.clock is not None and link.clock_at >= link.since:
        since = link.drift * min(at - link.clock_at, DRIFT_HOLDS)
        return SiteClock(link.clock + since, link.late, link.drifted + since)
    if robot.clock is not None and robot.clock.is_running:
        return None
    if link.url.startswith(BROKER):
        return SiteClock(math.inf)
    others = (one.clock for one in state.robots.values() if one.link == robot.link)
    offsets = [clock.offset for clock in others if clock is not None and clock.is_running]
    return SiteClock(statistics.median(offsets), link.late) if offsets else None

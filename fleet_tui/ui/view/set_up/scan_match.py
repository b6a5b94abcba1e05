"""The match of a watched scan with the map shown, at the pose where its robot was at that time."""

from fleet_tui.commands.set_up.checks import map_of
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import SCAN
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.streams import Beams
from fleet_tui.situation.pose_checks.match import Match, match
from fleet_tui.state.streams import Streams

FRESH = 1.0
"""Seconds after which a scan is not the present one any more."""
OLD = 2.0
"""Seconds after which a scan proves nothing."""


def newest_beams(state: FleetState, robot: Robot, streams: Streams) -> Beams | None:
    """Return the newest scan of a robot, None if it is not watched or old."""
    streamed = streams.get(robot.name, SCAN)
    if streamed is None or not isinstance(streamed.value, Beams) or state.now - streamed.at > OLD:
        return None
    return streamed.value


def is_old(state: FleetState, robot: Robot, streams: Streams) -> bool:
    """Tell whether newer scans should have come since the newest."""
    streamed = streams.get(robot.name, SCAN)
    return streamed is None or state.now - streamed.at > FRESH


def scan_pose(robot: Robot, streams: Streams) -> Pose | None:
    """Return the pose at which the newest scan was taken, None if it is unknown."""
    streamed = streams.get(robot.name, SCAN)
    return None if streamed is None else streams.pose_at(robot.name, streamed.taken_at)


def scan_match(
    state: FleetState, robot: Robot, floor: str, streams: Streams, pose: Pose | None = None
) -> Match | None:
    """Return the match of the newest scan with the map of a floor: at a candidate pose, by default at the
    one where it was taken. None if a part of it is unknown."""
    beams, at = newest_beams(state, robot, streams), pose or scan_pose(robot, streams)
    grid = map_of(state, robot, floor)
    if beams is None or at is None or grid is None:
        return None
    return match(grid, beams.points, at)

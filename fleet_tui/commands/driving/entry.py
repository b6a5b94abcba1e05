"""The conditions under which a robot may be driven by hand, before a drive and all through it."""

from fleet_tui.commands.set_up.checks import busy
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import DRIVE
from fleet_tui.model.link import Phase
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message

POSE_WITHIN = 1.0
"""Seconds that a pose may be old."""


def drive_refusal(state: FleetState, robot: Robot) -> Message:
    """Return the reason not to drive a robot by hand, empty if it may be driven. Mapping is none: a map is
    made by driving."""
    if not robot.kind.can(DRIVE):
        return robot.kind.lack(DRIVE)
    link = state.links[robot.link]
    if link.phase is not Phase.UP:
        return Message("no link to {name}: wait for it", name=robot.name)
    if robot.pose is None or state.now - robot.pose.at > POSE_WITHIN + state.behind:
        return Message(
            "no pose of {name} within {seconds} s: it can't be seen driving",
            name=robot.name,
            seconds=f"{POSE_WITHIN:g}",
        )
    return next((problem.text for problem in busy(state, robot)), EMPTY)

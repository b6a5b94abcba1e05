"""Refinement of a pose at rest, call by call: the change by each, and the call after which it is enough."""

import math
from collections.abc import Sequence

from fleet_tui.commands.set_up.confirmation import believed, difference, difference_text
from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import Robot
from fleet_tui.text.language import EMPTY, Message, counted

SAME = 0.02
SAME_TURN = math.radians(1.0)
"""Metres and radians within which a pose counts as unchanged: a particle filter at rest jitters."""


def pose_since(robot: Robot, sent_at: float) -> Pose | None:
    """Return the newest pose that a robot reported after a call, None if it reported none."""
    found = believed(robot)
    return found.value if found is not None and found.at > sent_at else None


def is_settled(poses: Sequence[Pose | None]) -> bool:
    """Tell whether the last call left the pose unchanged. `poses`: the one before the first call, then the
    one after each call; None for no report."""
    before, after = poses[-2:]
    if before is None or after is None:
        return False
    metres, turn = difference(before, after)
    return metres <= SAME and turn <= SAME_TURN


def settling_text(poses: Sequence[Pose | None]) -> Message:
    """Return the number of calls and their effect in words."""
    calls, (before, after) = counted("{count} call", "{count} calls", len(poses) - 1), poses[-2:]
    if after is None:
        return Message("{calls}, no pose reported since", calls=calls)
    if before is None or poses[0] is None:
        return Message("{calls}, pose reported", calls=calls)
    still = EMPTY if is_settled(poses) else Message("still ")
    last = (
        Message(
            ", {still}by {difference_text} at the last",
            still=still,
            difference_text=difference_text(before, after),
        )
        if len(poses) > 2
        else ""
    )
    return Message(
        "{calls}, pose changed by {difference_text}{last}",
        calls=calls,
        difference_text=difference_text(poses[0], after),
        last=last,
    )

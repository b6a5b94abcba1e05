"""The pose where a simulated robot believes to be."""

import math

from fleet_tui.model.geometry import Pose

# metres and radians within which it finds its true pose
CAUGHT = 0.5
CAUGHT_TURN = math.radians(15.0)
DRIFT = Pose(3.0, 2.5, 0.7)  # metres and radians by which `mislocalised` is off


class Belief:
    """A robot's belief of its pose: the true one, until it is misplaced."""

    def __init__(self) -> None:
        self.misplaced: Pose | None = None
        """The pose where it believes to be, None if that is where it is."""

    def of(self, true: Pose) -> Pose:
        """Return the pose where it believes to be."""
        return self.misplaced or true

    def place(self, pose: Pose, true: Pose) -> None:
        """Take its pose from outside: near the true one its localisation finds that."""
        turn = abs(math.remainder(pose.yaw - true.yaw, math.tau))
        metres = math.dist((pose.x, pose.y), (true.x, true.y))
        self.misplaced = None if metres <= CAUGHT and turn <= CAUGHT_TURN else pose

    def carry(self, before: Pose, true: Pose) -> None:
        """Move the belief as the robot moved from a true pose to another."""
        if self.misplaced is not None and true != before:
            self.misplaced = self.misplaced.after(before.inverse.after(true))

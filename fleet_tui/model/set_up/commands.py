"""Set-up commands: the pose of a robot, a goal beside its orders, its mapping mode."""

import math
from typing import ClassVar

from msgspec import Struct

from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import GOAL, LOCALISE, MAPPING, POSE, SETTLE


def heading_text(pose: Pose) -> str:
    """Return a pose with its heading: metres, and degrees counter-clockwise."""
    degrees = round(math.degrees(math.remainder(pose.yaw, math.tau))) if math.isfinite(pose.yaw) else pose.yaw
    return f"({pose.x:.2f}, {pose.y:.2f}) {degrees}°"


class SetUpCommand(Struct, frozen=True):
    """Any set-up command. `ability` is the one that a robot needs for it, `what` its name in the audit
    log."""

    ability: ClassVar[str] = ""
    what: ClassVar[str] = ""

    robot: str

    @property
    def place(self) -> Pose | None:
        """Return the pose that it names, None for none."""
        return None

    @property
    def text(self) -> str:
        """Return the command in words, without the robot."""
        return f"{self.what} {heading_text(self.place)}" if self.place else self.what


class SetPose(SetUpCommand, frozen=True, tag=True):
    """Tell a robot its pose on the map of a floor."""

    ability: ClassVar[str] = POSE
    what: ClassVar[str] = "set pose"

    floor: str
    pose: Pose

    @property
    def place(self) -> Pose:
        """Return the pose to set."""
        return self.pose


class Localise(SetUpCommand, frozen=True, tag=True):
    """Let a robot find its pose anew, anywhere on its map."""

    ability: ClassVar[str] = LOCALISE
    what: ClassVar[str] = "localise"


class Settle(SetUpCommand, frozen=True, tag=True):
    """Let a robot at rest refine its pose once by its laser."""

    ability: ClassVar[str] = SETTLE
    what: ClassVar[str] = "settle"


class SendGoal(SetUpCommand, frozen=True, tag=True):
    """Send a robot to a pose, beside the queue of orders that it keeps."""

    ability: ClassVar[str] = GOAL
    what: ClassVar[str] = "go to"

    floor: str
    pose: Pose

    @property
    def place(self) -> Pose:
        """Return the goal."""
        return self.pose


class SetMapping(SetUpCommand, frozen=True, tag=True):
    """Switch the mapping mode of a robot."""

    ability: ClassVar[str] = MAPPING
    what: ClassVar[str] = "mapping"

    on: bool

    @property
    def text(self) -> str:
        """Return the command in words, without the robot."""
        return f"mapping {'on' if self.on else 'off'}"


SetUp = SetPose | Localise | Settle | SendGoal | SetMapping

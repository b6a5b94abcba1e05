"""Events of fleets. `at` is the monotonic second at which the event reached this console.

Fleet adapters send on a timer, whether their robots are alive or not: only a robot's own stamp is a sign of
life.
"""

from msgspec import Struct

from fleet_tui.model.commands import Stage
from fleet_tui.model.fleets.facility import Facility
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal


class MemberReported(Struct, frozen=True, tag=True):
    """A robot by its driver: `stamp` is the driver's clock at its last update, None if it never gave one.
    `percent` is its charge, None if unknown."""

    robot: str
    at: float
    pose: Pose
    floor: str
    stamp: float | None
    percent: float | None
    mode: str
    task: str


class StatusReported(Struct, frozen=True, tag=True):
    """A robot by its fleet adapter, which does not say how old the pose is; None: not reported."""

    robot: str
    at: float
    status: str
    task: str
    issues: tuple[str, ...]
    pose: Pose | None = None
    floor: str = ""
    percent: float | None = None


class TaskReported(Struct, frozen=True, tag=True):
    """A task of a robot, as a goal with its name; `seconds` are estimated until its end."""

    robot: str
    at: float
    task: Goal
    seconds: float | None = None


class RequestAnswered(Struct, frozen=True, tag=True):
    """The answer to a request of any console, by its id: ACCEPTED or REFUSED with the reason. `task` is the
    id of the task that it made, empty for none."""

    request: str
    at: float
    stage: Stage
    detail: str = ""
    task: str = ""


class DispatchFailed(Struct, frozen=True, tag=True):
    """A task for which the dispatcher found no robot, or that was cancelled before it had one."""

    task: str
    at: float
    reason: str
    is_cancelled: bool = False


class FacilityReported(Struct, frozen=True, tag=True):
    """A lift, a door, a dispenser, an ingestor or the lanes of a fleet, at the site of a robot."""

    robot: str
    at: float
    facility: Facility


DispatchFact = RequestAnswered | DispatchFailed
MemberFact = MemberReported | StatusReported | TaskReported | FacilityReported

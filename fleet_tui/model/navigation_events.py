"""Events of navigating robots and the orders that wait for them. `at` is the monotonic second at which the
event reached this console."""

from msgspec import Struct, field

from fleet_tui.model.commands import Stage
from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal, Progress, Servers
from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.text.language import EMPTY, Message


class OdometryReported(Struct, frozen=True, tag=True):
    """A robot's pose by wheel odometry, in its own drifting frame. `is_transform`: as its transforms have it,
    which may be another one than that of its topic; `speed` is None if it gives none."""

    robot: str
    at: float
    pose: Pose
    stamp: float | None
    is_transform: bool = False
    speed: Speeds | None = None


class OriginReported(Struct, frozen=True, tag=True):
    """The origin of a robot's odometry on its map, as its localisation corrects it in the transforms; one
    that `is_fixed` never is."""

    robot: str
    at: float
    origin: Pose
    frame_id: str
    is_fixed: bool = False


class LocalisationReported(Struct, frozen=True, tag=True):
    """A robot's last localised pose on its map. `variance`: of x and y together, in square metres, None if it
    gives none. `is_feedback`: it comes with the feedback on a goal, and counts until another one comes."""

    robot: str
    at: float
    pose: Pose
    frame_id: str
    stamp: float | None
    variance: float | None
    is_feedback: bool = False


class BlockedReported(Struct, frozen=True, tag=True):
    """State of a collision monitor: `action` is empty if it does not hold the robot back."""

    robot: str
    at: float
    action: str
    polygon: str


class ProgressReported(Struct, frozen=True, tag=True):
    """Progress of a goal."""

    robot: str
    at: float
    progress: Progress


class GoalsReported(Struct, frozen=True, tag=True):
    """All goals that an action server lists, oldest first; `fault` describes those that were dropped."""

    robot: str
    at: float
    action: str
    goals: tuple[Goal, ...]
    fault: Message = EMPTY


class GoalsUnknown(Struct, frozen=True, tag=True):
    """Active goals, by their ids on the wire, that their action server reports as unknown."""

    robot: str
    at: float
    uuids: tuple[str, ...]


class MotionStopped(Struct, frozen=True, tag=True):
    """A pause of this console ended a motion that was no order, such as `spin`."""

    robot: str
    at: float
    motion: str


class ServersReported(Struct, frozen=True, tag=True):
    """Whether the servers that drive a robot are active, None if nothing tells; `servers.since` is that of
    this report."""

    robot: str
    at: float
    servers: Servers | None


class PlanReported(Struct, frozen=True, tag=True):
    """The end of the path that a robot drives now."""

    robot: str
    at: float
    end: Pose


class TargetReported(Struct, frozen=True, tag=True):
    """The target of a goal that a robot has just begun, from any client."""

    robot: str
    at: float
    pose: Pose


class Alive(Struct, frozen=True, tag=True):
    """A robot's sign of life."""

    robot: str
    at: float


class ErrorReported(Struct, frozen=True, tag=True):
    """An error that a robot reports about itself, in its diagnostics or in its log, or a warning there: no
    sign of life, for a log is latched; `stamp` is that of its clock, if it gives one."""

    robot: str
    at: float
    text: str
    is_diagnosed: bool = False
    stamp: float | None = None
    is_warning: bool = False


class FloorReported(Struct, frozen=True, tag=True):
    """The floor a robot is on, as it reports."""

    robot: str
    at: float
    floor: str


class ModeReported(Struct, frozen=True, tag=True):
    """The mode of a robot: `mapping`, `navigation`, or its own word."""

    robot: str
    at: float
    mode: str


class Unmeasured(Struct, frozen=True, tag=True):
    """The robot reports that it does not measure a value, a field of Robot."""

    robot: str
    at: float
    value: str


class GoalAnswered(Struct, frozen=True, tag=True):
    """The end of a goal as the robot answered to this console: DONE or FAILED, with its text."""

    id: int
    stage: Stage
    at: float
    detail: str = field(default="", name="words")  # as recordings have it


class QueueHeld(Struct, frozen=True, tag=True):
    """The orders that this console keeps for a robot are held until the operator releases them."""

    robot: str
    reason: Message


class OrderMoved(Struct, frozen=True, tag=True):
    """The operator moved an order that waits here before another one, at the end if `before` is empty."""

    robot: str
    order_id: str
    before: str
    at: float


QueueChange = QueueHeld | OrderMoved
OwnWord = ErrorReported | FloorReported | ModeReported | ServersReported | Unmeasured
GoalFact = GoalsReported | GoalsUnknown | MotionStopped | PlanReported | TargetReported
Place = OdometryReported | LocalisationReported | OriginReported
Navigation = Place | BlockedReported | ProgressReported | GoalFact | Alive | OwnWord
Live = OdometryReported | BlockedReported | ProgressReported | Unmeasured | TargetReported | Alive
"""Signs of life: the others are latched."""

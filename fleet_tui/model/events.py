"""Facts. Each one turns the picture of the world into the next one. `at` is the monotonic time, in seconds,
at which the fact reached us; `wall` is Unix time."""

from collections.abc import Mapping

from msgspec import Struct

from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.navigation_events import GoalAnswered, Navigation, QueueHeld
from fleet_tui.model.order import OrderQueue


class PoseReported(Struct, frozen=True, tag=True):
    """`stamp` is the robot's own clock in seconds, None where it gives none."""

    robot: str
    at: float
    pose: Pose
    frame_id: str
    stamp: float | None


class BatteryReported(Struct, frozen=True, tag=True):
    """Charge in per cent; `is_raw`: of a robot whose scale is not known, 0 to 1 or 0 to 100."""

    robot: str
    at: float
    percent: float
    is_raw: bool = False


class CargoReported(Struct, frozen=True, tag=True):
    """Cargo on board, or none."""

    robot: str
    at: float
    loaded: bool


class ObstacleReported(Struct, frozen=True, tag=True):
    """Seconds in contact with an obstacle; 0 is none."""

    robot: str
    at: float
    seconds: float


class QueueReported(Struct, frozen=True, tag=True):
    """The robot's whole queue of orders; `fault` says what of it was left out."""

    robot: str
    at: float
    queue: OrderQueue
    fault: str = ""


class PausedReported(Struct, frozen=True, tag=True):
    """The robot itself says whether it is paused."""

    robot: str
    at: float
    paused: bool


Telemetry = PoseReported | BatteryReported | CargoReported | ObstacleReported | QueueReported | PausedReported


class FrameReceived(Struct, frozen=True, tag=True):
    """A robot's map_metadata of a floor: how its map lies in the world."""

    robot: str
    floor: str
    frame: MapFrame


class GraphReceived(Struct, frozen=True, tag=True):
    """A robot's route graph of a floor. `faults` counts what in it was left out, `fault` says what."""

    robot: str
    floor: str
    graph: RouteGraph
    faults: int = 0
    fault: str = ""


class LabelsReceived(Struct, frozen=True, tag=True):
    """Labels by vertex id, as a robot knows them on a floor; faults as in GraphReceived."""

    robot: str
    floor: str
    labels: Mapping[str, str]
    faults: int = 0
    fault: str = ""


class GridReceived(Struct, frozen=True, eq=False, tag=True):
    """A robot's live map of a floor, ready to draw; without a robot the one that all share."""

    robot: str
    floor: str
    grid: OccupancyGrid


ChartReceived = FrameReceived | GraphReceived | LabelsReceived | GridReceived


class MessageRejected(Struct, frozen=True, tag=True):
    """A message about a robot that could not be taken; `text` names the topic and the field."""

    robot: str
    text: str


class FrameRejected(Struct, frozen=True, tag=True):
    """A frame that no robot can be blamed for."""

    link: str
    text: str


class FloorMapLoaded(Struct, frozen=True, eq=False, tag=True):
    """A floor's configured map file: its grid, or why there is none. `tied` is False for a plain
    image, which lies where map_metadata says."""

    floor: str
    grid: OccupancyGrid | None
    problem: str = ""
    tied: bool = True


class FloorGraphLoaded(Struct, frozen=True, tag=True):
    """A floor's configured graph file: the graph and its labels by vertex id. `problem`: why there is none,
    or what of it was left out."""

    floor: str
    graph: RouteGraph | None
    labels: Mapping[str, str] = {}
    problem: str = ""


class LinkChanged(Struct, frozen=True, tag=True):
    """The telemetry connection of a bridge entered a phase."""

    link: str
    at: float
    phase: Phase
    reason: str = ""
    next_try: float | None = None


class LinkHeard(Struct, frozen=True, tag=True):
    """Something, whatever it was, came from the bridge."""

    link: str
    at: float


class CommandPathChanged(Struct, frozen=True, tag=True):
    """Commands would, or would not, get through now; `connected`: there is a connection for them."""

    link: str
    path: CommandPath
    reason: str = ""
    connected: bool = False


class MessagesUnsourced(Struct, frozen=True, tag=True):
    """The bridge lacks the messages of a ROS package; empty where it has what is asked for."""

    link: str
    package: str


class CommandIssued(Struct, frozen=True, tag=True):
    """An operator gave a command, and it passed the checks: for this floor, else the one its robot is on."""

    id: int
    command: Command
    at: float
    wall: float
    floor: str = ""


class CommandAdvanced(Struct, frozen=True, tag=True):
    """The link brought a command a stage further. `name`: that under which the robot will list the order that
    was sent, empty where this console does not name it."""

    id: int
    stage: Stage
    at: float
    words: str = ""
    name: str = ""


class AlarmAcknowledged(Struct, frozen=True, tag=True):
    """An operator has seen an alarm; with `source` and `kind` empty, all of them."""

    source: str = ""
    kind: str = ""


class AlarmShelved(Struct, frozen=True, tag=True):
    """An operator does not want to hear of an alarm until a monotonic second."""

    source: str
    kind: str
    until: float


class AlarmUnshelved(Struct, frozen=True, tag=True):
    """The end of that, before its time."""

    source: str
    kind: str


class TimePassed(Struct, frozen=True, tag=True):
    """The writer's clock. `behind`: seconds that the oldest message has waited to be read."""

    at: float
    wall: float
    behind: float = 0.0


Event = (
    Telemetry
    | Navigation
    | ChartReceived
    | MessageRejected
    | FrameRejected
    | FloorMapLoaded
    | FloorGraphLoaded
    | LinkChanged
    | LinkHeard
    | CommandPathChanged
    | MessagesUnsourced
    | CommandIssued
    | CommandAdvanced
    | GoalAnswered
    | QueueHeld
    | AlarmAcknowledged
    | AlarmShelved
    | AlarmUnshelved
    | TimePassed
)

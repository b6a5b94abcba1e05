"""Events: each turns a fleet state into the next. `at`: monotonic second of arrival; `wall`: Unix time."""

from collections.abc import Mapping

from msgspec import Struct, field

from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.desk.events import OperatorEvent
from fleet_tui.model.fleets.events import DispatchFact, MemberFact
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.link import CommandPath, Phase
from fleet_tui.model.navigation_events import GoalAnswered, Navigation, QueueChange
from fleet_tui.model.order import OrderQueue
from fleet_tui.model.vehicles.events import VehicleFact
from fleet_tui.text.language import EMPTY, Message


class PoseReported(Struct, frozen=True, tag=True):
    """`stamp` is the robot's own clock in seconds, None if it gives none."""

    robot: str
    at: float
    pose: Pose
    frame_id: str
    stamp: float | None


class BatteryReported(Struct, frozen=True, tag=True):
    """Charge in per cent; `is_raw`: of a robot whose scale is unknown, 0 to 1 or 0 to 100."""

    robot: str
    at: float
    percent: float
    is_raw: bool = False


class CargoReported(Struct, frozen=True, tag=True):
    """Presence of cargo on board."""

    robot: str
    at: float
    loaded: bool


class ObstacleReported(Struct, frozen=True, tag=True):
    """Seconds in contact with an obstacle; 0 for no contact."""

    robot: str
    at: float
    seconds: float


class QueueReported(Struct, frozen=True, tag=True):
    """The robot's whole queue of orders; `fault` describes the parts that were dropped."""

    robot: str
    at: float
    queue: OrderQueue
    fault: Message = EMPTY


class PausedReported(Struct, frozen=True, tag=True):
    """The robot's own report of whether it is paused."""

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
    """A robot's route graph of a floor. `faults` counts the parts that were dropped, `fault` describes
    them."""

    robot: str
    floor: str
    graph: RouteGraph
    faults: int = 0
    fault: Message = EMPTY


class LabelsReceived(Struct, frozen=True, tag=True):
    """Labels by vertex id, as a robot knows them on a floor; faults as in GraphReceived."""

    robot: str
    floor: str
    labels: Mapping[str, str]
    faults: int = 0
    fault: Message = EMPTY


class GridReceived(Struct, frozen=True, eq=False, tag=True):
    """A robot's live map of a floor, ready to draw; with no robot, the one that all share."""

    robot: str
    floor: str
    grid: OccupancyGrid
    at: float = 0.0


MapFactReceived = FrameReceived | GraphReceived | LabelsReceived | GridReceived


class MessageRejected(Struct, frozen=True, tag=True):
    """A rejected message about a robot; `text` names the topic and the field."""

    robot: str
    text: Message


class FrameRejected(Struct, frozen=True, tag=True):
    """A rejected frame that belongs to no known robot."""

    link: str
    text: str


class FloorMapLoaded(Struct, frozen=True, eq=False, tag=True):
    """A floor's configured map file: its grid, or the reason it could not be read. `tied` is False for a
    plain image, which is placed by map_metadata."""

    floor: str
    grid: OccupancyGrid | None
    problem: Message = EMPTY
    tied: bool = True


class FloorGraphLoaded(Struct, frozen=True, tag=True):
    """A floor's configured graph file: the graph and its labels by vertex id. `problem`: the reason it could
    not be read, or the parts that were dropped."""

    floor: str
    graph: RouteGraph | None
    labels: Mapping[str, str] = {}
    problem: str = ""


class LinkChanged(Struct, frozen=True, tag=True):
    """The telemetry connection of a bridge entered a phase."""

    link: str
    at: float
    phase: Phase
    reason: Message = EMPTY
    next_try: float | None = None


class MessageArrived(Struct, frozen=True, tag="LinkHeard"):
    """Any message arrived from the bridge. The tag is that of recordings."""

    link: str
    at: float


class CommandPathChanged(Struct, frozen=True, tag=True):
    """Result of the test whether commands get through; `connected`: there is a connection for them."""

    link: str
    path: CommandPath
    reason: Message = EMPTY
    connected: bool = False


class MessagesUnsourced(Struct, frozen=True, tag=True):
    """The bridge lacks the messages of a ROS package; empty if it has all requested ones."""

    link: str
    package: str


class TopicsDropped(Struct, frozen=True, tag=True):
    """Robots of whose topics the bridge lost its own subscriptions, though nodes publish them; none if it has
    all again."""

    link: str
    robots: tuple[str, ...]


class TopicNotAllowed(Struct, frozen=True, tag=True):
    """An allow-list of the bridge lacks a topic of some robots."""

    link: str
    topic: str
    robots: tuple[str, ...]


class CallNotAllowed(Struct, frozen=True, tag=True):
    """An allow-list of the bridge, `glob`, lacks a service or an action: it drops each call or goal."""

    link: str
    name: str
    glob: str


class SubscriptionsAdvanced(Struct, frozen=True, tag=True):
    """A bridge has handled `done` of `total` subscriptions since its connection was opened."""

    link: str
    at: float
    done: int
    total: int


class BridgeAnswered(Struct, frozen=True, tag=True):
    """A bridge answered a question over the connection for telemetry `after` seconds: it waited as long as
    the messages beside it. `stamp` is the clock of its site in seconds, None if it did not tell."""

    link: str
    at: float
    after: float
    stamp: float | None = None


class CommandIssued(Struct, frozen=True, tag=True):
    """An operator's command that passed the checks: for this floor, else for its robot's current one."""

    id: int
    command: Command
    at: float
    wall: float
    floor: str = ""


class CommandAdvanced(Struct, frozen=True, tag=True):
    """A command reached a further stage. `name`: the name under which the robot will list the order, empty if
    this console does not name it."""

    id: int
    stage: Stage
    at: float
    detail: Message = field(default=EMPTY, name="words")  # as recordings have it
    name: str = ""


class TimePassed(Struct, frozen=True, tag=True):
    """The writer's clock. `behind`: seconds that the oldest unread message has waited."""

    at: float
    wall: float
    behind: float = 0.0


Event = (
    Telemetry
    | Navigation
    | VehicleFact
    | MemberFact
    | MapFactReceived
    | MessageRejected
    | FrameRejected
    | FloorMapLoaded
    | FloorGraphLoaded
    | LinkChanged
    | MessageArrived
    | CommandPathChanged
    | MessagesUnsourced
    | TopicsDropped
    | TopicNotAllowed
    | CallNotAllowed
    | SubscriptionsAdvanced
    | BridgeAnswered
    | CommandIssued
    | CommandAdvanced
    | GoalAnswered
    | DispatchFact
    | QueueChange
    | OperatorEvent
    | TimePassed
)

"""One robot as far as it is known: each value with its time."""

import math
from collections.abc import Mapping
from typing import Generic, Literal, TypeVar

from msgspec import Struct, field
from msgspec.structs import replace

from fleet_tui.model.fleets.member import Member
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation import STOPS_WITHIN, Blocked, Goal, Progress, ReportedMotion, Servers
from fleet_tui.model.order import Order, OrderQueue, route_text
from fleet_tui.model.order_life import GoneOrder, OrderTrace
from fleet_tui.model.vehicles.vehicle import CurrentAction, Vehicle, VehicleConnection, VehicleFeatures
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.limits import truncate

T = TypeVar("T")


class Reading(Struct, Generic[T], frozen=True):
    """A value and the monotonic second at which it was true."""

    value: T
    at: float


class Logged(Struct, frozen=True):
    """A line of a robot's log that may tell why it does not drive, of a monotonic second."""

    text: Message
    at: float
    is_warning: bool = False


class StampClock(Struct, frozen=True):
    """A robot's clock relative to ours: `offset` is the freshest (arrival - stamp) seen, in seconds; until
    it is seen to run, that of its site. `is_compared`: one of the two tells the age of its messages. `site`
    are the seconds by which the clock of its site had drifted then, None if unknown."""

    offset: float
    stamp: float
    at: float
    is_running: bool = True
    is_compared: bool = True
    site: float | None = None


class RobotMap(Struct, frozen=True, eq=False):
    """A floor as one robot knows it. The live `grid` is set only if it was subscribed; `grid_at` is
    the time of its arrival."""

    frame: MapFrame | None = None
    graph: RouteGraph | None = None
    labels: Mapping[str, str] = field(default_factory=dict)
    grid: OccupancyGrid | None = None
    grid_at: float | None = None

    def name_of(self, vertex: str) -> str | None:
        """The label of a vertex, else its id; None if the graph has no such vertex."""
        if vertex in self.labels:
            return self.labels[vertex]
        known = self.graph is not None and vertex in self.graph.vertices
        return vertex if known else None


class Robot(Struct, frozen=True, eq=False):
    """`number` counts from 1 in the order of the config; `last_received` is the effective time of the last
    telemetry; `floor` is the one named by the frame of its pose; `paused_at` is its pose when it accepted our
    own pause, `paused_since` when that was given, `locked_by_us` that one also locked its motors;
    `standing` is the pose it has not left, and since when; `place` is coarser: its place of last
    progress, and since when; `jumps` are the metres of recent impossible jumps of its pose, each with its
    time; `relocated` is the last jump that its localisation made, in words; `misplaced` is why its newest
    pose at which it cannot be is none, `misplaced_since` when such poses began; `pace` its usual speed in m/s
    while it drives; `fault_at` is the time of its last bad data, `kept_at` that of a message of unknown age
    that its broker had kept; `says_paused`: it has a topic for that, received or not; `traces` are the orders
    in its queue by id, `gone` those that left it, newest last; `pause_lost_at` is when a restart ended our
    own pause; `goals` are those that its action servers list, by action; `odometry` is its newest pose by its
    wheels, of `odometry_at`, `located` its last localised pose on the map, `anchor` the origin of its wheel
    frame on the map, `located_by` what told that: a `topic` of its localisation, else its `transforms`, else
    the `feedback` on a goal; `adrift_at` is since when its wheels have carried it farther from `located` than
    its localisation lets pass; `motion` is by its speeds, None until one was not zero: some bases count their
    wheels and report no speed; `variance` that of its position in square metres, `is_settling`: reported just
    after this console had set its pose, at `pose_set_at`; `own_floor` the floor it reports; `held`
    is the reason that this console sends it no waiting order, empty while it does, and
    `released_at` when the operator last released them, `accepted` what spoke against that, or against the
    newest order, and still does; `named` is a goal that this console named and that is
    not listed yet; `target` the last reported target of a goal it had just begun; `unmeasured` are values
    that it reports as not measured; `located_at`: the time of `located`; `mode` is the mode that it reports,
    `mapping_by_us` that this console switched mapping on; `counts_percent`: its battery was seen to count to
    100; `size` is its length and width in metres, None if not configured; `laser` is the pose of its laser on
    it, None if unknown, `laser_flipped` that it hangs upside down, `base_frame` the frame of the robot
    itself, empty for a usual one; `vehicle` is its last state, `acting` the action of its order that it
    carries out; `is_estimated`: it reports no pose, and this one is between nodes; `connection` is that to
    its broker, `factsheet` its properties by name, `features` what it takes by that, `master` the last sign
    of another master control that commands it; `member` are the reports of its fleet adapter; `diagnosed` is
    the last error in its diagnostics, `logged` are lines of its log that may tell causes, newest last."""

    name: str
    number: int
    link: str
    maps: Mapping[str, RobotMap] = field(name="charts")  # as recordings have it
    pose: Reading[Pose] | None = None
    standing: Reading[Pose] | None = None
    place: Reading[Pose] | None = None
    jumps: tuple[Reading[float], ...] = ()
    relocated: Reading[Message] | None = None
    misplaced: Reading[str] | None = None
    misplaced_since: float | None = None
    pace: float | None = None
    frame_id: str = ""
    floor: str | None = None
    battery: Reading[float] | None = None
    counts_percent: bool = False
    unmeasured: tuple[str, ...] = ()
    cargo: Reading[bool] | None = None
    obstacle: Reading[float] | None = None
    queue: Reading[OrderQueue] | None = None
    goals: Mapping[str, tuple[Goal, ...]] = field(default_factory=dict)
    stopped_motions: tuple[Reading[str], ...] = ()
    odometry: Pose | None = None
    odometry_at: float | None = None
    located: Pose | None = None
    located_at: float | None = None
    anchor: Pose | None = None
    located_by: Literal["", "topic", "transforms", "feedback"] = ""
    adrift_at: float | None = None
    motion: Reading[ReportedMotion] | None = None
    servers: Reading[Servers | None] | None = None
    variance: Reading[float] | None = None
    is_settling: bool = False
    pose_set_at: float = -math.inf
    blocked: Reading[Blocked] | None = None
    progress: Reading[Progress] | None = None
    own_floor: str = ""
    held: Message = EMPTY
    released_at: float = -math.inf
    accepted: tuple[str, ...] = ()
    named: str = ""
    target: Reading[Pose] | None = None
    traces: Mapping[str, OrderTrace] = field(default_factory=dict)
    gone: tuple[GoneOrder, ...] = ()
    mode: Reading[str] | None = None
    mapping_by_us: bool = False
    says_paused: bool = False
    kind: Kind = Kind()
    paused: Reading[bool] | None = None
    paused_by_us: bool = False
    paused_since: float | None = None
    locked_by_us: bool = False
    paused_at: Pose | None = None
    pause_lost_at: float | None = None
    last_received: float | None = field(default=None, name="heard")  # as recordings have it
    clock: StampClock | None = None
    faults: int = 0
    last_fault: Message = EMPTY
    fault_at: float | None = None
    kept_at: float | None = None
    size: tuple[float, float] | None = None
    laser: Pose | None = None
    laser_flipped: bool = False
    base_frame: str = ""
    vehicle: Reading[Vehicle] | None = None
    acting: CurrentAction | None = None
    is_estimated: bool = False
    connection: Reading[VehicleConnection] | None = None
    factsheet: Mapping[str, str] = field(default_factory=dict)
    features: VehicleFeatures | None = None
    master: Reading[str] | None = None
    member: Reading[Member] | None = None
    diagnosed: Reading[str] | None = None
    logged: tuple[Logged, ...] = ()

    @property
    def moves_on_since_pause(self) -> bool:
        """Tell whether its speeds show that our pause did not stop it, not only that it still brakes."""
        if not self.paused_by_us or self.paused_since is None or self.motion is None:
            return False
        return self.motion.value.is_moving and self.motion.at - self.paused_since > STOPS_WITHIN

    @property
    def has_cargo(self) -> bool:
        """Tell whether it reports cargo on board."""
        return self.cargo is not None and self.cargo.value

    @property
    def is_gone(self) -> bool:
        """Tell whether its broker reports it as gone, and nothing arrived from it since."""
        if self.connection is None or not self.connection.value.is_gone:
            return False
        return self.last_received is None or self.connection.at >= self.last_received

    @property
    def is_undated(self) -> bool:
        """Tell whether the age of its pose is unknown: of its one message, whose clock nothing tells."""
        return self.clock is not None and not self.clock.is_compared

    @property
    def still_for(self) -> float:
        """Return the seconds that its poses show it standing: an old pose doesn't show that it still does."""
        return self.pose.at - self.standing.at if self.pose and self.standing else 0.0

    @property
    def orders(self) -> OrderQueue:
        """Return the queue as last reported, empty if never."""
        return self.queue.value if self.queue else OrderQueue(0, "", ())

    def name_of(self, vertex: str) -> str | None:
        """The label or id of a vertex in any of this robot's graphs, None if none has it.

        Ids of different floors may be the same: the floor it is on comes first.
        """
        here = self.maps.get(self.floor or "")
        if here is not None and (name := here.name_of(vertex)) is not None:
            return name
        names = (robot_map.name_of(vertex) for robot_map in self.maps.values())
        return next((name for name in names if name is not None), None)

    def order_text(self, order: Order) -> Message:
        """Return an order by its stops, by its id if they are unknown."""
        stops = route_text(order.stops, lambda id_: self.name_of(id_) or id_) if order.stops else ""
        return Message("order {label}", label=order.label or stops or order.id)

    def knows_all_graphs(self) -> bool:
        """Tell whether every floor's graph has arrived, so that a vertex in none of them does not exist."""
        return bool(self.maps) and all(robot_map.graph is not None for robot_map in self.maps.values())


def with_fault(robot: Robot, text: Message, count: int = 1) -> Robot:
    """Return the robot with bad data counted and the newest kept."""
    return replace(robot, faults=robot.faults + count, last_fault=truncate(text))

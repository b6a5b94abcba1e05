"""One robot as far as it is known: each value with the time it was true."""

import math
from collections.abc import Mapping
from typing import Generic, TypeVar

from msgspec import Struct, field
from msgspec.structs import replace

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.kind import Kind
from fleet_tui.model.navigation import Blocked, Goal, Progress
from fleet_tui.model.order import OrderQueue
from fleet_tui.model.order_life import GoneOrder, OrderTrace
from fleet_tui.text.limits import truncate

T = TypeVar("T")


class Reading(Struct, Generic[T], frozen=True):
    """A value and the monotonic second at which it was true."""

    value: T
    at: float


class StampClock(Struct, frozen=True):
    """A robot's clock against ours: `offset` is the freshest (arrival - stamp) seen, in seconds."""

    offset: float
    stamp: float
    at: float


class RobotMap(Struct, frozen=True, eq=False):
    """A floor as one robot knows it. The live `grid` is there only where it was subscribed."""

    frame: MapFrame | None = None
    graph: RouteGraph | None = None
    labels: Mapping[str, str] = field(default_factory=dict)
    grid: OccupancyGrid | None = None

    def name_of(self, vertex: str) -> str | None:
        """The label of a vertex, else its id; None where the graph has no such vertex."""
        if vertex in self.labels:
            return self.labels[vertex]
        known = self.graph is not None and vertex in self.graph.vertices
        return vertex if known else None


class Robot(Struct, frozen=True, eq=False):
    """`number` counts from 1 in the order of the config; `heard` is the effective time of the last telemetry;
    `floor` is the one whose frame its pose names; `paused_at` is where it stood when it accepted our own
    pause; `standing` is the pose it has not left, and since when; `place` is coarser: where it got to, and
    since when it gets no further; `jumps` are the metres of its pose's last leaps that no robot drives, each
    with its time; `fault_at` is when bad data came last; `says_paused`: it has a topic for that, heard or
    not; `traces` are the orders in its queue by id, `gone` those that left it, the newest last;
    `pause_lost_at` is when it started anew while under our own pause, which that ended; `goals` are those
    that its action servers list, by action; `odometry` is its newest pose by its wheels, `located` where it
    found itself on the map last, `anchor` where on the map the frame of its wheels begins; `variance` that of
    its place in square metres; `own_floor` the floor it says that it is on; `held` is why this console sends
    it no order that waits here, empty while it does, and `released_at` when the operator let it go on last;
    `named` is a goal that this console gave under a name of its own, and that was not listed yet; `target`
    where it said last that a goal leads to which it had just begun; `unmeasured` are values that it says it
    does not measure; `counts_percent`: its battery was seen to count to 100; `size` is its length and width
    in metres, None where the config does not say it."""

    name: str
    number: int
    link: str
    charts: Mapping[str, RobotMap]
    pose: Reading[Pose] | None = None
    standing: Reading[Pose] | None = None
    place: Reading[Pose] | None = None
    jumps: tuple[Reading[float], ...] = ()
    frame_id: str = ""
    floor: str | None = None
    battery: Reading[float] | None = None
    counts_percent: bool = False
    unmeasured: tuple[str, ...] = ()
    cargo: Reading[bool] | None = None
    obstacle: Reading[float] | None = None
    queue: Reading[OrderQueue] | None = None
    goals: Mapping[str, tuple[Goal, ...]] = field(default_factory=dict)
    odometry: Pose | None = None
    located: Pose | None = None
    anchor: Pose | None = None
    variance: Reading[float] | None = None
    blocked: Reading[Blocked] | None = None
    progress: Reading[Progress] | None = None
    own_floor: str = ""
    held: str = ""
    released_at: float = -math.inf
    named: str = ""
    target: Reading[Pose] | None = None
    traces: Mapping[str, OrderTrace] = field(default_factory=dict)
    gone: tuple[GoneOrder, ...] = ()
    says_paused: bool = False
    kind: Kind = Kind()
    paused: Reading[bool] | None = None
    paused_by_us: bool = False
    paused_at: Pose | None = None
    pause_lost_at: float | None = None
    heard: float | None = None
    clock: StampClock | None = None
    faults: int = 0
    last_fault: str = ""
    fault_at: float | None = None
    size: tuple[float, float] | None = None

    @property
    def has_cargo(self) -> bool:
        """Tell whether it says that it carries something."""
        return self.cargo is not None and self.cargo.value

    @property
    def orders(self) -> OrderQueue:
        """The queue as last reported, empty if never."""
        return self.queue.value if self.queue else OrderQueue(0, "", ())

    def name_of(self, vertex: str) -> str | None:
        """The label or id of a vertex in any of this robot's graphs, None where none has it.

        Ids of different floors may be the same: the floor it is on comes first.
        """
        here = self.charts.get(self.floor or "")
        charts = [here, *self.charts.values()] if here else self.charts.values()
        names = (chart.name_of(vertex) for chart in charts)
        return next((name for name in names if name is not None), None)

    def knows_all_graphs(self) -> bool:
        """Tell whether every floor's graph has come, so that a vertex in none of them does not exist."""
        return bool(self.charts) and all(chart.graph is not None for chart in self.charts.values())


def with_fault(robot: Robot, text: str, count: int = 1) -> Robot:
    """The robot with bad data counted and the newest named."""
    return replace(robot, faults=robot.faults + count, last_fault=truncate(text))

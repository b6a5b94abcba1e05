"""Transport orders as robots report them, in states common to all stacks."""

import re
from collections.abc import Callable
from enum import Enum
from functools import lru_cache

from msgspec import Struct

from fleet_tui.model.geometry import Pose
from fleet_tui.text.language import N_, Message, verbatim

_DIGITS = re.compile(r"([0-9]+)")


DOCKING = "docking"
"""The label of an order to a dock, which has no stop."""


class OrderState(Enum):
    """The state of an order; the value is shown to the operator."""

    QUEUED = N_("queued")
    IN_PROCESS = N_("in process")
    PAUSED = N_("paused")
    DONE = N_("done")
    CANCELLED = N_("cancelled")
    LOST = N_("lost")
    FAILED = N_("failed")
    REPLACED = N_("replaced")
    REFUSED = N_("refused")


BEGUN = frozenset({OrderState.IN_PROCESS, OrderState.PAUSED})
"""States of an order that the robot has begun."""
PENDING = BEGUN | {OrderState.QUEUED}
"""States of an order that will still be driven."""
OVER = frozenset(OrderState) - PENDING
"""States of an order that is over but still listed."""


class Stop(Struct, frozen=True):
    """A destination of an order: a vertex by its id, or a pose; exactly one of both. `turns_freely`: nobody
    gave the heading of that pose."""

    vertex: str = ""
    pose: Pose | None = None
    turns_freely: bool = False


@lru_cache(maxsize=4096)
def natural(id_: str) -> tuple[tuple[int, str], ...]:
    """A key that sorts ids naturally: 2 before 10."""
    # Text and numbers alternate; of two numbers the longer one is the larger.
    parts = enumerate(_DIGITS.split(id_))
    return tuple((len(part.lstrip("0")), part.lstrip("0")) if n % 2 else (0, part) for n, part in parts)


def at_vertices(*vertices: str) -> tuple[Stop, ...]:
    """The stops at these vertices."""
    return tuple(map(Stop, vertices))


def vertices_of(stops: tuple[Stop, ...]) -> tuple[str, ...]:
    """The ids of the stops that are vertices."""
    return tuple(stop.vertex for stop in stops if stop.pose is None)


def route_text(stops: tuple[Stop, ...], name: Callable[[str], str]) -> Message:
    """Return stops as `A -> B`, a single one as `-> B`, none as `to a point`; `name` returns that
    of a vertex id."""
    names = [name(stop.vertex) if stop.pose is None else pose_text(stop.pose) for stop in stops]
    if not names:
        return Message("to a point")
    return verbatim(" -> ".join(names)) if len(names) > 1 else Message("-> {names}", names=names[0])


def pose_text(pose: Pose) -> str:
    """Return the text of a pose, in metres."""
    return f"({pose.x:.1f}, {pose.y:.1f})"


class Order(Struct, frozen=True):
    """An order to the `stops` in sequence; empty if unknown.

    `state` is None if the robot's own `word` for it is unknown. `serial` grows with each order that the robot
    takes: a new order has a higher one than all before it. `taken_at`: the monotonic second of its
    acceptance, None if not reported. `label` describes it if it has no stop. `name` is its name on the wire,
    if not the id; `said` the robot's text on its end.
    """

    id: str
    stops: tuple[Stop, ...]
    state: OrderState | None
    word: str
    serial: int
    taken_at: float | None = None
    label: str = ""
    name: str = ""
    said: str = ""

    @property
    def is_over(self) -> bool:
        """Tell whether it has ended and is still listed."""
        return self.state in OVER

    @property
    def start(self) -> Stop | None:
        """The first stop, None if the robot starts from its current place."""
        return self.stops[0] if len(self.stops) > 1 else None

    @property
    def end(self) -> Stop | None:
        """The last stop, None if unknown."""
        return self.stops[-1] if self.stops else None

    @property
    def state_text(self) -> Message:
        """Return its state in this console's words, else in the robot's own."""
        return Message(self.state.value) if self.state else verbatim(self.word)


class OrderQueue(Struct, frozen=True):
    """A robot's orders. `last_serial` is the serial of the newest order that it ever took; `current_id` is
    empty for none; `request_id` is the request that placed the newest order, 0 if the robot does not echo
    it."""

    last_serial: int
    current_id: str
    orders: tuple[Order, ...]
    request_id: int = 0

    @property
    def current(self) -> Order | None:
        if self.current_id:  # asked ten times a second of every robot
            for order in self.orders:
                if order.id == self.current_id:
                    return order
        return None

    def is_current(self, order: Order) -> bool:
        return order.id == self.current_id != ""

    @property
    def open(self) -> tuple[Order, ...]:
        """Return the orders that will still be driven, as far as their states show."""
        return tuple(order for order in self.in_sequence() if not order.is_over)

    def in_sequence(self) -> tuple[Order, ...]:
        """Return the orders in driving sequence: the current one first."""
        current = self.current
        if current is None:
            return self.orders
        return (current, *(order for order in self.orders if order is not current))

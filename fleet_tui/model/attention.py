"""The operator's attention, and the intervals at which messages are requested by it."""

from typing import Annotated, NamedTuple

from msgspec import Meta, Struct

Interval = Annotated[int, Meta(ge=0, le=60_000)]


class Rates(Struct, frozen=True):
    """`[rates]`: in a fleet of more than `full_up_to` robots, the milliseconds between two poses and between
    two other reports of robots that nobody looks at; `changes_per_s`: subscriptions of a link that may be
    changed in a second."""

    full_up_to: Annotated[int, Meta(ge=0, le=100_000)] = 100
    pose_ms: Interval = 1000
    status_ms: Interval = 2000
    changes_per_s: Annotated[int, Meta(ge=1, le=1000)] = 20


class SeenArea(NamedTuple):
    """The part of a floor that the map shows: its ends in metres, and the metres of a cell."""

    left: float
    low: float
    right: float
    top: float
    cell: float

    def shows(self, x: float, y: float) -> bool:
        """Tell whether a place in metres is in the view."""
        return self.left <= x <= self.right and self.low <= y <= self.top


class Attention(NamedTuple):
    """The focus of the operator: the selected robot, the floor on the map and the view of it, None without a
    map."""

    robot: str = ""
    floor: str = ""
    view: SeenArea | None = None


class Intervals(NamedTuple):
    """Milliseconds between two poses of a robot, and between two messages of its other regular topics; 0:
    as often as `[ui]` says. `unseen` is 1 for a robot that nobody looks at."""

    pose: int = 0
    status: int = 0
    unseen: int = 0

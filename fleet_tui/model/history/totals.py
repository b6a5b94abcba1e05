"""Figures of a time: sums over orders, hours and places."""

from msgspec import Struct

from fleet_tui.model.history.facts import Activity


class OrderTotal(Struct, frozen=True):
    """Orders of one robot and way that ended in one way: `late` of them took more than LATE times the usual;
    `seconds` is the sum of the `timed` ones from begin to end, `longest` the longest."""

    robot: str
    way: str
    stage: str
    count: int
    late: int
    timed: int
    seconds: float
    longest: float


class ActivityTotal(Struct, frozen=True):
    """Seconds of one activity of a robot in one part of the time, counted from 0."""

    robot: str
    part: int
    activity: Activity
    seconds: float


class ChargeTotal(Struct, frozen=True):
    """The lowest and the last level of a robot's battery in one part of the time, in per cent."""

    robot: str
    part: int
    low: float
    last: float


class BlockedPlace(Struct, frozen=True):
    """Seconds for which robots were blocked at a place: x, y in metres, the middle of a cell."""

    floor: str
    x: float
    y: float
    seconds: float

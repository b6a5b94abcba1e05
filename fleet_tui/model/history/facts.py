"""Facts about a fleet, one after the other. Times are Unix seconds."""

from enum import Enum

from msgspec import Struct

from fleet_tui.text.language import N_


class Activity(Enum):
    """An activity of a robot; the value is shown, and stands in the database."""

    DRIVING = N_("driving")
    LOADING = N_("loading")
    WAITING = N_("waiting")
    CHARGING = N_("charging")
    IDLE = N_("idle")
    PAUSED = N_("paused")
    BLOCKED = N_("blocked")
    OFFLINE = N_("offline")


class Span(Struct, frozen=True):
    """A time in which a robot did one thing. `floor`, `x` and `y` (metres) are the place of its beginning,
    the floor empty if unknown."""

    robot: str
    activity: Activity
    began: float
    ended: float
    floor: str = ""
    x: float = 0.0
    y: float = 0.0


class Charge(Struct, frozen=True):
    """The battery of a robot in per cent."""

    robot: str
    at: float
    percent: float


class OrderChange(Struct, frozen=True):
    """A step in the life of an order: `stage` is `queued`, `begun`, or how it ended. `request` is the command
    of the console run that placed it, None if that was another one."""

    robot: str
    order: str
    way: str
    at: float
    stage: str
    floor: str = ""
    reason: str = ""
    request: int | None = None


class LinkChange(Struct, frozen=True):
    """A link came up or went down."""

    link: str
    at: float
    is_up: bool
    reason: str = ""


class LaterCause(Struct, frozen=True):
    """The text of an alarm whose cause came after it was raised."""

    source: str
    kind: str
    text: str


class Note(Struct, frozen=True):
    """A remark of an operator, for whoever takes over."""

    at: float
    operator: str
    text: str

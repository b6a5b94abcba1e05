"""Navigation goals of robots that have no queue, and their progress."""

import math

from msgspec import Struct

from fleet_tui.model.order import OrderState, Stop
from fleet_tui.model.set_up.driving import Speeds
from fleet_tui.text.language import Message
from fleet_tui.text.units import duration


class Goal(Struct, frozen=True):
    """A goal of an action. `id` is short, for people; `uuid` as on the wire. `action` is its key in the
    vocabulary; `stamp` the second of its acceptance by the robot's clock; `stops` its destinations as far
    as known; `serial` grows with each goal seen. `leads`: it drives by goals of its own, of which each
    `is_leg`: another goal of the same robot gave it, `is_ours`: this console did. `begun_at` and
    `ended_at` are when it was first seen active and ended (monotonic), minus infinity if that was earlier.
    `label` describes it if it has no stop; `listed_at` is when its action server listed it last
    (monotonic); `is_ending`: it is being cancelled; `said` is the robot's text on its end; `has_missed`: a
    leg of it has failed. `requester` is the name that its client gave itself, as far as it is passed on;
    `tokens` name its open interruptions, each of which holds it."""

    id: str
    uuid: str
    action: str
    state: OrderState | None
    word: str = ""
    stamp: float | None = None
    stops: tuple[Stop, ...] = ()
    serial: int = 0
    leads: bool = False
    is_leg: bool = False
    is_ours: bool = False
    begun_at: float | None = None
    ended_at: float | None = None
    label: str = ""
    listed_at: float = -math.inf
    listed_since: float = -math.inf
    is_ending: bool = False
    said: str = ""
    has_missed: bool = False
    requester: str = ""
    tokens: tuple[str, ...] = ()


STOPS_WITHIN = 3.0
STANDS_FOR = 0.5
"""Seconds after a pause in which a robot brakes, and of speeds near zero from which it stands."""


class ReportedMotion(Struct, frozen=True):
    """Whether a robot moves by the speeds that it reports, and since when (monotonic) all of them said so.
    `mean` is that of the newest ones, each as far as it matters; `stood` is when it last stood, None if it
    never did: speeds near zero for a moment are noise."""

    is_moving: bool
    since: float
    mean: Speeds = Speeds()
    stood: float | None = None


DOWN = "down"
MUTE = "does not answer"
"""States of a node that is not there, and of one that hangs; else the label of its lifecycle."""


class Servers(Struct, frozen=True):
    """Whether the servers that drive a robot are active, and since when (monotonic) as far as this console
    saw. `node` is the first one that is not, in `state`, empty if all are alike."""

    is_active: bool
    node: str = ""
    state: str = ""
    since: float = 0.0


class Progress(Struct, frozen=True):
    """Progress of a goal: metres left, seconds left and since its start, recoveries so far, and the number of
    the current stop, each None if not reported. `goal` is its short id."""

    goal: str
    metres: float | None = None
    seconds: float | None = None
    elapsed: float | None = None
    recoveries: int | None = None
    stop: int | None = None


class Blocked(Struct, frozen=True):
    """A robot held back by its collision monitor, and when this console first saw that (monotonic). `action`
    is stop, slowdown, approach or limit, empty for none; `polygon` the zone with the obstacle."""

    action: str
    polygon: str
    since: float

    @property
    def is_stopped(self) -> bool:
        """Tell whether the monitor stops it."""
        return self.action == "stop"


def blocked_text(blocked: Blocked, now: float) -> Message:
    """Return the text of a robot held back, with the seconds since this console's first message of it."""
    if blocked.is_stopped:
        return Message("blocked {duration} (seen)", duration=duration(now - blocked.since))
    return Message("slowed by its collision monitor ({action})", action=blocked.action)

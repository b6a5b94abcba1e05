"""The lives of orders, alarms and commands. Times are Unix seconds, None while it has not happened."""

from msgspec import Struct

from fleet_tui.text.language import Message


class PastOrder(Struct, frozen=True):
    """The whole life of an order. `stage` is that of its last change."""

    robot: str
    order: str
    way: str
    floor: str
    queued: float
    begun: float | None
    ended: float | None
    stage: str
    reason: str
    operator: str


class AlarmLife(Struct, frozen=True):
    """The whole life of an alarm. `source` is its robot or link, `operator` who acknowledged it."""

    source: str
    kind: Message
    priority: str
    text: str
    raised: float
    returned: float | None
    acknowledged: float | None
    ended: float | None
    operator: str
    count: int


class PastCommand(Struct, frozen=True):
    """A command: when it was given, and the last stage that it reached."""

    at: float
    operator: str
    robot: str
    what: str
    way: str
    stage: str
    reason: str

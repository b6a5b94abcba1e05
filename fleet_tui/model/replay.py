"""The position of a replay, and the events of a recording."""

from collections.abc import Sequence
from enum import IntEnum

from msgspec import Struct

from fleet_tui.text.language import EMPTY, Message


class MarkKind(IntEnum):
    """The kind of a mark; in a shared cell the highest is shown."""

    COMMAND = 1
    GAP = 2
    ALARM = 3


class TimeMark(Struct, frozen=True):
    """An event at `at` (monotonic seconds of the recording)."""

    at: float
    kind: MarkKind
    text: Message


class ReplayPosition(Struct, frozen=True):
    """The position of a replay. `began`, `ended` and `at` are its monotonic seconds, `wall` is Unix time;
    `reached` is the actual speed if `speed` is too much for this machine, `is_over` at the end, `busy` the
    progress of a long jump (0 to 1), `note` a problem of the recording; `jumps` counts them."""

    began: float
    ended: float
    at: float
    wall: float
    speed: float = 1.0
    reached: float | None = None
    paused: bool = False
    is_over: bool = False
    busy: float | None = None
    marks: Sequence[TimeMark] = ()
    note: Message = EMPTY
    jumps: int = 0

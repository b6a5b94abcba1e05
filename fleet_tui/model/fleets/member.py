"""Members of a fleet: reports of its adapter beside pose, charge and orders."""

from msgspec import Struct

from fleet_tui.text.language import EMPTY, Message

EMERGENCY = "emergency"
ADAPTER_ERROR = "adapter error"
"""Modes in which a robot can't drive."""
OFFLINE = "offline"
"""Status of a robot whose driver has lost it."""


CHARGING = "charging"
"""The mode, as its driver's report is read, of a robot that charges."""


class Member(Struct, frozen=True):
    """A robot of a fleet. `mode` is the word of its driver, `status` that of its adapter, each empty if not
    reported; `task` the id of the task that it drives; `issues` are the faults that its adapter reports, a
    line each."""

    mode: Message = EMPTY
    status: Message = EMPTY
    task: str = ""
    issues: tuple[str, ...] = ()

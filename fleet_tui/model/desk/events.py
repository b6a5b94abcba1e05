"""Events of operators: alarms answered, robots claimed, edges closed, here and at other consoles of the desk.

`by` is the operator of another console, empty for this one.
"""

from msgspec import Struct

from fleet_tui.model.desk.desk import Colleague, CommandElsewhere, Ends


class AlarmAcknowledged(Struct, frozen=True, tag=True):
    """An operator acknowledged an alarm; with `source` and `kind` empty, all of them."""

    source: str = ""
    kind: str = ""
    by: str = ""


class AlarmShelved(Struct, frozen=True, tag=True):
    """An operator shelved an alarm until a monotonic second."""

    source: str
    kind: str
    until: float
    by: str = ""


class AlarmUnshelved(Struct, frozen=True, tag=True):
    """An operator unshelved an alarm before its time."""

    source: str
    kind: str
    by: str = ""


class DeskJoined(Struct, frozen=True, tag=True):
    """This console has a desk; `name` is its operator."""

    name: str


class ColleaguesSeen(Struct, frozen=True, tag=True):
    """All other consoles that are at the desk now."""

    others: tuple[Colleague, ...] = ()


class RobotClaimed(Struct, frozen=True, tag=True):
    robot: str


class RobotReleased(Struct, frozen=True, tag=True):
    robot: str


class EdgeClosed(Struct, frozen=True, tag=True):
    """An operator closed an edge to robots; `wall`: Unix seconds."""

    ends: Ends
    wall: float
    by: str = ""


class EdgeOpened(Struct, frozen=True, tag=True):
    """An operator opened a closed edge again."""

    ends: Ends
    by: str = ""


class CommandedElsewhere(Struct, frozen=True, tag=True):
    """Another console sent a command to a robot, or that reached another stage."""

    command: CommandElsewhere


AlarmAnswer = AlarmAcknowledged | AlarmShelved | AlarmUnshelved
DeskChange = (
    DeskJoined | ColleaguesSeen | RobotClaimed | RobotReleased | EdgeClosed | EdgeOpened | CommandedElsewhere
)
OperatorEvent = AlarmAnswer | DeskChange

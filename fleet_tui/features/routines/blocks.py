"""The language of routines as values. `line` is that of the file, from 1."""

from msgspec import Struct

from fleet_tui.text.language import Message

DAYS = ("monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday")


class BatteryCondition(Struct, frozen=True, tag=True):
    """The charge is above or below a number of per cent."""

    above: bool
    percent: float


class IdleCondition(Struct, frozen=True, tag=True):
    """The robot has no order to drive."""


class PlaceCondition(Struct, frozen=True, tag=True):
    """The robot is at a place, as it is typed."""

    place: str


Condition = BatteryCondition | IdleCondition | PlaceCondition


class TimeSpan(Struct, frozen=True, tag=True):
    """A number of seconds."""

    seconds: float


class DayTime(Struct, frozen=True, tag=True):
    """The next moment at which the local clock shows this minute of the day."""

    minute: int

    @property
    def text(self) -> str:
        """Return it as it is typed: `06:30`."""
        return f"{self.minute // 60:02}:{self.minute % 60:02}"


class GoBlock(Struct, frozen=True, tag=True):
    """An order to a place."""

    line: int
    text: str
    place: str


class CarryBlock(Struct, frozen=True, tag=True):
    """An order from one place to another."""

    line: int
    text: str
    start: str
    end: str


class WaitBlock(Struct, frozen=True, tag=True):
    """A wait for a time or a condition."""

    line: int
    text: str
    until: TimeSpan | DayTime | Condition


class RunBlock(Struct, frozen=True, tag=True):
    """A program with its arguments, ended after `within` seconds; it succeeds with exit code 0."""

    line: int
    text: str
    arguments: tuple[str, ...]
    within: float


class RepeatBlock(Struct, frozen=True, tag=True):
    """Blocks that are repeated; endlessly if `times` is None."""

    line: int
    text: str
    times: int | None
    body: "tuple[Block, ...]"


class IfBlock(Struct, frozen=True, tag=True):
    """Blocks for a condition, and others for its opposite."""

    line: int
    text: str
    condition: Condition
    body: "tuple[Block, ...]"
    otherwise: "tuple[Block, ...]"


Leaf = GoBlock | CarryBlock | WaitBlock | RunBlock
Block = Leaf | RepeatBlock | IfBlock


class LanePlan(Struct, frozen=True):
    """The blocks of one robot, and those that are carried out after one of them has failed."""

    robot: str
    line: int
    body: tuple[Block, ...]
    on_failure: tuple[Block, ...] = ()


class Schedule(Struct, frozen=True):
    """The time of a start: `days` counts from Monday as 0."""

    days: tuple[int, ...]
    at: DayTime

    @property
    def text(self) -> str:
        """Return it as it is typed, without `every`."""
        names = {tuple(range(7)): "day", tuple(range(5)): "weekday"}
        return f"{names.get(self.days) or DAYS[self.days[0]]} {self.at.text}"


class Routine(Struct, frozen=True):
    """A whole file."""

    lanes: tuple[LanePlan, ...] = ()
    schedules: tuple[Schedule, ...] = ()


class RoutineProblem(Struct, frozen=True):
    """An error in a routine, with its remedy."""

    line: int
    text: Message


class ParsedRoutine(Struct, frozen=True):
    """A file as far as it could be read, with all problems."""

    routine: Routine
    problems: tuple[RoutineProblem, ...] = ()

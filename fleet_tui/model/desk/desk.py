"""The state of the desk: the other consoles, claims of robots, closed edges."""

from msgspec import Struct

from fleet_tui.model.commands import Stage
from fleet_tui.text.language import Message


class Colleague(Struct, frozen=True):
    """Another console of the desk: `id` is unique, `name` its operator, `robot` the one it looks at, `claims`
    the robots that it has claimed."""

    id: str
    name: str
    host: str
    robot: str = ""
    claims: tuple[str, ...] = ()


Ends = tuple[str, str, str]
"""Floor and the two vertex ids of an edge, the smaller id first: an edge is closed both ways."""


def ends_of(floor: str, start: str, end: str) -> Ends:
    """Return the identity of an edge, whatever its direction."""
    return (floor, start, end) if start <= end else (floor, end, start)


class ClosedEdge(Struct, frozen=True):
    """An edge that people closed to robots; `by` is who did it, `wall` when (Unix seconds)."""

    ends: Ends
    by: str
    wall: float


REMOVES = ("cancel", "clear")
"""Commands that remove orders, as the audit log names them."""


class CommandElsewhere(Struct, frozen=True):
    """A command that another console sent to a robot: `order_id` is the order that it removes, empty for all
    or none; `at` the monotonic second of its sending, or if it `is_arrival` of its news, `stage` its newest;
    `key` identifies it; `by` is the operator, `console` host:process, `what` its name in the audit log. Of an
    order `goals` are those by which its robot has driven it so far, in sequence, as far as that is known,
    `way` are its first and last stop; `goes_on`: the last goal has ended, and its console keeps the next."""

    key: str
    robot: str
    order_id: str
    by: str
    console: str
    at: float
    stage: Stage
    what: str
    is_arrival: bool = False
    goals: tuple[str, ...] = ()
    way: str = ""
    goes_on: bool = False

    @property
    def parts(self) -> tuple[str, ...]:
        """Return the goals whose end is not its own."""
        return self.goals if self.goes_on else self.goals[:-1]

    @property
    def removes(self) -> bool:
        """Tell whether it is to remove orders."""
        return self.what in REMOVES

    @property
    def text(self) -> Message:
        """Return what was done to the order that it removed, by whom and where."""
        if self.order_id:
            return Message("cancelled by {by} at {console}", by=self.by, console=self.console)
        return Message("cleared by {by} at {console}", by=self.by, console=self.console)


class Desk(Struct, frozen=True):
    """`me` is this console's operator, empty without a desk; `claims` are this console's. `acted`: the
    operator of the other console that made the last change of an alarm or edge, empty if it was this one.
    `elsewhere`: the last commands of other consoles, with or without a desk."""

    me: str = ""
    claims: tuple[str, ...] = ()
    others: tuple[Colleague, ...] = ()
    closed: tuple[ClosedEdge, ...] = ()
    acted: str = ""
    elsewhere: tuple[CommandElsewhere, ...] = ()

    def holders(self, robot: str) -> list[str]:
        """Return the operators of all consoles that have claimed a robot."""
        mine = [self.me] if robot in self.claims else []
        return [*mine, *self.other_holders(robot)]

    def other_holders(self, robot: str) -> list[str]:
        """Return the operators of the other consoles that have claimed a robot."""
        return list(dict.fromkeys(one.name for one in self.others if robot in one.claims))

    def closed_on(self, floor: str) -> list[ClosedEdge]:
        return [edge for edge in self.closed if edge.ends[0] == floor]

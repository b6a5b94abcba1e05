"""The columns of the fleet pane, by its width and by what the robots report."""

from collections import Counter
from collections.abc import Collection, Mapping
from functools import lru_cache
from itertools import takewhile
from typing import NamedTuple

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.rules.marks import marks_of
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import cell_width, fit
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Run, column

DOT = 2
STATE = 19
WITH_ORDER = 36
ORDER_MOST = 30
"""Cells of usual states (longer ones take some of a short order's), of both from which orders have a column
before them, and of that at most."""
WHOLE_FLOORS = 54
WITH_BAR = 70
WITH_WAITING = 84
WITH_SEEN = 90
"""Cells of a pane from which floors have their whole names, and from which it has further columns."""
FLOOR = 2
"""Cells of the floors' column where their names are that short: its head is cut, too."""
BAR = 5
"""Cells of a full battery's bar."""
UNKNOWN_FLOOR = "unknown floor"
NO_FLOOR = ("", "-", UNKNOWN_FLOOR)


def floor_text(state: FleetState, robot: Robot) -> str:
    """Return the floor a robot is on, as far as its pose shows."""
    if robot.pose is None:
        return "-" if "pose" in robot.kind.reports else ""
    return robot.floor or UNKNOWN_FLOOR


def _floors(state: FleetState) -> set[str]:
    return {floor_text(state, robot) for robot in state.robots.values()}


class Columns(NamedTuple):
    """Widths in cells with the gap after them, 0 for a column for which no robot of the fleet has a value or
    the pane no space. `state` is what the last column has left. `floors` and `names` are those of floors and
    robots as shown, `marks` the numbers of robots, which are their keys from 1 to 9."""

    number: int
    name: int
    battery: int
    bar: int
    floor: int
    cargo: int
    order: int
    waiting: int
    seen: int
    floors: Mapping[str, str]
    names: Mapping[str, str]
    marks: Mapping[str, str]
    state: int = 0

    @classmethod
    def of(cls, state: FleetState, width: int) -> "Columns":
        """Return the columns of a pane of `width` cells."""
        robots = state.robots.values()
        reported, names = {value for one in robots for value in one.kind.reports}, _floors(state)
        marks = marks_of(tuple(state.robots))
        is_narrow = width < WHOLE_FLOORS
        # Of all floors: the column must not change when one gets empty.
        floors = shortened({*state.floors, *names}) if is_narrow else {name: name for name in names}
        own = own_names(tuple(state.robots)) if is_narrow else {name: name for name in state.robots}
        is_obvious = is_narrow and len(state.floors) == 1 and names.isdisjoint(NO_FLOOR)
        floor = column(floors.values(), FLOOR if is_narrow else len(tr("Floor")), 13) + 1
        fixed = cls(
            number=column(marks, 1, 4) + 1,
            name=column(own.values(), 6, 14) + 1,
            battery=6 if "battery" in reported else 0,
            bar=BAR + 1 if "battery" in reported and width >= WITH_BAR else 0,
            floor=floor if "pose" in reported and not is_obvious else 0,
            cargo=2 if "cargo" in reported else 0,
            order=0,
            waiting=6 if width >= WITH_WAITING and "queue" in reported else 0,
            seen=7 if width >= WITH_SEEN else 0,
            floors=floors,
            names=own,
            marks=dict(zip(state.robots, marks, strict=True)),
        )
        left = width - DOT - sum(fixed[:-4])
        order = min(left - STATE, ORDER_MOST) if left >= WITH_ORDER else 0
        return fixed._replace(order=order, state=left - order)

    @property
    def head(self) -> tuple[Run, ...]:
        """Return their names."""
        names = (
            ("#".rjust(DOT + self.number - 1), DOT + self.number),
            (tr("Robot"), self.name),
            (tr("Batt"), self.battery),
            ("", self.bar),
            (tr("Floor")[: max(FLOOR, self.floor - 1)], self.floor),
            ("", self.cargo),
            (tr("Queue"), self.waiting),
            ("  Seen", self.seen),
            (tr("Order"), self.order),
        )
        shown = "".join(fit(name, width) for name, width in names if width)
        both = tr("State, order")
        is_own = bool(self.order) or cell_width(both) > self.state
        return ((shown + (tr("State") if is_own else both), StyleRole.DIM),)


@lru_cache(maxsize=4)
def own_names(robots: tuple[str, ...]) -> Mapping[str, str]:
    """Return the names of robots without that of their fleet, before a `/`, where they are unique so."""
    ends = Counter(name.rpartition("/")[2] for name in robots)
    own = {name: name.rpartition("/")[2] for name in robots}
    return {name: end if end and ends[end] == 1 else name for name, end in own.items()}


def shortened(floors: Collection[str]) -> Mapping[str, str]:
    """Return floors without the beginning that all of them have, up to its last separator: `floor_0` and
    `floor_1` as `0` and `1`, an unknown one as `?`."""
    real = [name for name in floors if name not in NO_FLOOR]
    pairs = zip(min(real), max(real), strict=False) if len(real) > 1 else ()
    common = "".join(one for one, _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
    start = max(common.rfind(mark) for mark in " _-.") + 1
    found = {name: name if name in NO_FLOOR else name[start:] or name for name in floors}
    return found | ({UNKNOWN_FLOOR: "?"} if UNKNOWN_FLOOR in found else {})

"""The activities of the last minutes, as far as this console watched: a bar for each robot."""

import math
from collections import Counter, deque
from collections.abc import Hashable, Mapping, Sequence

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.link import Phase
from fleet_tui.situation.activity import activities
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import fit
from fleet_tui.text.units import age
from fleet_tui.ui.view.bars import BARS, bars_of, legend_of
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Row, Table, column

FIRST = 1.25
LAST = 10.0
"""Seconds of a cell, at first and after a while: the bars have something to show from the start."""
CELLS = 180
"""Cells that are kept."""
WIDTHS = (8, 4, 2)
"""Cells of a part while there are few."""
NAMES = 14
HEADS = 2
"""Cells of a name at most, and lines of title and head."""


class RecentActivity:
    """The activity of each robot at the last moments, the newest last; none of a robot that nobody saw."""

    def __init__(self) -> None:
        self._parts: deque[Mapping[str, Activity]] = deque(maxlen=CELLS)
        self._at = -math.inf
        self.every = FIRST

    def note(self, state: FleetState) -> None:
        """Record what the robots do, every so many seconds. Time that was not watched stays blank; before an
        earlier time, as of a recording, nothing is known."""
        passed = state.now - self._at
        if 0.0 <= passed < self.every:
            return
        if passed < 0.0:
            self._parts.clear()
        elif self._parts:
            self._parts.extend({} for _ in range(min(CELLS, int(passed / self.every) - 1)))
        self._at = state.now
        self._parts.append(
            {
                name: activity
                for name, activity in activities(state, state.robots.values()).items()
                for robot in [state.robots[name]]
                if robot.last_received is not None and state.links[robot.link].phase is Phase.UP
            }
        )

        if len(self._parts) == CELLS and self.every < LAST:
            self._parts = deque(list(self._parts)[1::2], maxlen=CELLS)
            self.every *= 2

    def width_of_part(self, cells: int) -> int:
        """Return the cells of each part in `cells`: as long as there are few parts they fill the space, too.
        In steps, so that bars rarely grow shorter."""
        return next((each for each in WIDTHS if each * len(self._parts) <= cells), 1)

    def of(self, robot: str, cells: int, each: int = 1) -> list[Activity | None]:
        """Return what a robot did in the last parts, `each` of so many cells, as far as `cells` allow."""
        kept = list(self._parts)[-(cells // each) :]
        done = [part.get(robot) for part in kept for _ in range(each)]
        return [None] * (cells - len(done)) + done

    def told(self, robot: str) -> str:
        """Return how long a robot did what in all the parts that are kept."""
        did = Counter(part.get(robot) for part in self._parts)
        return ", ".join(f"{tr(one.value)} {age(did[one] * self.every)}" for one in BARS if did[one])


def activity_table(
    recent: RecentActivity, robots: Sequence[Hashable], lines: int, width: int, is_ascii: bool
) -> Table:
    """Return the bars of the first `robots` for a pane of so many lines, with its title, and cells; with
    enough lines below each how long it did what."""
    is_told = 0 < len(robots) * 2 <= lines - HEADS
    names = [str(name) for name in robots[: max(0, lines - HEADS)]]
    start = column(names, at_most=NAMES) + 1
    cells = max(1, min(CELLS, width - start))
    each = recent.width_of_part(cells)
    bars = {name: recent.of(name, cells, each) for name in names}
    rows = [
        Row(None, runs)
        for name, bar in bars.items()
        for runs in (
            ((fit(name, start), StyleRole.DIM), *bars_of(bar, is_ascii)),
            ((f"{' ' * start}{recent.told(name)}", StyleRole.DIM),),
        )[: 1 + is_told]
    ]
    since = tr("{age} ago", age=age(cells / each * recent.every))
    head = f"{' ' * start}{since}{tr('now'):>{max(0, cells - len(since))}}"
    title = (tr("Activity"), StyleRole.TITLE), *legend_of(bars.values(), is_ascii)
    return Table(title, tuple(rows), head=((head, StyleRole.DIM),))

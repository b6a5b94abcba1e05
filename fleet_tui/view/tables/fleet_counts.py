"""The counts in the title of the fleet pane: the robots online, and what they do."""

from collections import Counter
from collections.abc import Sequence

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.rules.history.activity import activities
from fleet_tui.text.language import tr
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Run, width_of

COUNTED = {
    Activity.BLOCKED: StyleRole.WARN,  # red is an alarm: most contacts pass
    Activity.PAUSED: StyleRole.WARN,
    Activity.WAITING: StyleRole.DIM,
    Activity.DRIVING: StyleRole.DIM,
    Activity.LOADING: StyleRole.DIM,
    Activity.IDLE: StyleRole.DIM,
    Activity.CHARGING: StyleRole.DIM,
}
"""What robots online do: first what a person looks for, which stays where not all fits."""
BESIDE = len("─ Fleet    -  of  ─")
"""Cells of the title beside the counts, and beside the numbers of the rows in view."""


def fleet_counts(state: FleetState, width: int) -> list[Run]:
    """Return how many robots are online and, as far as `width` cells of the title allow, what they do. Where
    what is odd would be dropped, it is there in the place of those online."""
    robots = state.robots
    # Without a queue nobody knows whether a standing robot is idle.
    done = ((robots[name].queue is not None, one) for name, one in activities(state, robots.values()).items())
    found = Counter(one for is_listed, one in done if is_listed or one is not Activity.IDLE)
    offline, left = found[Activity.OFFLINE], width - BESIDE - 3 * len(str(len(robots)))
    online = len(robots) - offline
    present: Run = (tr(f" {online} of {len(robots)} online"), StyleRole.DIM)
    counts = [(f"{found[one]} {tr(one.value)}", role) for one, role in COUNTED.items() if found[one]]
    odd = [one for one in counts if one[1] is StyleRole.WARN]
    if not odd or width_of(_listed([present], ": ", odd)) <= left:
        return _fitting([present], ": ", counts, left)
    away = [(f"{offline} {tr(Activity.OFFLINE.value)}", StyleRole.DIM)] if offline else []
    return _fitting([], " ", [*away, *odd], left) or [present]


def _listed(runs: Sequence[Run], first: str, counts: Sequence[Run]) -> list[Run]:
    more = [part for count in counts for part in ((", ", StyleRole.DIM), count)]
    return [*runs, *([(first, StyleRole.DIM), *more[1:]] if counts else [])]


def _fitting(runs: Sequence[Run], first: str, counts: Sequence[Run], left: int) -> list[Run]:
    """Return the runs with as many of the counts, from the first, as there are cells left for."""
    listed = (_listed(runs, first, counts[:most]) for most in range(len(counts), 0, -1))
    return next((one for one in listed if width_of(one) <= left), list(runs))

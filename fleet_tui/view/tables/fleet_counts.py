"""The counts in the title of the fleet pane: the robots online, and what they do."""

from collections import Counter

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.rules.history.activity import activities
from fleet_tui.text.language import tr
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Run, width_of

COUNTED = {
    Activity.BLOCKED: StyleRole.WARN,  # red is an alarm: most contacts pass
    Activity.PAUSED: StyleRole.WARN,
    Activity.DRIVING: StyleRole.DIM,
    Activity.LOADING: StyleRole.DIM,
    Activity.WAITING: StyleRole.DIM,
    Activity.IDLE: StyleRole.DIM,
    Activity.CHARGING: StyleRole.DIM,
}
"""What robots online do: first what a person looks for, which stays where not all fits."""
BESIDE = len("─ Fleet    -  of  ─")
"""Cells of the title beside the counts, and beside the numbers of the rows in view."""


def fleet_counts(state: FleetState, width: int) -> list[Run]:
    """Return how many robots are online and, as far as `width` cells of the title allow, what they do."""
    robots = state.robots
    # Without a queue nobody knows whether a standing robot is idle.
    done = ((robots[name].queue is not None, one) for name, one in activities(state).items())
    found = Counter(one for is_listed, one in done if is_listed or one is not Activity.IDLE)
    online = len(robots) - found[Activity.OFFLINE]
    runs: list[Run] = [(tr(f" {online} of {len(robots)} online"), StyleRole.DIM)]
    left = width - BESIDE - 3 * len(str(len(robots)))
    counts = [(f"{found[one]} {tr(one.value)}", role) for one, role in COUNTED.items() if found[one]]
    for place, (text, role) in enumerate(counts):
        more: list[Run] = [(", " if place else ": ", StyleRole.DIM), (text, role)]
        if width_of([*runs, *more]) > left:
            break
        runs += more
    return runs

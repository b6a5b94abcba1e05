"""The counts in the title of the fleet pane: the robots online, and what they do."""

from collections import Counter
from collections.abc import Mapping, Sequence

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.history.facts import Activity
from fleet_tui.text.language import tr
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.doing import ODD, UNKNOWN, count_word, counted
from fleet_tui.view.tables.table import Run, width_of

COUNTED = (
    *ODD,
    Activity.WAITING.value,
    Activity.DRIVING.value,
    Activity.LOADING.value,
    Activity.IDLE.value,
    Activity.CHARGING.value,
    UNKNOWN,
)
"""What robots online do: first what a person looks for."""
BESIDE = 10
RANGE = 7
"""Cells of the title beside the counts, and of `  1-2 of 3` beside its numbers."""
ALL_IN_VIEW = 12
"""Robots up to which nearly every pane has a row for each: of more the title tells which rows are in view."""


def fleet_counts(state: FleetState, done: Mapping[str, Activity], width: int) -> list[Run]:
    """Return how many robots are online and what all of them do, by the words of their rows. In less than
    `width` cells that all are online is left out, else only what is odd is told, if need be in the place of
    those online."""
    robots, digits = state.robots, len(str(len(state.robots)))
    left = width - BESIDE - (RANGE + 3 * digits) * (len(robots) > ALL_IN_VIEW)
    found = Counter(count_word(state, robot, done.get(name)) for name, robot in robots.items())
    offline = found.pop(Activity.OFFLINE.value, 0)
    online = len(robots) - offline
    present: Run = (tr(f" {online} of {len(robots)} online"), StyleRole.DIM)
    counts = [
        (counted(found[one], one), StyleRole.WARN if one in ODD else StyleRole.DIM)
        for one in COUNTED
        if found[one]
    ]
    odd = [one for one in counts if one[1] is StyleRole.WARN]
    away = [(f"{offline} {tr(Activity.OFFLINE.value)}", StyleRole.DIM)] if offline else []
    # A part of the counts would not add up.
    listed = [_listed([present], ": ", counts)]
    if not offline:
        listed.append(_listed([(f" {online}", StyleRole.DIM)], ": ", counts))
    listed.append(_listed([present], ": ", odd))
    listed += [_listed([], " ", [*away, *odd][:most]) for most in range(len([*away, *odd]), 0, -1)]
    return next((one for one in listed if width_of(one) <= left), [present])


def _listed(runs: Sequence[Run], first: str, counts: Sequence[Run]) -> list[Run]:
    more = [part for count in counts for part in ((", ", StyleRole.DIM), count)]
    return [*runs, *([(first, StyleRole.DIM), *more[1:]] if counts else [])]

"""The activities of robots, part by part of a time."""

from collections.abc import Iterable, Mapping, Sequence

from fleet_tui.model.history.facts import Activity
from fleet_tui.model.history.totals import ActivityTotal
from fleet_tui.records.history.division import Division
from fleet_tui.records.history.shift import DOWN

Timeline = Mapping[str, Sequence[Activity | None]]
"""What each robot did in most of each part of a time, None if nobody saw it."""

Shares = Mapping[str, Sequence[tuple[float, float] | None]]
"""Of each robot the parts of each part of a time, 0 to 1, in which it worked, and in which it could not; None
if nobody saw it."""

WORKING = frozenset({Activity.DRIVING, Activity.LOADING})

TROUBLE_FIRST = (
    Activity.BLOCKED,
    Activity.OFFLINE,
    Activity.PAUSED,
    Activity.DRIVING,
    Activity.LOADING,
    Activity.WAITING,
    Activity.CHARGING,
    Activity.IDLE,
)
"""Of two activities that took as long, the first one is told."""


def main_activities(robots: Iterable[str], time: Division, totals: Iterable[ActivityTotal]) -> Timeline:
    """Return the activity of each robot that took longest in each part."""
    longest: dict[tuple[str, int], tuple[float, int, Activity]] = {}
    for total in totals:
        rank = total.seconds, -TROUBLE_FIRST.index(total.activity), total.activity
        key = total.robot, total.part
        if total.seconds > 0.0 and (key not in longest or rank[:2] > longest[key][:2]):
            longest[key] = rank
    return {
        robot: [found[2] if (found := longest.get((robot, part))) else None for part in range(time.parts)]
        for robot in robots
    }


def shares(robots: Iterable[str], time: Division, totals: Iterable[ActivityTotal]) -> Shares:
    """Return how much of the watched time of each part each robot worked, and was down."""
    seen: dict[tuple[str, int], list[float]] = {}
    for total in totals:
        sums = seen.setdefault((total.robot, total.part), [0.0, 0.0, 0.0])
        sums[0] += total.seconds
        sums[1] += total.seconds * (total.activity in WORKING)
        sums[2] += total.seconds * (total.activity in DOWN)

    def share(robot: str, part: int) -> tuple[float, float] | None:
        watched, worked, down = seen.get((robot, part), (0.0, 0.0, 0.0))
        return (worked / watched, down / watched) if watched else None

    return {robot: [share(robot, part) for part in range(time.parts)] for robot in robots}

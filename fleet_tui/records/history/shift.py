"""A shift in figures: robots, routes, and causes of alarms."""

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence

from msgspec import Struct

from fleet_tui.model.commands import ORDER_ENDS, Tally
from fleet_tui.model.history.facts import Activity, LinkChange
from fleet_tui.model.history.lives import AlarmLife
from fleet_tui.model.history.totals import ActivityTotal, ChargeTotal, OrderTotal
from fleet_tui.model.order import natural

TALLIES = {stage.value: end.tally for stage, end in ORDER_ENDS.items()}
"""The column that counts an order, by the word of its end."""
NOT_DRIVEN = frozenset(word for word, tally in TALLIES.items() if tally in (Tally.LOST, Tally.LEFT))
"""The words of the ends after which nobody is known to have wanted the order away."""
DOWN = frozenset({Activity.BLOCKED, Activity.PAUSED, Activity.OFFLINE})
"""Activities of a robot that can't work."""


class OrderCounts(Struct):
    """Orders that ended: `late` are among the done ones; `lost` includes those that failed; `unseen` have an
    end that nobody saw. `seconds` is the sum of the `timed` done ones from begin to end, `longest` the
    longest."""

    done: int = 0
    late: int = 0
    lost: int = 0
    left: int = 0
    cancelled: int = 0
    unseen: int = 0
    timed: int = 0
    seconds: float = 0.0
    longest: float = 0.0

    def add(self, total: OrderTotal) -> None:
        match TALLIES.get(total.stage):
            case Tally.DONE:
                self.done += total.count
                self.late += total.late
                self.timed += total.timed
                self.seconds += total.seconds
                self.longest = max(self.longest, total.longest)
            case Tally.LOST:
                self.lost += total.count
            case Tally.LEFT:
                self.left += total.count
            case Tally.CANCELLED:
                self.cancelled += total.count
            case None:
                self.unseen += total.count

    @property
    def mean(self) -> float | None:
        """Return the mean seconds of a done order, None if none was timed."""
        return self.seconds / self.timed if self.timed else None


class RobotShift(Struct, frozen=True):
    """One robot: the seconds of each activity, the lowest and the last level of its battery in per cent, None
    if unknown."""

    name: str
    orders: OrderCounts
    seconds: Mapping[Activity, float]
    low: float | None
    last: float | None

    @property
    def down(self) -> float:
        """Return the seconds in which it could not work."""
        return sum(self.seconds.get(each, 0.0) for each in DOWN)

    @property
    def watched(self) -> float:
        """Return the seconds in which its activity was observed."""
        return sum(self.seconds.values())


class AlarmCause(Struct, frozen=True):
    """Alarms of one class: how often, the seconds that they held within the time, the longest, and the mean
    seconds until they were acknowledged, None if none was. `sources` counts robots and links."""

    kind: str
    priority: str
    count: int
    sources: int
    seconds: float
    longest: float
    until_seen: float | None


def counted(totals: Iterable[OrderTotal], by: str) -> dict[str, OrderCounts]:
    """Return counts `by` robot or way."""
    found: dict[str, OrderCounts] = defaultdict(OrderCounts)
    for total in totals:
        found[getattr(total, by)].add(total)
    return dict(found)


def robots_of(
    orders: Sequence[OrderTotal], activities: Iterable[ActivityTotal], charges: Iterable[ChargeTotal]
) -> list[RobotShift]:
    """Return each robot, by name."""
    counts = counted(orders, "robot")
    seconds: dict[str, dict[Activity, float]] = defaultdict(lambda: defaultdict(float))
    for total in activities:
        seconds[total.robot][total.activity] += total.seconds
    levels: dict[str, list[ChargeTotal]] = defaultdict(list)
    for charge in charges:
        levels[charge.robot].append(charge)
    return [
        RobotShift(name, counts.get(name, OrderCounts()), seconds.get(name, {}), *_levels(levels.get(name)))
        for name in sorted({*counts, *seconds, *levels}, key=natural)
    ]


def _levels(charges: Sequence[ChargeTotal] | None) -> tuple[float | None, float | None]:
    return (min(one.low for one in charges), charges[-1].last) if charges else (None, None)


def causes_of(alarms: Iterable[AlarmLife], since: float, until: float) -> list[AlarmCause]:
    """Return the classes of alarms that held in a time, those that held longest first."""
    by_class: dict[tuple[str, str], list[AlarmLife]] = defaultdict(list)
    for alarm in alarms:
        by_class[alarm.kind, alarm.priority].append(alarm)
    causes = [_cause(*key, lives, since, until) for key, lives in by_class.items()]
    return sorted(causes, key=lambda cause: -cause.seconds)


def _cause(kind: str, priority: str, lives: Sequence[AlarmLife], since: float, until: float) -> AlarmCause:
    held = [max(0.0, min(_over(life, until), until) - max(life.raised, since)) for life in lives]
    seen = [life.acknowledged - life.raised for life in lives if life.acknowledged is not None]
    return AlarmCause(
        kind,
        priority,
        sum(life.count for life in lives),
        len({life.source for life in lives}),
        sum(held),
        max(held),
        sum(seen) / len(seen) if seen else None,
    )


def _over(life: AlarmLife, until: float) -> float:
    over = life.returned if life.returned is not None else life.ended
    return until if over is None else over


def outages_of(links: Iterable[LinkChange], since: float, until: float) -> dict[str, tuple[int, float]]:
    """Return of each link how often it was lost in a time, and the seconds for which it was down."""
    down: dict[str, float | None] = {}
    found: dict[str, tuple[int, float]] = {}
    for change in links:
        count, seconds = found.get(change.link, (0, 0.0))
        begun = down.get(change.link)
        if change.is_up and begun is not None:
            seconds += max(0.0, min(change.at, until) - max(begun, since))
        elif not change.is_up and begun is None:
            count += change.at >= since
        down[change.link] = None if change.is_up else begun if begun is not None else change.at
        found[change.link] = count, seconds
    for link, begun in down.items():
        if begun is not None:
            count, seconds = found[link]
            found[link] = count, seconds + max(0.0, until - max(begun, since))
    return found

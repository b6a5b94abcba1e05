"""Sums of a history, mostly made by the database: a month of a hundred robots within seconds."""

import math
import sqlite3
from collections import defaultdict
from collections.abc import Iterable

from fleet_tui.model.history.facts import Activity
from fleet_tui.model.history.totals import ActivityTotal, BlockedPlace, ChargeTotal, OrderTotal
from fleet_tui.records.history.division import Division
from fleet_tui.records.history.observing import HOUR
from fleet_tui.records.history.reading import OBSERVED

LATE = 2.0
"""Times the mean of its way from which a done order was late."""
USUAL_FROM = 3
"""Done orders of a way from which their mean is the usual time."""
BY_WORD = {activity.value: activity for activity in Activity}
CELL = 0.5
"""Metres of a cell of blocked places."""

_ORDERS = """
WITH usual AS (
  SELECT way, avg(max(0.0, ended - begun)) AS mean FROM orders
  WHERE ended >= :since AND ended < :until AND stage = 'done' AND begun IS NOT NULL
  GROUP BY way HAVING count(*) >= :least)
SELECT robot, way, stage, count(*),
  sum(coalesce(stage = 'done' AND ended - begun > :late * mean, 0)), count(ended - begun),
  coalesce(sum(max(0.0, ended - begun)), 0.0), coalesce(max(0.0, max(ended - begun)), 0.0)
FROM orders LEFT JOIN usual USING (way) WHERE ended >= :since AND ended < :until GROUP BY robot, way, stage
"""
_HOURS = """
SELECT robot, (hour - :first) / :hours AS part, activity, sum(seconds) FROM hours
WHERE hour >= :first AND hour < :last GROUP BY robot, part, activity
"""
_SPANS = f"""
SELECT robot, activity, began, ended FROM spans
WHERE {OBSERVED} AND began > :since - 3600.0 AND began < :until AND ended > :since
"""
_CHARGES = f"""
SELECT robot, at, percent, percent FROM charges
WHERE {OBSERVED} AND at >= :since AND at < :until ORDER BY robot, at
"""
_CHARGE_HOURS = """
SELECT robot, hour * 3600.0, low, last FROM charge_hours
WHERE hour * 3600.0 >= :since AND hour * 3600.0 < :until ORDER BY robot, hour
"""
_BLOCKED = """
SELECT floor, x, y, min(ended, :until) - max(began, :since) FROM spans
WHERE activity = 'blocked' AND began > :since - 3600.0 AND began < :until AND ended > :since AND floor != ''
"""


class Totals:
    """The sums of one database. Methods raise sqlite3.Error."""

    def __init__(self, database: sqlite3.Connection) -> None:
        self._database = database

    def orders(self, since: float, until: float) -> list[OrderTotal]:
        """Return the orders that ended in a time."""
        values = {"since": since, "until": until, "late": LATE, "least": USUAL_FROM}
        return [OrderTotal(*row) for row in self._database.execute(_ORDERS, values)]

    def activities(self, time: Division) -> list[ActivityTotal]:
        """Return the seconds of each activity of each robot in each part of a time."""
        if time.is_exact:
            return _parts_of(time, self._database.execute(_SPANS, _limits(time)))
        first, last, hours = int(time.since // HOUR), int(time.until // HOUR), round(time.step / HOUR)
        rows = self._database.execute(_HOURS, {"first": first, "last": last, "hours": hours})
        return [ActivityTotal(robot, part, BY_WORD[does], seconds) for robot, part, does, seconds in rows]

    def charges(self, time: Division) -> list[ChargeTotal]:
        """Return the battery of each robot in each part of a time, by robot and part."""
        found: dict[tuple[str, int], tuple[float, float]] = {}
        rows = self._database.execute(_CHARGES if time.is_exact else _CHARGE_HOURS, _limits(time))
        for robot, at, low, last in rows:
            part = time.part(at)
            found[robot, part] = min(low, found.get((robot, part), (low, 0.0))[0]), last
        return [ChargeTotal(*key, *levels) for key, levels in found.items()]

    def blocked(self, since: float, until: float) -> list[BlockedPlace]:
        """Return the places where robots were blocked in a time, the longest first."""
        found: dict[tuple[str, int, int], float] = defaultdict(float)
        for floor, x, y, seconds in self._database.execute(_BLOCKED, {"since": since, "until": until}):
            found[floor, math.floor(x / CELL), math.floor(y / CELL)] += seconds
        places = [
            BlockedPlace(floor, (i + 0.5) * CELL, (j + 0.5) * CELL, seconds)
            for (floor, i, j), seconds in found.items()
        ]
        return sorted(places, key=lambda place: -place.seconds)


def _limits(time: Division) -> dict[str, float]:
    return {"since": time.since, "until": time.until}


def _parts_of(time: Division, spans: Iterable[tuple[str, str, float, float]]) -> list[ActivityTotal]:
    """Cut spans at the parts of a time."""
    seconds: dict[tuple[str, int, str], float] = defaultdict(float)
    for robot, does, began, ended in spans:
        began, ended = max(began, time.since), min(ended, time.until)
        for part in range(time.part(began), time.part(ended) + 1):
            begin = time.since + part * time.step
            seconds[robot, part, does] += max(0.0, min(ended, begin + time.step) - max(began, begin))
    return [ActivityTotal(robot, part, BY_WORD[does], sum_) for (robot, part, does), sum_ in seconds.items()]

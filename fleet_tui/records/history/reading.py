"""Reads a history, also while a console writes it."""

import json
import sqlite3
from collections.abc import Collection, Iterator, Sequence
from contextlib import suppress
from typing import Any, TypeVar

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.commands.confirmation import IN_QUEUE
from fleet_tui.model.commands import Stage
from fleet_tui.model.history.facts import Activity, Charge, LinkChange, Note, Span
from fleet_tui.model.history.lives import AlarmLife, PastCommand, PastOrder
from fleet_tui.records.history.observing import HOUR
from fleet_tui.text.language import EMPTY, Message, message_with_values

S = TypeVar("S", bound=Struct)

OBSERVED = (
    "robot IN (SELECT DISTINCT robot FROM hours WHERE hour >= :since / 3600 - 1 AND hour <= :until / 3600)"
)
"""Limits a query to the robots that were observed in a time: their name is the first column of the keys."""

MOST = 100_000
NUMBERED_WITHIN = 600.0
"""Seconds from a command to the number of its order, which is another order's after the robot restarts."""


class History:
    """The answers of one database; times are Unix seconds, lists are oldest first. Methods raise
    sqlite3.Error."""

    def __init__(self, database: sqlite3.Connection, most: int = MOST) -> None:
        """`most` are the rows of one answer, the newest."""
        self.database = database
        self._most = most

    def orders(
        self, since: float, until: float, robot: str = "", stages: Collection[str] = ()
    ) -> list[PastOrder]:
        """Return the orders that were queued, driven or ended in a time; with `stages` those ended so."""
        wanted = "queued < :until AND (ended IS NULL OR ended >= :since)"
        if stages:
            wanted = f"ended >= :since AND ended < :until{_at(stages)}"
        return self._rows(
            PastOrder, "orders", ORDER, wanted=wanted, by="queued", since=since, until=until, robot=robot
        )

    def open_orders(self) -> list[PastOrder]:
        """Return the orders that have not ended, also those that wait in a console. Who gave one is known to
        the console that gave it: if another one observes, by that one's command."""
        rows = self.database.execute(OPEN_ORDERS, {"waiting": Stage.WAITING.value})
        return [self._with_messages(PastOrder(*row)) for row in rows]

    def open_alarms(self) -> list[AlarmLife]:
        """Return the alarms that hold, or that nobody has acknowledged."""
        query = f"SELECT {', '.join(ALARM)} FROM alarms WHERE ended IS NULL ORDER BY raised"
        return [self._with_messages(AlarmLife(*row)) for row in self.database.execute(query)]

    def alarms(self, since: float, until: float, robot: str = "") -> list[AlarmLife]:
        """Return the alarms that were raised or held in a time."""
        # One that returned holds no more, even if nobody ever acknowledges it.
        wanted = "raised < :until AND coalesce(returned, ended, :until) >= :since"
        return self._rows(
            AlarmLife,
            "alarms",
            ALARM,
            wanted=wanted,
            by="raised",
            since=since,
            until=until,
            robot=robot,
            named="source",
        )

    def commands(
        self, since: float, until: float, robot: str = "", stages: Collection[str] = ()
    ) -> list[PastCommand]:
        """Return the commands that were given in a time, with `stages` only those that ended so."""
        wanted = f"at >= :since AND at < :until{_at(stages)}"
        return self._rows(
            PastCommand, "commands", COMMAND, wanted=wanted, by="at", since=since, until=until, robot=robot
        )

    def links(self, since: float, until: float) -> list[LinkChange]:
        """Return the changes of links in a time, and the last one of each before it."""
        before = "SELECT max(at), link, is_up, reason FROM links WHERE at < ? GROUP BY link"
        within = "SELECT at, link, is_up, reason FROM links WHERE at >= ? AND at < ? ORDER BY at"
        rows = [*self.database.execute(before, (since,)), *self.database.execute(within, (since, until))]
        return [LinkChange(link, at, bool(is_up), self._message(reason)) for at, link, is_up, reason in rows]

    def notes(self, since: float, until: float) -> list[Note]:
        """Return the remarks of operators in a time."""
        rows = self.database.execute(
            "SELECT at, operator, text FROM notes WHERE at >= ? AND at < ? ORDER BY at", (since, until)
        )
        return [Note(*row) for row in rows]

    def robots(self, since: float, until: float) -> list[str]:
        """Return the names of the robots that were observed in a time."""
        rows = self.database.execute(
            "SELECT DISTINCT robot FROM hours WHERE hour >= ? AND hour <= ?",
            (int(since // HOUR), int(until // HOUR)),
        )
        return [row[0] for row in rows]

    def begun(self) -> float | None:
        """Return when a robot was first observed, None if none was yet."""
        of_each = (
            "SELECT min((SELECT min(began) FROM spans WHERE spans.robot = one.robot))"
            " FROM (SELECT DISTINCT robot FROM hours) AS one"
        )
        (first,) = self.database.execute(of_each).fetchone()
        return None if first is None else float(first)

    def watched_until(self) -> float | None:
        """Return when anybody last observed a robot, None for never."""
        (last,) = self.database.execute("SELECT max(hour) FROM hours").fetchone()
        if last is None:
            return None
        query = f"SELECT max(ended) FROM spans WHERE {OBSERVED} AND began >= :since - 3600.0"
        (ended,) = self.database.execute(query, {"since": last * HOUR, "until": (last + 1) * HOUR}).fetchone()
        return None if ended is None else float(ended)

    def spans(self, robot: str, since: float, until: float) -> list[Span]:
        """Return what a robot did in a time, cut at full hours; the first may have begun before."""
        rows = self.database.execute(
            "SELECT robot, activity, began, ended, floor, x, y FROM spans"
            " WHERE robot = ? AND began > ? AND began < ? AND ended >= ? ORDER BY began",
            (robot, since - HOUR, until, since),
        )
        return [_span(row) for row in rows]

    def blocked(self, since: float, until: float) -> list[Span]:
        """Return the times in which any robot was blocked."""
        rows = self.database.execute(
            "SELECT robot, activity, began, ended, floor, x, y FROM spans"
            " WHERE activity = 'blocked' AND began > ? AND began < ? AND ended >= ? ORDER BY began",
            (since - HOUR, until, since),
        )
        return [_span(row) for row in rows]

    def seconds(self, robot: str, since: float, until: float) -> dict[int, dict[Activity, float]]:
        """Return the seconds of each activity of a robot by hour (Unix seconds // 3600), whole hours."""
        rows = self.database.execute(
            "SELECT hour, activity, seconds FROM hours WHERE robot = ? AND hour >= ? AND hour <= ?",
            (robot, int(since // HOUR), int(until // HOUR)),
        )
        found: dict[int, dict[Activity, float]] = {}
        for hour, activity, seconds in rows:
            found.setdefault(hour, {})[Activity(activity)] = seconds
        return found

    def charges(self, robot: str, since: float, until: float) -> list[Charge]:
        """Return the battery of a robot in a time."""
        rows = self.database.execute(
            "SELECT robot, at, percent FROM charges WHERE robot = ? AND at >= ? AND at < ? ORDER BY at",
            (robot, since, until),
        )
        return [Charge(*row) for row in rows]

    def _with_messages(self, row: S) -> S:
        """Return a row with the texts of its console as messages."""
        match row:
            case AlarmLife():
                return replace(row, kind=Message(row.kind), text=self._message(row.text))
            case PastOrder() | PastCommand():
                return replace(row, reason=self._message(row.reason))
            case _:
                return row

    def _message(self, text: str) -> Message:
        """Return a text as its console made it. One without values, or of an older console, is looked up."""
        if not text:
            return EMPTY
        with suppress(sqlite3.OperationalError, ValueError, KeyError, TypeError, AttributeError):
            row = self.database.execute("SELECT message FROM messages WHERE text = ?", (text,)).fetchone()
            if row is not None and (message := message_with_values(json.loads(row[0]))) == text:
                return message
        return Message(text)

    def _rows(
        self,
        kind: type[S],
        table: str,
        columns: Sequence[str],
        *,
        wanted: str,
        by: str,
        since: float,
        until: float,
        robot: str,
        named: str = "robot",
    ) -> list[S]:
        of_robot = f" AND {named} = :robot" if robot else ""
        query = f"SELECT {', '.join(columns)} FROM {table} WHERE {wanted}{of_robot} ORDER BY {by} DESC"
        values = {"since": since, "until": until, "robot": robot}
        rows: Iterator[Any] = self.database.execute(f"{query} LIMIT {self._most}", values)
        return [self._with_messages(kind(*row)) for row in rows][::-1]


ORDER = ("robot", "name", "way", "floor", "queued", "begun", "ended", "stage", "reason", "operator")
ALARM = (
    "source",
    "kind",
    "priority",
    "text",
    "raised",
    "returned",
    "acknowledged",
    "ended",
    "operator",
    "count",
)
PLACED = f"""FROM commands WHERE commands.robot = orders.robot
  AND commands.reason = '{IN_QUEUE}' || orders.name
  AND (orders.name GLOB '*[^0-9]*' OR commands.at > orders.queued - {NUMBERED_WITHIN})
  ORDER BY at DESC LIMIT 1"""
"""The command of any console that placed an order."""
OPEN_ORDERS = f"""
SELECT robot, name, coalesce((SELECT nullif(commands.way, '') {PLACED}), way), floor, queued, begun, ended,
  stage, reason, coalesce(nullif(operator, ''), (SELECT commands.operator {PLACED}), '')
FROM orders WHERE ended IS NULL
UNION ALL
SELECT robot, '', way, '', at, NULL, NULL, stage, reason, operator FROM commands WHERE stage = :waiting
ORDER BY 5
"""
COMMAND = ("at", "operator", "robot", "what", "way", "stage", "reason")


def _at(stages: Collection[str]) -> str:
    """Return a condition on stages, which are words of this program."""
    quoted = ", ".join(f"'{stage}'" for stage in sorted(stages))
    return f" AND stage IN ({quoted})" if stages else ""


def _span(row: Sequence[Any]) -> Span:
    robot, activity, *rest = row
    return Span(robot, Activity(activity), *rest)

"""Facts into the tables of a history."""

import json
import logging
import sqlite3
from collections.abc import Iterable
from datetime import datetime
from typing import assert_never

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.model.commands import NEXT, ORDER_ENDS, RESTARTED, Stage
from fleet_tui.model.history.facts import Charge, LaterCause, LinkChange, Note, OrderChange, Span
from fleet_tui.model.order_life import STARTED_OVER
from fleet_tui.records.history.observing import BEGUN, HOUR, QUEUED, Fact
from fleet_tui.text.language import Message, is_verbatim, verbatim, with_values

LOG = logging.getLogger(__name__)
ENDS = frozenset(stage.value for stage in ORDER_ENDS)
INFERRED = frozenset(stage.value for stage, end in ORDER_ENDS.items() if end.is_inferred)
STAGES = frozenset(stage.value for stage in Stage)
UNSEEN = "end not seen"
"""The stage of an order that was open when nobody observed the fleet."""
LISTED_AGAIN_WITHIN = 600.0
"""Seconds after an inferred end in which an order of the same name is that one, listed again."""
SAME_END = 5.0
"""Seconds by which two consoles may differ on the end of an order."""


MALFORMED = (sqlite3.IntegrityError, sqlite3.DataError, sqlite3.ProgrammingError, ValueError, OverflowError)
"""Errors of one fact, not of the database."""


def write_all(
    database: sqlite3.Connection, facts: Iterable[Fact | Note | AuditRecord], run: str, operator: str
) -> None:
    """Write facts of a console's run. One that no table can hold is logged, and stops no other."""
    for fact in facts:
        try:
            write(database, fact, run, operator)
        except MALFORMED:
            LOG.exception("history: not written: %r", fact)


def write(database: sqlite3.Connection, fact: Fact | Note | AuditRecord, run: str, operator: str) -> None:
    """Write one fact of a console's run. The same fact written twice counts once."""
    _keep_message(database, fact)
    match fact:
        case Span():
            _write_span(database, fact)
        case Charge():
            _write_charge(database, fact)
        case OrderChange():
            _write_order(database, fact, run, operator if fact.request is not None else "")
        case LinkChange():
            database.execute(
                "INSERT INTO links VALUES (?, ?, ?, ?)", (fact.at, fact.link, fact.is_up, fact.reason)
            )
        case LaterCause():
            database.execute(
                "UPDATE alarms SET text = ? WHERE (run, source, kind) = (?, ?, ?) AND ended IS NULL",
                (fact.text, run, fact.source, fact.kind),
            )
        case Note():
            # Consoles of one user have one history, and each of them is told the notes of the desk.
            database.execute(
                "INSERT INTO notes SELECT ?1, ?2, ?3 WHERE NOT EXISTS"
                " (SELECT 1 FROM notes WHERE (at, operator, text) = (?1, ?2, ?3))",
                (fact.at, fact.operator, fact.text),
            )
        case AuditRecord():
            write_record(database, fact)
        case _:
            assert_never(fact)


def _keep_message(database: sqlite3.Connection, fact: Fact | Note | AuditRecord) -> None:
    match fact:
        case OrderChange(reason=text) | LinkChange(reason=text) | AuditRecord(words=text):
            pass
        case LaterCause(text=text):
            pass
        case _:
            return
    message = text if isinstance(text, Message) else verbatim(text)
    if message.values:
        kept = json.dumps(with_values(message))
        # What somebody else has said, too, is never translated.
        otherwise = "REPLACE" if is_verbatim(message) else "IGNORE"
        database.execute(f"INSERT OR {otherwise} INTO messages VALUES (?, ?)", (str(text), kept))


def _write_span(database: sqlite3.Connection, span: Span) -> None:
    """A span that grew replaces itself; the hours grow by what is new of it."""
    row = database.execute(
        "SELECT ended FROM spans WHERE robot = ? AND began = ?", (span.robot, span.began)
    ).fetchone()
    new = span.ended - (row[0] if row else span.began)
    database.execute(
        "INSERT OR REPLACE INTO spans VALUES (?, ?, ?, ?, ?, ?, ?)",
        (span.robot, span.began, span.ended, span.activity.value, span.floor, span.x, span.y),
    )
    database.execute(
        "INSERT INTO hours VALUES (?, ?, ?, ?)"
        " ON CONFLICT DO UPDATE SET seconds = seconds + excluded.seconds",
        (span.robot, int(span.began // HOUR), span.activity.value, new),
    )


def _write_charge(database: sqlite3.Connection, charge: Charge) -> None:
    database.execute(
        "INSERT OR REPLACE INTO charges VALUES (?, ?, ?)", (charge.robot, charge.at, charge.percent)
    )
    database.execute(
        "INSERT INTO charge_hours VALUES (?, ?, ?, ?)"
        " ON CONFLICT DO UPDATE SET low = min(low, excluded.low), last = excluded.last",
        (charge.robot, int(charge.at // HOUR), charge.percent, charge.percent),
    )


def _write_order(database: sqlite3.Connection, change: OrderChange, run: str, operator: str) -> None:
    row = _open_order(database, change, run)
    if row is None and change.stage not in ENDS:
        row = _listed_again(database, change, run)
    is_end = change.stage in ENDS and (row is None or row[1] > change.at)
    if is_end and (_has_ended(database, change) or _is_corrected(database, change, run)):
        return
    if row is None:
        _insert_order(database, change, run, operator)
        return
    times = {QUEUED: "", BEGUN: ", begun = coalesce(begun, :at), queued = min(queued, :at)"}.get(
        change.stage, ", ended = :at"
    )
    stage = "" if change.stage == QUEUED else ", stage = :stage, reason = :reason"
    database.execute(
        "UPDATE orders SET operator = coalesce(nullif(:operator, ''), operator),"
        f" request = coalesce(:request, request), run = :run,"
        # A console that does not know where it began knows less.
        " way = CASE WHEN instr(way, ' -> ') AND NOT instr(:way, ' -> ') THEN way ELSE :way END"
        f"{times}{stage} WHERE id = :id",
        {
            "operator": operator,
            "request": change.request,
            "run": run,
            "way": change.way,
            "at": change.at,
            "stage": change.stage,
            "reason": change.reason,
            "id": row[0],
        },
    )


def _open_order(database: sqlite3.Connection, change: OrderChange, run: str) -> tuple[int, float] | None:
    """Return the row of an order that has not ended, and when it was queued. Its way has other names as soon
    as a console has the labels of its vertices, and none for a console that does not know its goal; a number
    may be that of another order of a robot that has restarted, any other name is unique."""
    found: tuple[int, float] | None = database.execute(
        "SELECT id, queued FROM orders WHERE robot = :robot AND name = :name AND ended IS NULL"
        " AND (way = :way OR run = :run OR name GLOB '*[^0-9]*') ORDER BY way = :way DESC",
        {"robot": change.robot, "name": change.order, "way": change.way, "run": run},
    ).fetchone()
    return found


def _listed_again(database: sqlite3.Connection, change: OrderChange, run: str) -> tuple[int, float] | None:
    """Open the row of an order again that was thought to have ended; return it and when it was queued."""
    inferred = ", ".join(f"'{stage}'" for stage in sorted(INFERRED))
    found: tuple[int, float] | None = database.execute(
        "UPDATE orders SET ended = NULL, stage = :stage, reason = '' WHERE id = (SELECT max(id) FROM orders"
        f" WHERE robot = :robot AND name = :name AND stage IN ({inferred}) AND reason != :restarted"
        " AND ended > :at - :same AND (way = :way OR run = :run)) RETURNING id, queued",
        {
            "stage": change.stage,
            "robot": change.robot,
            "name": change.order,
            "restarted": STARTED_OVER,
            "at": change.at,
            "same": LISTED_AGAIN_WITHIN,
            "way": change.way,
            "run": run,
        },
    ).fetchone()
    return found


def _has_ended(database: sqlite3.Connection, change: OrderChange) -> bool:
    """Tell whether another console has already told this end, or knows better than what is inferred here:
    each sees it at its own time."""
    query = "SELECT stage FROM orders WHERE ended BETWEEN ? AND ? AND robot = ? AND name = ?"
    values = (change.at - SAME_END, change.at + SAME_END, change.robot, change.order)
    told = {stage for (stage,) in database.execute(query, values)}
    return change.stage in told or (change.stage in INFERRED and not told <= INFERRED)


def _is_corrected(database: sqlite3.Connection, change: OrderChange, run: str) -> bool:
    """Replace an end that was not final by what is known now; tell whether there was one."""
    told = Stage(change.stage)
    stages = [stage for stage, end in ORDER_ENDS.items() if end.is_inferred or told in NEXT[stage]]
    corrected = ", ".join(f"'{stage.value}'" for stage in stages)
    cursor = database.execute(
        "UPDATE orders SET stage = :stage, reason = :reason WHERE id = (SELECT max(id) FROM orders"
        f" WHERE robot = :robot AND name = :name AND stage IN ({corrected})"
        " AND (abs(ended - :at) <= :same OR (run = :run AND request = :request)))",
        {
            "stage": change.stage,
            "reason": change.reason,
            "robot": change.robot,
            "name": change.order,
            "at": change.at,
            "same": SAME_END,
            "run": run,
            "request": change.request,
        },
    )
    return cursor.rowcount > 0


def _insert_order(database: sqlite3.Connection, change: OrderChange, run: str, operator: str) -> None:
    begun = change.at if change.stage == BEGUN else None
    ended = change.at if change.stage not in (QUEUED, BEGUN) else None
    database.execute(
        "INSERT INTO orders (robot, name, way, floor, queued, begun, ended, stage, reason, operator, run,"
        " request) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
        (
            change.robot,
            change.order,
            change.way,
            change.floor,
            change.at,
            begun,
            ended,
            change.stage,
            change.reason,
            operator,
            run,
            change.request,
        ),
    )


def end_unseen(database: sqlite3.Connection, robot: str, still: set[str]) -> None:
    """End the orders of a robot that were open when nobody observed it, and are not in its queue now."""
    rows = database.execute("SELECT id, name FROM orders WHERE robot = ? AND ended IS NULL", (robot,))
    for id_, name in rows.fetchall():
        if name not in still:
            database.execute(
                "UPDATE orders SET stage = ?, ended = coalesce(begun, queued) WHERE id = ?", (UNSEEN, id_)
            )


def end_unseen_alarms(database: sqlite3.Connection, at: float, run: str) -> None:
    """End the alarms that were held when the console of another run ended, at a moment or when anybody last
    watched: such an alarm never returned."""
    database.execute(
        "UPDATE alarms SET ended = max(raised, min(:at, coalesce((SELECT max(ended) FROM spans), :at)))"
        " WHERE ended IS NULL AND returned IS NULL AND run != :run",
        {"at": at, "run": run},
    )
    database.execute("UPDATE alarms SET ended = returned WHERE ended IS NULL AND run != ?", (run,))


def write_record(database: sqlite3.Connection, record: AuditRecord) -> None:
    """Write a record of the audit log: a step of a command or of an alarm."""
    at = datetime.fromisoformat(record.time).timestamp()
    if record.kind == "command" and record.id is not None and record.change in STAGES:
        _write_command(database, record, at)
    elif record.kind == "alarm":
        _write_alarm(database, record, at)


def _write_command(database: sqlite3.Connection, record: AuditRecord, at: float) -> None:
    names = [record.start_label or record.start, record.end_label or record.end]
    way = " -> ".join(filter(None, names)) or (f"order {record.order}" if record.what == "cancel" else "")
    if record.words == RESTARTED:  # it has taken over all orders of its earlier run: each waits once
        database.execute(
            "DELETE FROM commands WHERE stage = ? AND (operator, robot) = (?, ?) AND run != ?",
            (Stage.WAITING.value, record.operator, record.robot, record.run),
        )
    database.execute(
        "INSERT INTO commands VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"
        " ON CONFLICT DO UPDATE SET stage = excluded.stage, reason = excluded.reason",
        (
            record.run,
            record.id,
            at,
            record.operator,
            record.robot,
            record.what,
            way,
            record.change,
            record.words,
        ),
    )


def _write_alarm(database: sqlite3.Connection, record: AuditRecord, at: float) -> None:
    """Each return ends a row, so that the time until an alarm is raised again does not count as held."""
    source, change = record.robot or record.link, record.change
    key = (record.run, source, record.what)
    query = "SELECT id, returned FROM alarms WHERE run = ? AND source = ? AND kind = ? AND ended IS NULL"
    row = database.execute(query, key).fetchone()
    if row is not None and change.startswith("raised again") and row[1] is not None:
        database.execute("UPDATE alarms SET ended = returned WHERE id = ?", row[:1])
        row = None
    if row is None and change.startswith("acknowledged"):
        _acknowledge_elsewhere(database, record, at)
        return
    if row is None:
        count = 1 if change.startswith("raised again") else max(1, record.count)
        cursor = database.execute(
            "INSERT INTO alarms (run, source, kind, priority, text, raised, operator, count)"
            " VALUES (?, ?, ?, ?, ?, ?, '', ?)",
            (*key, record.priority, record.words, at, count),
        )
        row = (cursor.lastrowid, None)
    said = f" WHERE id = {row[0]}"
    if change.startswith("acknowledged"):
        database.execute("UPDATE alarms SET acknowledged = ?, operator = ?" + said, (at, record.operator))
    if "returned" in change:
        database.execute("UPDATE alarms SET returned = ?" + said, (at,))
    if "cleared" in change:
        database.execute("UPDATE alarms SET ended = ?, returned = coalesce(returned, ?)" + said, (at, at))
    if change.startswith("worse"):
        database.execute("UPDATE alarms SET count = max(count, ?)" + said, (record.count,))


def _acknowledge_elsewhere(database: sqlite3.Connection, record: AuditRecord, at: float) -> None:
    """Write that an operator of a console that does not observe has seen an alarm: the first one counts."""
    database.execute(
        "UPDATE alarms SET acknowledged = :at, operator = :operator WHERE acknowledged IS NULL AND id ="
        " (SELECT max(id) FROM alarms WHERE source = :source AND kind = :kind AND ended IS NULL)",
        {"at": at, "operator": record.operator, "source": record.robot or record.link, "kind": record.what},
    )

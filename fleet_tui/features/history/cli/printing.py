"""A history as text, JSON or CSV."""

import csv
import json
from collections.abc import Sequence
from datetime import datetime
from enum import Enum
from operator import attrgetter
from typing import Any, TextIO, assert_never

from fleet_tui.features.history.events import EventKind, PastEvent, matching, past_events
from fleet_tui.model.history.facts import Activity
from fleet_tui.records.audit.export import cell
from fleet_tui.records.history.observing import HOUR
from fleet_tui.records.history.reading import History

COLUMNS = ("time", "ended", "kind", "subject", "what", "outcome", "detail", "operator")
VERSION = 1
BY_BEGIN = attrgetter("at")
"""The order of data, whose time is a begin; the text has the time of an order's end."""
STALE = 120.0
"""Seconds without a fact of any robot after which nobody observes them: there is one each minute."""


class Form(Enum):
    """The form of what is printed."""

    TEXT = "text"
    JSON = "JSON"
    CSV = "CSV"


def print_events(
    history: History, since: float, until: float, words: Sequence[str], robot: str, form: Form, out: TextIO
) -> None:
    """Write what happened in a time, to one robot (empty: all), with every word."""
    events = events_of(history, since, until, words, robot)
    match form:
        case Form.TEXT:
            write_text(events, since, out)
            out.write(unwatched(history.watched_until(), until))
        case Form.JSON:
            out.write(f"{as_json(history, events, since, until, robot)}\n")
        case Form.CSV:
            write_csv(events, out)
        case _:
            assert_never(form)


def events_of(
    history: History, since: float, until: float, words: Sequence[str], robot: str
) -> list[PastEvent]:
    """Return what happened in a time, to one robot (empty: to all), with every word."""
    events = past_events(
        history.orders(since, until, robot),
        history.alarms(since, until, robot),
        history.commands(since, until, robot),
        () if robot else history.links(since, until),
        () if robot else history.notes(since, until),
    )
    # The state of a link before the time is no event of it; an order or an alarm lasts into it.
    lasting = (EventKind.ORDER, EventKind.ALARM)
    return [event for event in matching(events, words, robot) if event.at >= since or event.kind in lasting]


def write_text(events: Sequence[PastEvent], since: float, out: TextIO) -> None:
    """Write a line for each event, oldest first."""
    out.writelines(f"{moment(event.told_at)}  {event.text}\n" for event in events)
    if not events:
        out.write(f"nothing happened since {moment(since)}\n")


def unwatched(last: float | None, now: float) -> str:
    """Return a line that says since when nobody observes the robots, empty if somebody does."""
    if last is not None and now - last < STALE:
        return ""
    since = "yet" if last is None else f"since {moment(last)}"
    return f"nobody watches {since}: an open console does, and `fleet-tui history --collect`\n"


def moment(at: float) -> str:
    """Return a local time: `05-31 12:04:31`."""
    return f"{datetime.fromtimestamp(at).astimezone():%m-%d %H:%M:%S}"


def iso(at: float | None) -> str:
    """Return a time in ISO 8601 with the offset, empty for None."""
    if at is None:
        return ""
    return datetime.fromtimestamp(at).astimezone().isoformat(timespec="seconds")


def write_csv(events: Sequence[PastEvent], out: TextIO) -> None:
    """Write a line of names and one for each event; no value is run as a formula."""
    writer = csv.writer(out)
    writer.writerow(COLUMNS)
    for event in sorted(events, key=BY_BEGIN):
        texts = (event.subject, event.what, event.outcome, event.detail, event.operator)
        writer.writerow([iso(event.at), iso(event.ended), event.kind.value, *map(cell, texts)])


def as_json(history: History, events: Sequence[PastEvent], since: float, until: float, robot: str) -> str:
    """Return a JSON object; docs/history.md has its schema."""
    robots = [robot] if robot else history.robots(since, until)
    told: dict[str, Any] = {
        "version": VERSION,
        "since": iso(since),
        "until": iso(until),
        "events": [_event(event) for event in sorted(events, key=BY_BEGIN)],
        "robots": {name: _seconds(history, name, since, until) for name in robots},
    }
    return json.dumps(told, indent=2)  # ASCII: texts of robots may hold what a terminal obeys


def _event(event: PastEvent) -> dict[str, Any]:
    return {
        "time": iso(event.at),
        "ended": iso(event.ended) or None,
        "kind": event.kind.value,
        **{name: getattr(event, name) for name in COLUMNS[3:]},
        "trouble": event.is_trouble,
    }


def _seconds(history: History, robot: str, since: float, until: float) -> dict[str, float]:
    """Return the seconds of each activity within the time."""
    total = dict.fromkeys(Activity, 0.0)
    for span in history.spans(robot, since, until) if until - since <= 48 * HOUR else ():
        total[span.activity] += max(0.0, min(span.ended, until) - max(span.began, since))
    if until - since > 48 * HOUR:  # whole hours are exact enough for so long a time
        for hour in history.seconds(robot, since, until).values():
            for activity, seconds in hour.items():
                total[activity] += seconds
    return {activity.value: round(seconds, 1) for activity, seconds in total.items() if seconds}

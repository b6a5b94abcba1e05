"""Filters on records, as an operator types them: `robot:robot_0 outcome:refused since:2h store`."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from datetime import datetime, timedelta

from fleet_tui.model.audit_record import AuditRecord
from fleet_tui.records.audit.line import line_text
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

_SPAN = re.compile(r"(\d{1,6})([mhd])")
_UNITS = {"m": "minutes", "h": "hours", "d": "days"}
TIME_FORMS = "30m, 2h, 7d, 12:00, 2024-05-31 or 2024-05-31T12:00"


@dataclass(frozen=True, slots=True)
class Search:
    """A filter on records; empty fields match everything. All `words` must be in its line; `outcome` is the
    beginning of its change. Records of the demo and of real fleets are never mixed."""

    words: tuple[str, ...] = ()
    robot: str = ""
    operator: str = ""
    outcome: str = ""
    request: str = ""
    since: datetime | None = None
    until: datetime | None = None
    demo: bool = False

    def wants(self, record: AuditRecord) -> bool:
        return (
            record.demo == self.demo
            and self.robot in ("", record.robot)
            and self.operator in ("", record.operator)
            and record.change.startswith(self.outcome)
            and self.request in ("", str(record.id))
            and self._is_in_time(record)
            and self._matches_text(record)
        )

    def _is_in_time(self, record: AuditRecord) -> bool:
        if self.since is None and self.until is None:
            return True
        try:
            at = datetime.fromisoformat(record.time).astimezone()
        except (ValueError, OverflowError):
            return False
        return (self.since is None or at >= self.since) and (self.until is None or at <= self.until)

    def _matches_text(self, record: AuditRecord) -> bool:
        if not self.words:
            return True
        line = line_text(record).casefold()
        return all(word in line for word in self.words)


def moment(text: str, now: datetime) -> datetime:
    """Return the time that an operator means. `now` has its offset. Raises FleetError."""
    span = _SPAN.fullmatch(text)
    try:
        if span:
            return now - timedelta(**{_UNITS[span[2]]: int(span[1])})
        if re.fullmatch(r"\d\d?:\d\d", text):
            hour, minute = map(int, text.split(":"))
            return now.replace(hour=hour, minute=minute, second=0, microsecond=0)
        # Without an offset it is local time.
        return datetime.fromisoformat(text).astimezone()
    except (ValueError, OverflowError):
        raise FleetError(
            Message("{text} is not a time: use {time_forms}", text=f"{text!r}", time_forms=TIME_FORMS)
        ) from None


def search_of(typed: str, now: datetime, demo: bool = False) -> Search:
    """Return typed text as a search. Raises FleetError for an invalid time."""
    search = Search(demo=demo)
    for word in typed.split():
        name, colon, value = word.partition(":")
        if colon and value and name in _FIELDS:
            search = _FIELDS[name](search, value, now)
        else:
            search = replace(search, words=(*search.words, word.casefold()))
    return search


_FIELDS: Mapping[str, Callable[[Search, str, datetime], Search]] = {
    "robot": lambda search, value, _: replace(search, robot=value),
    "by": lambda search, value, _: replace(search, operator=value),
    "outcome": lambda search, value, _: replace(search, outcome=value.replace("-", " ")),
    "request": lambda search, value, _: replace(search, request=value),
    "since": lambda search, value, now: replace(search, since=moment(value, now)),
    "until": lambda search, value, now: replace(search, until=moment(value, now)),
}

"""A time in a recording as a person writes it: 12:04:31, 2024-05-31T12:04, +90s, +1m30s."""

import math
import re
from contextlib import suppress
from datetime import date, datetime, time, timedelta

from fleet_tui.records.recording.recording import Recording
from fleet_tui.text.errors import FleetError
from fleet_tui.text.language import Message

FORMS = "12:04:31, 2024-05-31T12:04:31, or from the start +90s or +1m30s"

_SPAN = re.compile(r"\+\s*(?:(\d+)\s*h)?\s*(?:(\d+)\s*m(?:in)?)?\s*(?:(\d+(?:\.\d+)?)\s*s?)?", re.IGNORECASE)


def moment_of(text: str, recording: Recording) -> float:
    """Return the monotonic second of a written time. Raises FleetError for one that is invalid, or not in the
    recording."""
    text = text.strip()
    found = _SPAN.fullmatch(text)
    if found is not None and any(found.groups()):
        hours, minutes, seconds = (float(part or 0) for part in found.groups())
        return _inside(recording.begin.at + 3600 * hours + 60 * minutes + seconds, text, recording)
    return _inside(_at_wall(_wall_of(text, recording), recording), text, recording)


def _wall_of(text: str, recording: Recording) -> float:
    """Return the Unix time of a date with a time, or of the first such time of day after the recording
    began."""
    with suppress(ValueError, OverflowError):
        return datetime.fromisoformat(text).astimezone().timestamp()
    problem = FleetError(Message("{text} is not a time: use {forms}", text=f"{text!r}", forms=FORMS))
    try:
        of_day = time.fromisoformat(text if ":" in text else "")
    except ValueError:
        raise problem from None
    if of_day.tzinfo is not None:
        raise problem
    began = datetime.fromtimestamp(recording.begin.wall)
    days = (datetime.combine(_day(began, days), of_day) for days in range(3))
    # A time without fractions means all of its second.
    return next(day for day in days if day >= began.replace(microsecond=0)).timestamp()


def _day(began: datetime, days: int) -> date:
    return began.date() + timedelta(days=days)


def _at_wall(wall: float, recording: Recording) -> float:
    """Return the monotonic second of a Unix time: in the last span between two keyframes that has it, since a
    clock may have been set back; else the end of the last one that began before it."""
    known = recording.keyframes
    ends = [*(moment.at for moment in known[1:]), math.inf]
    begun = [
        (moment.at + wall - moment.wall, end)
        for moment, end in zip(known, ends, strict=True)
        if moment.wall <= wall
    ]
    inside = [at for at, end in begun if at <= min(end, recording.end.at)]
    return inside[-1] if inside else min(begun[-1]) if begun else known[0].at + wall - known[0].wall


def _inside(at: float, text: str, recording: Recording) -> float:
    begin, end = recording.begin, recording.end
    if begin.at - 1.0 <= at <= end.at + 1.0:
        return max(begin.at, min(at, end.at))
    first, last = (f"{datetime.fromtimestamp(wall):%Y-%m-%d %H:%M:%S}" for wall in (begin.wall, end.wall))
    why = f" ({recording.note})" if recording.note else ""
    raise FleetError(
        Message(
            "{text} is not in the recording, which covers {first} to {last}{why}",
            text=text,
            first=first,
            last=last,
            why=why,
        )
    )

"""Timestamps of messages: ISO 8601 in UTC, with 0 to 3 decimals or more."""

import calendar
import re
from functools import lru_cache

_ISO = re.compile(
    r"(\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d):(\d\d)(\.\d{1,9})?(?:Z|([+-])(\d\d):?(\d\d))?",
    re.ASCII | re.IGNORECASE,
)


def unix_second(text: str) -> float | None:
    """Return the Unix second of a timestamp, None if it is none."""
    found = _ISO.fullmatch(text)
    if found is None:
        return None
    seconds = _whole_second(text[:19])
    if seconds is None:
        return None
    fraction, sign, hours, minutes = found.groups()[6:]
    whole = seconds + float(fraction or 0.0)
    if sign is None:
        return whole
    offset = 3600 * int(hours) + 60 * int(minutes)
    return whole - offset if sign == "+" else whole + offset


@lru_cache(maxsize=256)
def _whole_second(text: str) -> int | None:
    """Return the Unix second of `2026-01-02T03:04:05`: many vehicles have the same."""
    year, month, day = int(text[:4]), int(text[5:7]), int(text[8:10])
    hour, minute, second = int(text[11:13]), int(text[14:16]), int(text[17:19])
    is_date = year >= 1970 and 1 <= month <= 12 and 1 <= day <= 31
    if not (is_date and hour < 24 and minute < 60 and second <= 60):
        return None
    return calendar.timegm((year, month, day, hour, minute, second))

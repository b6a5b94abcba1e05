"""Timestamps of messages: ISO 8601 in UTC, with 0 to 3 decimals or more."""

import calendar
import re

_ISO = re.compile(
    r"(\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d):(\d\d)(\.\d{1,9})?(?:Z|([+-])(\d\d):?(\d\d))?",
    re.ASCII | re.IGNORECASE,
)


def unix_second(text: str) -> float | None:
    """Return the Unix second of a timestamp, None if it is none."""
    found = _ISO.fullmatch(text)
    if found is None:
        return None
    year, month, day, hour, minute, second = map(int, found.groups()[:6])
    if not (
        year >= 1970 and 1 <= month <= 12 and 1 <= day <= 31 and hour < 24 and minute < 60 and second <= 60
    ):
        return None
    seconds = calendar.timegm((year, month, day, hour, minute, second)) + float(found[7] or 0.0)
    if found[8] is None:
        return seconds
    offset = 3600 * int(found[9]) + 60 * int(found[10])
    return seconds - offset if found[8] == "+" else seconds + offset

"""The alarms of a robot that are over, from the records of one run of the console."""

from collections.abc import Iterable
from itertools import islice

from fleet_tui.model.audit_record import AuditRecord, PastAlarm
from fleet_tui.text.language import verbatim

LOOKED_AT = 20_000
"""Records that are read at most: of a long shift the newest."""
_TIME_OF_DAY = slice(11, 19)


def past_alarms(newest_first: Iterable[AuditRecord], run: str, robot: str, most: int) -> list[PastAlarm]:
    """Return the newest alarms of a robot that a run of the console saw begin and end."""
    found: list[PastAlarm] = []
    ends: dict[str, str] = {}
    for record in islice(newest_first, LOOKED_AT):
        if record.run != run:
            continue
        if record.kind == "console" and record.change == "opened":
            break
        if record.kind != "alarm" or record.robot != robot:
            continue
        if "returned" in record.change or "cleared" in record.change:
            ends[record.what] = record.time
        elif record.change.startswith("raised") and (end := ends.pop(record.what, "")):
            times = record.time[_TIME_OF_DAY], end[_TIME_OF_DAY]
            found.append(PastAlarm(record.what, verbatim(record.words), *times))
            if len(found) == most:
                break
    return found

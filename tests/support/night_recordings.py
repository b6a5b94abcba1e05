"""Recordings of a night: a keyframe, ticks and an alarm for each minute."""

from collections.abc import Iterator
from pathlib import Path

from fleet_tui.model.events import TimePassed
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.recording.records import EventRecord, Mark, Record
from tests.support.fleets import T0, WALL, fleet, reduced
from tests.support.recordings import header, keyframe, written

ENTRY = Origin("ana", "here:1", "r").record(WALL, kind="alarm", what="offline", change="raised")


def tick(at: float) -> EventRecord:
    return EventRecord(at, WALL + at - T0, TimePassed(at, WALL + at - T0))


def minutes(count: int, start: float = T0) -> Iterator[list[Record]]:
    """A keyframe, ticks and an alarm for each minute."""
    for n in range(count):
        at = start + 60.0 * n
        state = reduced(fleet(), TimePassed(at, WALL))
        yield [
            keyframe(at, state),
            *(tick(at + second) for second in range(60)),
            Mark(at + 59.5, WALL + at + 59.5 - T0, ENTRY),
        ]


def night(path: Path, count: int = 3, part: int = 0, start: float = T0) -> Path:
    first, *others = minutes(count, start)
    return written(path, [header(part=part, at=start), *first], *others)

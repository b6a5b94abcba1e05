"""Recordings for tests, and what two states have to have in common to be the same."""

import gzip
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import msgspec

from fleet_tui.config.schema import Config
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.records.recording.records import (
    VERSION,
    Keyframe,
    Packer,
    Record,
    RecordingHeader,
    encode,
    public,
)
from tests.support.fleets import T0, WALL, fleet
from tests.support.watched_store import config_of

PACKER = Packer()


def plain(value: Any) -> Any:
    """A value of which two are alike when all of it is alike: many have no `==` of their own."""
    if isinstance(value, OccupancyGrid):
        return (plain(value.frame), [(level.shape, level.tobytes()) for level in value.levels])
    if isinstance(value, msgspec.Struct):
        return (type(value).__name__, [plain(getattr(value, name)) for name in value.__struct_fields__])
    if isinstance(value, dict):
        return [(plain(key), plain(one)) for key, one in value.items()]
    if isinstance(value, list | tuple):
        return [plain(one) for one in value]
    if isinstance(value, frozenset):
        return sorted(value)
    return repr(value)


def header(
    config: Config | None = None, recording: str = "r", part: int = 0, at: float = T0
) -> RecordingHeader:
    config = config or config_of("ws://site:9090")
    return RecordingHeader(VERSION, "test", recording, part, at, WALL, False, public(config))


def keyframe(at: float = T0, state: FleetState | None = None) -> Keyframe:
    return Keyframe.of(at, WALL + at - T0, state or fleet(), PACKER)


def packed(*records: Record) -> bytes:
    """One gzip member."""
    return gzip.compress(b"".join(encode(record, PACKER) for record in records), mtime=0)


def written(path: Path, *members: Iterable[Record]) -> Path:
    path.write_bytes(b"".join(packed(*records) for records in members))
    return path


def detail(text: str) -> str:
    """A message in one line."""
    return re.sub(r"\s+", " ", text)

"""The recording that covers a moment, among those that a console has written."""

from collections.abc import Iterable
from pathlib import Path

from fleet_tui.records.recording.indexing import header_of
from fleet_tui.records.recording.recordings import RECENT, RECORDINGS
from fleet_tui.text.errors import FleetError

ENDS_LATE = 2.0
"""Seconds after the last writing of a file for which it still covers a moment."""


def recording_at(folder: Path, at: float, also: Iterable[Path] = ()) -> tuple[Path, float] | None:
    """Return the file in a state folder, or of those `also` known, that was being written at a Unix second,
    and when it begins; those that an operator started come before the last minutes. None if none was."""
    started = sorted((folder / RECORDINGS).glob("*.jsonl*"))
    recent = sorted((folder / RECENT).glob("*.jsonl*"))
    for path in (*also, *started, *recent):
        try:
            begun, ended = header_of(path).wall, path.stat().st_mtime
        except (FleetError, OSError):
            continue  # of another kind, or gone meanwhile
        if begun <= at <= ended + ENDS_LATE:
            return path, begun
    return None

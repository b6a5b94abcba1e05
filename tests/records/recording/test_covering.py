"""The recording of a moment, among others."""

import os
from pathlib import Path

import pytest

from fleet_tui.records.recording.covering import ENDS_LATE, recording_at
from fleet_tui.records.recording.indexing import header_of
from fleet_tui.records.recording.records import RecordingError
from tests.support.tapes import shift


def put(path: Path, tape: Path, lasts: float) -> Path:
    """Copy a recording that was written for so many seconds."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(tape.read_bytes())
    ended = header_of(path).wall + lasts
    os.utime(path, (ended, ended))
    return path


def test_the_file_that_was_being_written_then(tmp_path: Path) -> None:
    tape = tmp_path / "tape.jsonl.gz"
    shift(tape)
    begun = header_of(tape).wall
    (tmp_path / "recordings").mkdir()
    (tmp_path / "recordings" / "a.jsonl.gz").write_bytes(b"another file")
    recent = put(tmp_path / "recent" / "x-1-20240101-000000.jsonl.gz", tape, 100.0)
    assert recording_at(tmp_path, begun + 50) == (recent, begun)
    assert recording_at(tmp_path, begun - 1) is None
    assert recording_at(tmp_path, begun + 100 + ENDS_LATE + 1) is None
    started = put(tmp_path / "recordings" / "b.jsonl.gz", tape, 60.0)
    assert recording_at(tmp_path, begun + 50) == (started, begun)
    elsewhere = put(tmp_path / "elsewhere" / "c.jsonl.gz", tape, 60.0)
    assert recording_at(tmp_path, begun + 50, [elsewhere]) == (elsewhere, begun)


def test_without_any_there_is_none(tmp_path: Path) -> None:
    assert recording_at(tmp_path, 0.0, [tmp_path / "gone.jsonl"]) is None
    with pytest.raises(RecordingError):
        header_of(tmp_path)

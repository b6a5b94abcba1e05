"""The files of a running recording: a new one in time, old ones deleted, another one after an error."""

import gzip
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from types import SimpleNamespace

import pytest

from fleet_tui.records.recording import part_files
from fleet_tui.records.recording.part_files import PartFiles, PartLimits
from fleet_tui.records.recording.records import RecordingError


def head(part: int, _at: float) -> bytes:
    return b"head %d\n" % part


@pytest.fixture
def first(tmp_path: Path) -> Path:
    return tmp_path / "night.jsonl.gz"


@pytest.fixture
def hourly(first: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[PartFiles]:
    """A file for each hour from second 0."""
    monkeypatch.setattr(part_files, "time", SimpleNamespace(monotonic=lambda: 0.0))
    files = PartFiles(first, PartLimits(part_seconds=3600.0), head)
    with closing(files):
        yield files


def test_a_new_file_begins_when_one_is_full_or_old_else_a_new_member(hourly: PartFiles) -> None:
    assert not hourly.needs_turn(3599.0) and hourly.turn(3599.0)
    assert len(hourly.paths) == 1
    assert hourly.write(b"one\n") and hourly.needs_turn(3600.0) and hourly.turn(3600.0)
    assert [path.name for path in hourly.paths] == ["night.jsonl.gz", "night.0001.jsonl.gz"]
    assert gzip.decompress(hourly.paths[0].read_bytes()) == b"head 0\none\n"
    assert not hourly.needs_turn(7199.0) and hourly.needs_turn(7200.0)
    assert hourly.size == sum(path.stat().st_size for path in hourly.paths)


@pytest.mark.parametrize(
    "limits", [PartLimits(part_bytes=1, kept=2), PartLimits(part_bytes=1, total_bytes=70)]
)
def test_old_files_go_but_never_the_current_one(first: Path, limits: PartLimits) -> None:
    with closing(PartFiles(first, limits, head)) as files:
        for n in range(4):
            assert files.turn(float(n))
        assert [path.name for path in files.paths] == ["night.0003.jsonl.gz", "night.0004.jsonl.gz"]
        assert sorted(first.parent.iterdir()) == files.paths
    alone = PartFiles(first.with_name("other"), PartLimits(part_bytes=1, total_bytes=0), head)
    alone.turn(1.0)
    assert len(alone.paths) == 1 and alone.paths[0].exists()
    alone.close()


def test_after_an_error_another_file_is_tried_in_time(
    hourly: PartFiles, monkeypatch: pytest.MonkeyPatch
) -> None:
    hourly.paths[0].unlink()
    assert not hourly.flush()
    assert (hourly.problem, hourly.is_open) == ("file removed", False)
    assert not hourly.write(b"one\n") and not hourly.needs_turn(1.0)
    monkeypatch.setattr(part_files, "time", SimpleNamespace(monotonic=lambda: part_files.RETRY))
    assert hourly.needs_turn(1.0) and hourly.turn(1.0)
    assert (hourly.problem, hourly.is_open) == ("", True)
    assert hourly.write(b"two\n") and hourly.flush(whole=True)
    assert gzip.decompress(hourly.paths[-1].read_bytes()) == b"head 1\ntwo\n"


def test_a_foreign_file_with_the_next_name_is_passed_over(hourly: PartFiles) -> None:
    foreign = hourly.paths[0].with_name("night.0001.jsonl.gz")
    foreign.write_text("mine")
    assert not hourly.turn(3600.0) and "exists" in hourly.problem
    assert hourly.turn(3601.0) and hourly.paths[-1].name == "night.0002.jsonl.gz"
    assert foreign.read_text() == "mine"


def test_a_file_or_another_part_that_is_there_is_left_alone(first: Path) -> None:
    for name in ("night.jsonl.gz", "night.0003.jsonl.gz"):
        first.with_name(name).touch()
        with pytest.raises(RecordingError, match="exists"):
            PartFiles(first, PartLimits(), head)
        first.with_name(name).unlink()


def test_where_nothing_can_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    for place in ("file/x", "a\0b"):
        with pytest.raises(RecordingError, match="not writable"):
            PartFiles(tmp_path / place, PartLimits(), head)

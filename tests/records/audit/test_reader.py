"""Reading back: whatever lies in the files, only whole records come out, the newest first."""

import tempfile
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.records.audit import reader
from fleet_tui.records.audit.log import encode
from fleet_tui.records.audit.reader import AuditReader
from fleet_tui.storage.line_file import part
from tests.support.records import record

WHOLE = encode(record("r"))
FOREIGN = [
    b"{}",
    b"null",
    b"not json",
    b'{"version":1}',
    b"[" * 5000,
    b'{"version":"1"}',
    b"\xff\xfe\x00",
    WHOLE[:-1] + WHOLE[:-1],
]
pieces = st.lists(
    st.one_of(st.just(WHOLE[:-1]), st.sampled_from(FOREIGN), st.binary(max_size=40)), max_size=12
)


@pytest.fixture(autouse=True)
def small_blocks(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(reader, "BLOCK", 64)
    yield


@given(pieces, st.binary(max_size=300).filter(lambda tail: b"\n" not in tail))
def test_only_whole_lines_that_are_records_come_out(lines: list[bytes], tail: bytes) -> None:
    """As many as a plain reading of the lines finds, however they lie across blocks."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "audit.jsonl")
        path.write_bytes(b"".join(line + b"\n" for line in lines) + tail)
        whole = sum(line == WHOLE[:-1] for piece in lines for line in piece.split(b"\n"))
        reading = AuditReader(path)
        assert len(list(reading.newest_first())) == whole
        others = [line for piece in lines for line in piece.split(b"\n") if line != WHOLE[:-1]]
        assert reading.unreadable == sum(bool(line.strip()) for line in others) + bool(tail)


def test_half_a_line_is_no_record_even_if_it_looks_like_one(tmp_path: Path) -> None:
    path = tmp_path / "audit.jsonl"
    path.write_bytes(WHOLE + WHOLE[:-1])
    reading = AuditReader(path)
    assert len(list(reading.newest_first())) == 1 and reading.unreadable == 1


def test_the_newest_come_first_through_all_files_and_no_more_is_read_than_is_taken(tmp_path: Path) -> None:
    path = tmp_path / "audit.jsonl"
    for number in range(3):
        lines = (encode(record(f"{number} {n}")) for n in range(5))
        part(path, number).write_bytes(b"".join(lines))
    part(path, 2).write_bytes(b"rubbish\n" * 1000)
    reading = AuditReader(path)
    found = [one.words for one in islice(reading.newest_first(), 7)]
    assert found == [*(f"0 {n}" for n in (4, 3, 2, 1, 0)), "1 4", "1 3"]
    assert reading.unreadable == 0


def test_a_file_renamed_while_it_is_opened_is_read_once(tmp_path: Path) -> None:
    path = tmp_path / "audit.jsonl"
    path.write_bytes(WHOLE)
    part(path, 1).hardlink_to(path)
    assert len(list(AuditReader(path).newest_first())) == 1


def test_no_file_is_no_record(tmp_path: Path) -> None:
    assert list(AuditReader(tmp_path / "audit.jsonl").newest_first()) == []


def test_a_line_that_never_ends_is_not_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reader, "LONGEST", 500)
    path = tmp_path / "audit.jsonl"
    path.write_bytes(WHOLE + b"x" * 100_000 + b"\n" + WHOLE)
    reading = AuditReader(path)
    assert len(list(reading.newest_first())) == 2 and reading.unreadable == 1


def test_fields_of_a_later_version_do_not_hide_a_record(tmp_path: Path) -> None:
    path = tmp_path / "audit.jsonl"
    path.write_bytes(WHOLE.replace(b'"version":1', b'"version":2,"new":{"a":[1]}'))
    assert [one.version for one in AuditReader(path).newest_first()] == [2]

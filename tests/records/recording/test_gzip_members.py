"""Lines of gzip files, member by member: whole, cut off, damaged, endless, or no file at all."""

import gzip
import os
from pathlib import Path

import pytest

from fleet_tui.records.recording import gzip_members
from fleet_tui.records.recording.gzip_members import Lines, open_plain
from fleet_tui.records.recording.records import RecordingError


def lines(path: Path, content: bytes, begin: int = 0) -> tuple[list[tuple[int, bytes]], str]:
    """The lines of such a file from a member on, and the note on its end."""
    path.write_bytes(content)
    with open_plain(path) as file:
        file.seek(begin)
        found = Lines(file)
        return list(found), found.note


def test_each_line_has_the_offset_of_the_member_in_which_it_began(tmp_path: Path) -> None:
    first, second = gzip.compress(b"one\ntwo\nthr"), gzip.compress(b"ee\nfour\n")
    at = len(first)
    whole = [(0, b"one"), (0, b"two"), (0, b"three"), (at, b"four")]
    assert lines(tmp_path / "x", first + second) == (whole, "")
    assert lines(tmp_path / "x", first + second, at) == ([(at, b"ee"), (at, b"four")], "")


def test_an_irregular_end_is_noted_and_costs_no_more_than_itself(tmp_path: Path) -> None:
    packed = gzip.compress(os.urandom(99).hex().encode() + b"\nlast\n")
    for content, note in (
        (packed[:-4], "incomplete: truncated or still being written"),
        (packed + b"rubbish", f"damaged: unreadable data after byte {len(packed)} left out"),
        (packed + gzip.compress(b"half"), "last record incomplete"),
    ):
        found, said = lines(tmp_path / "x", content)
        assert len(found) == 2 and found[-1] == (0, b"last") and said == note


def test_a_line_without_an_end_is_given_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gzip_members, "LONGEST_LINE", 1000)
    monkeypatch.setattr(gzip_members, "UNPACKED", 100)
    with pytest.raises(RecordingError, match="line longer than 1,000 bytes"):
        lines(tmp_path / "x", gzip.compress(b"a" * 2000))


def test_what_is_no_file_is_refused_without_waiting_for_it(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for name, words in (
        ("gone", "no such file"),
        ("pipe", "not a file"),
        (".", "not a file"),
        ("a\0b", "null"),
    ):
        with pytest.raises(RecordingError, match=words):
            open_plain(tmp_path / name)

"""Opening recordings: in parts, cut off, damaged, hostile."""

import gzip
import itertools
import zlib
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from fleet_tui.records.recording import indexing
from fleet_tui.records.recording import recording as recording_module
from fleet_tui.records.recording.gzip_members import Lines
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.part_files import part_path
from fleet_tui.records.recording.records import EventRecord, Keyframe, Lost, Record, RecordingError, encode
from tests.support.fleets import T0, WALL
from tests.support.night_recordings import night, tick
from tests.support.recordings import PACKER, header, keyframe, packed, written


def test_what_is_in_it(tmp_path: Path) -> None:
    shares: list[float] = []
    recording = open_recording(night(tmp_path / "night.jsonl.gz"), shares.append)
    assert (recording.begin.at, recording.end.at) == (T0, T0 + 179.5)
    assert recording.begin.wall == WALL
    assert [moment.at for moment in recording.keyframes] == [T0, T0 + 60, T0 + 120]
    assert [mark.at for mark in recording.marks] == [T0 + 59.5, T0 + 119.5, T0 + 179.5]
    assert recording.config.rosbridge.url == "ws://site:9090"
    assert recording.note == ""
    assert shares == sorted(shares) and shares[-1] == 1.0


def test_parts_are_one_recording(tmp_path: Path) -> None:
    path = tmp_path / "night.jsonl.gz"
    for part in range(12):
        night(part_path(path, part), 1, part, T0 + 60 * part)
    written(part_path(path, 13), [header(recording="another"), keyframe()])
    (tmp_path / "night.0014.jsonl.gz").write_bytes(b"rubbish")
    (tmp_path / "other.jsonl.gz").write_bytes(b"rubbish")
    for opened in (path, part_path(path, 7)):
        recording = open_recording(opened)
        assert recording.parts == [part_path(path, part) for part in range(12)]
        assert "night.0014.jsonl.gz: is not a fleet-tui recording" in recording.note
        assert recording.end.at == T0 + 719.5
        assert [type(record) for record in recording.records()].count(Keyframe) == 12
    path.unlink()
    assert open_recording(path).begin.at == T0 + 60


def test_parts_in_one_file(tmp_path: Path) -> None:
    """`cat night.*` makes a recording, too."""
    parts = [night(tmp_path / str(part), 1, part, T0 + 60 * part).read_bytes() for part in range(3)]
    path = tmp_path / "all.gz"
    path.write_bytes(b"".join(parts))
    recording = open_recording(path)
    assert len(recording.keyframes) == 3
    assert sum(isinstance(record, EventRecord) for record in recording.records(T0 + 70)) == 120


def test_cut_off_anywhere_it_is_read_up_to_the_last_whole_record(tmp_path: Path) -> None:
    """As kill -9 leaves it: everything that was flushed, and a piece."""
    packer = zlib.compressobj(1, wbits=31)
    records: list[Record] = [header(), keyframe(), *map(tick, range(1000, 1040))]
    whole = b"".join(
        packer.compress(encode(record, PACKER)) + packer.flush(zlib.Z_SYNC_FLUSH) for record in records
    )
    path = tmp_path / "night.jsonl.gz"
    seen = set[int]()
    for length in range(0, len(whole), 7):
        path.write_bytes(whole[:length])
        try:
            recording = open_recording(path)
        except RecordingError:
            assert not seen
            continue
        ats = [record.at for record in recording.records()]
        assert ats[1:] == [1000.0 + n for n in range(len(ats) - 1)]
        assert "truncated" in recording.note
        seen.add(len(ats))
    assert max(seen) >= 38 and len(seen) > 30


def test_a_damaged_part_ends_early_and_the_next_one_goes_on(tmp_path: Path) -> None:
    path = tmp_path / "night.jsonl.gz"
    content = bytearray(night(path, 3).read_bytes())
    content[len(content) // 2] ^= 0xFF
    path.write_bytes(content)
    night(part_path(path, 1), 1, 1, T0 + 180)
    recording = open_recording(path)
    assert "night.jsonl.gz: damaged" in recording.note
    assert recording.keyframes[-1].at == T0 + 180
    ats = [record.at for record in recording.records()]
    assert ats[0] == T0 and ats[-1] == T0 + 239.5 and len(ats) < 4 * 62


def test_what_was_lost_is_known(tmp_path: Path) -> None:
    lost = Lost(T0 + 1, WALL + 1, 20, "the disk is full")
    recording = open_recording(written(tmp_path / "a", [header(), keyframe(), lost, keyframe(T0 + 9)]))
    assert recording.lost == [lost]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is not a fleet-tui recording"),
        (b"\x1f\x8b", "is not a fleet-tui recording: incomplete"),
        (b'{"kind":"header"}', "is not a fleet-tui recording: damaged"),
        (gzip.compress(b"hello\n"), "line is not a record"),
        (gzip.compress(b'{"kind":"lost","at":1,"wall":2}\n'), "wrong header"),
        (gzip.compress(b'{"kind":"header","version":99}\n'), "was written by a newer fleet-tui"),
        (gzip.compress(b'{"kind":"header","version":1}\n'), "unreadable record"),
        (packed(header()), "nothing to play"),
        (packed(header(), keyframe(), keyframe(T0 - 1))[:60], "is not a fleet-tui recording"),
        (gzip.compress(b"[" * 1_000_000), "is not a fleet-tui recording"),
    ],
    ids=itertools.count(),
)
def test_what_is_no_recording(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "x.gz"
    path.write_bytes(content)
    with pytest.raises(RecordingError) as caught:
        open_recording(path)
    assert words in str(caught.value) and str(path) in str(caught.value)


def test_a_config_that_is_none_is_refused(tmp_path: Path) -> None:
    config = msgspec.structs.replace(header().config, robots=[])
    hostile = msgspec.structs.replace(header(), config=config)
    with pytest.raises(RecordingError, match="contains an invalid configuration: robots: empty"):
        open_recording(written(tmp_path / "x", [hostile, keyframe()]))


@pytest.mark.parametrize(
    ("line", "most"), [(b" ", 5), (b"\n", 7), (b'{"kind":"told"}\n', 1_000_006)], ids=itertools.count()
)
def test_a_bomb_is_given_up_soon(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: bytes, most: int
) -> None:
    """Of a line without an end, and of lines that are nothing: some kB that stand for MBs. It is looked at
    for its header, scanned and played, and at most the scan makes all of its lines."""
    looks = list["Counted"]()

    class Counted(Lines):
        made = 0

        def __iter__(self) -> Iterator[tuple[int, bytes]]:
            looks.append(self)
            for one in super().__iter__():
                self.made += 1
                yield one

    for module in (indexing, recording_module):
        monkeypatch.setattr(module, "Lines", Counted)
    path = tmp_path / "x"
    path.write_bytes(packed(header(), keyframe()) + gzip.compress(line * 1_000_000, 1))
    recording = open_recording(path)
    assert recording.notes and len(list(recording.records())) == 1
    assert len(looks) == 3 and max(one.done for one in looks) <= path.stat().st_size
    assert sum(one.made for one in looks) <= most

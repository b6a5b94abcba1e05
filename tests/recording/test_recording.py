"""Reading recordings: from any instant, in parts, cut off, damaged, hostile."""

import gzip
import itertools
import os
import time
import zlib
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fleet_tui.audit.entries import Origin
from fleet_tui.errors import FleetError
from fleet_tui.model.events import LinkHeard, TimePassed
from fleet_tui.recording.indexing import open_recording
from fleet_tui.recording.parts import part_path, parts_beside
from fleet_tui.recording.records import (
    EventRecord,
    Keyframe,
    Lost,
    Mark,
    ReceivedFrame,
    Record,
    RecordingError,
    encode,
)
from tests.support.fleets import LINK, T0, WALL, fleet, told
from tests.support.recordings import PACKER, header, keyframe, packed, plain, written

ENTRY = Origin("ana", "here:1", "r").record(WALL, kind="alarm", what="offline", change="raised")


def tick(at: float) -> EventRecord:
    return EventRecord(at, WALL + at - T0, TimePassed(at, WALL + at - T0))


def minutes(count: int, start: float = T0) -> Iterator[list[Record]]:
    """A keyframe, ticks and an alarm for each minute."""
    for n in range(count):
        at = start + 60.0 * n
        state = told(fleet(), TimePassed(at, WALL))
        yield [
            keyframe(at, state),
            *(tick(at + second) for second in range(60)),
            Mark(at + 59.5, WALL + at + 59.5 - T0, ENTRY),
        ]


def night(path: Path, count: int = 3, part: int = 0, start: float = T0) -> Path:
    first, *others = minutes(count, start)
    return written(path, [header(part=part, at=start), *first], *others)


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


@pytest.mark.parametrize(
    ("at", "first"),
    [(-1e9, T0), (T0, T0), (T0 + 59.9, T0), (T0 + 60, T0 + 60), (T0 + 130, T0 + 120), (1e9, T0 + 120)],
)
def test_it_is_read_from_the_last_keyframe_before_an_instant(tmp_path: Path, at: float, first: float) -> None:
    recording = open_recording(night(tmp_path / "night.jsonl.gz"))
    records = list(recording.records(at))
    assert isinstance(records[0], Keyframe) and records[0].at == first
    assert plain(recording.state(records[0])) == plain(told(fleet(), TimePassed(first, WALL)))
    assert [record.at for record in records] == sorted(record.at for record in records)
    assert records[-1].at == recording.end.at


def test_several_keyframes_of_one_member(tmp_path: Path) -> None:
    """As after `zcat | gzip`."""
    path = night(tmp_path / "night.jsonl.gz")
    path.write_bytes(gzip.compress(gzip.decompress(path.read_bytes())))
    recording = open_recording(path)
    for n in range(3):
        first, second = itertools.islice(recording.records(T0 + 60 * n + 30), 2)
        assert isinstance(first, Keyframe) and first.at == second.at == T0 + 60 * n


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


@pytest.mark.parametrize(
    ("name", "part"),
    [
        ("night.jsonl.gz", "night.0001.jsonl.gz"),
        ("night.gz", "night.0001.gz"),
        ("night", "night.0001"),
        ("a.b.jsonl", "a.b.0001.jsonl"),
    ],
)
def test_the_names_of_parts(tmp_path: Path, name: str, part: str) -> None:
    assert part_path(tmp_path / name, 1).name == part
    for one in (name, part):
        (tmp_path / one).touch()
    assert [one.name for one in parts_beside(tmp_path / part)] == [name, part]


def test_cut_off_anywhere_it_is_read_up_to_the_last_whole_record(tmp_path: Path) -> None:
    """As kill -9 leaves it: everything that was flushed, and a piece."""
    packer = zlib.compressobj(1, wbits=31)
    records: list[Record] = [header(), keyframe(), *map(tick, range(1000, 1200))]
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
    assert max(seen) >= 198 and len(seen) > 150


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


def test_no_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for name, words in (("gone", "no such file"), ("pipe", "not a file"), (".", "not a file")):
        with pytest.raises(RecordingError, match=words):
            open_recording(tmp_path / name)


def test_a_config_that_is_none_is_refused(tmp_path: Path) -> None:
    config = msgspec.structs.replace(header().config, robots=[])
    hostile = msgspec.structs.replace(header(), config=config)
    with pytest.raises(RecordingError, match="contains an invalid configuration: robots: empty"):
        open_recording(written(tmp_path / "x", [hostile, keyframe()]))


@pytest.mark.parametrize("line", [b" ", b"\n", b'{"kind":"told"}\n'])
def test_a_bomb_is_given_up_soon(tmp_path: Path, line: bytes) -> None:
    """Some 100 kB that stand for 100 MB: of a line without an end, and of lines that are nothing."""
    bomb = gzip.compress(line * (100_000_000 // len(line)), 1)
    path = tmp_path / "x"
    path.write_bytes(packed(header(), keyframe()) + bomb)
    began = time.process_time()
    recording = open_recording(path)
    assert recording.notes and len(list(recording.records())) == 1
    assert time.process_time() - began < 10


@pytest.mark.parametrize(
    "record",
    [
        tick(T0 - 1),
        tick(1e300),
        EventRecord(T0, 1e300, TimePassed(T0, 1e300)),
        EventRecord(T0, WALL, LinkHeard("elsewhere", T0)),
        ReceivedFrame(T0, WALL, "elsewhere", "topics"),
    ],
)
def test_a_record_that_cannot_be_ends_the_part(tmp_path: Path, record: Record) -> None:
    path = written(tmp_path / "x", [header(), keyframe(), tick(T0), record])
    recording = open_recording(path)
    assert [one.at for one in recording.records()] == [T0, T0]
    assert recording.notes


def test_a_keyframe_that_does_not_fit_the_config(tmp_path: Path) -> None:
    path = written(tmp_path / "x", [header(), keyframe(state=fleet(2))])
    recording = open_recording(path)
    (record,) = recording.records()
    assert isinstance(record, Keyframe) and LINK in recording.config.bridges
    with pytest.raises(RecordingError, match="does not match"):
        recording.state(record)


WHOLE = packed(header(), *next(minutes(1))) + packed(*next(minutes(1, T0 + 60)))


@settings(deadline=1000)
@given(st.lists(st.tuples(st.integers(0, len(WHOLE) - 1), st.binary(max_size=4)), max_size=4))
def test_whatever_is_done_to_it_nothing_else_comes_of_it(
    tmp_path_factory: pytest.TempPathFactory, changes: list[tuple[int, bytes]]
) -> None:
    content = bytearray(WHOLE)
    for place, piece in changes:
        content[place : place + len(piece)] = piece
    _look_at(tmp_path_factory.mktemp("x") / "x", bytes(content))


@settings(deadline=1000)
@given(st.binary(max_size=2000), st.booleans())
def test_any_bytes_are_a_recording_or_an_error(
    tmp_path_factory: pytest.TempPathFactory, content: bytes, lines: bool
) -> None:
    """Also behind a header that is one."""
    lead = packed(header(), keyframe()) if lines else b""
    _look_at(tmp_path_factory.mktemp("x") / "x", lead + (gzip.compress(content) if lines else content))


def _look_at(path: Path, content: bytes) -> None:
    path.write_bytes(content)
    try:
        recording = open_recording(path)
        for record in recording.records():
            if isinstance(record, Keyframe):
                recording.state(record)
    except FleetError as problem:
        assert str(problem)

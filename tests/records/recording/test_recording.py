"""Reading recordings: from any instant, in parts, cut off, damaged, hostile."""

import gzip
import itertools
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fleet_tui.model.events import MessageArrived, TimePassed
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.records import EventRecord, Keyframe, ReceivedFrame, Record, RecordingError
from fleet_tui.text.errors import FleetError
from tests.support.fleets import LINK, T0, WALL, fleet, reduced
from tests.support.night_recordings import minutes, night, tick
from tests.support.recordings import header, keyframe, packed, plain, written


@pytest.mark.parametrize(
    ("at", "first"),
    [(-1e9, T0), (T0, T0), (T0 + 59.9, T0), (T0 + 60, T0 + 60), (T0 + 130, T0 + 120), (1e9, T0 + 120)],
)
def test_it_is_read_from_the_last_keyframe_before_an_instant(tmp_path: Path, at: float, first: float) -> None:
    recording = open_recording(night(tmp_path / "night.jsonl.gz"))
    records = list(recording.records(at))
    assert isinstance(records[0], Keyframe) and records[0].at == first
    assert plain(recording.state(records[0])) == plain(reduced(fleet(), TimePassed(first, WALL)))
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


@pytest.mark.parametrize(
    "record",
    [
        tick(T0 - 1),
        tick(1e300),
        EventRecord(T0, 1e300, TimePassed(T0, 1e300)),
        EventRecord(T0, WALL, MessageArrived("elsewhere", T0)),
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

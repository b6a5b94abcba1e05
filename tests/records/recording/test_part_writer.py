"""Events become records in the order of their times, and each one lost is counted."""

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from types import SimpleNamespace

import pytest

from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.model.events import MessageRejected, TimePassed
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.recording import part_files, part_writer
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.part_files import PartLimits
from fleet_tui.records.recording.part_writer import PartWriter
from fleet_tui.records.recording.records import (
    EventRecord,
    Keyframe,
    Lost,
    Mark,
    ReceivedFrame,
    Record,
    SentFrame,
)
from fleet_tui.text.language import verbatim
from tests.support.fleets import LINK, R0, T0, WALL, commanded, fleet, reduced
from tests.support.watched_store import config_of


@pytest.fixture
def writer(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[PartWriter]:
    """A writer that has written the first keyframe, at T0."""
    path = tmp_path / "night.jsonl.gz"
    config, origin = config_of("ws://site:9090"), Origin("ana", "here:1", "r")
    monkeypatch.setattr(part_files, "time", SimpleNamespace(monotonic=lambda: T0))
    with closing(PartWriter(path, config, origin, PartLimits())) as it:
        it.keyframe(T0, fleet())
        yield it


def records(writer: PartWriter) -> list[Record]:
    writer.flush(whole=True)
    first, *others = open_recording(writer.files.paths[0]).records()
    assert isinstance(first, Keyframe)
    return others


def test_frames_and_events_are_written_as_they_came(writer: PartWriter) -> None:
    writer.received(T0 + 1, LINK, "topics", b'{"op":1}', False)
    writer.received(T0 + 2, LINK, "topics", b"\xff\x00", True)
    writer.sent(T0 + 3, LINK, "commands", b"{}")
    writer.event(T0 + 4, TimePassed(T0 + 4, WALL))
    one, other, sent, told_ = records(writer)
    assert isinstance(one, ReceivedFrame) and (one.text, one.payload, one.binary) == (
        '{"op":1}',
        b'{"op":1}',
        False,
    )
    assert isinstance(other, ReceivedFrame) and (other.text, other.payload, other.binary) == (
        "",
        b"\xff\x00",
        True,
    )
    assert isinstance(sent, SentFrame) and isinstance(told_, EventRecord)
    assert [record.at for record in (one, other, sent, told_)] == [T0 + n for n in (1, 2, 3, 4)]
    assert writer.records == 5


def test_a_frame_that_was_read_late_says_when_it_came(writer: PartWriter) -> None:
    writer.event(T0 + 5, TimePassed(T0 + 5, WALL))
    writer.received(T0 + 4, LINK, "topics", b"{}", False)
    before, late = records(writer)
    assert isinstance(late, ReceivedFrame) and late.came == T0 + 4 and late.at == before.at == T0 + 5


def test_a_command_is_marked_at_each_step(writer: PartWriter) -> None:
    before = fleet()
    writer.changed(T0, before, reduced(before, *commanded(1, PauseRobot(R0), Stage.SENT)))
    marks = records(writer)
    assert [mark.record.change for mark in marks if isinstance(mark, Mark)] == ["checked", "sent"]


def test_what_cannot_be_written_costs_no_more_than_itself(writer: PartWriter) -> None:
    for n, text in enumerate(("good", "half \ud800 a pair", "good")):
        writer.event(T0 + n, MessageRejected(R0, verbatim(text)))
    writer.keyframe(T0 + 9, fleet())
    one, other, _, lost = records(writer)
    assert isinstance(one, EventRecord) and isinstance(other, EventRecord) and isinstance(lost, Lost)
    assert lost.records == 1 and "surrogate" in lost.why


def test_a_record_that_no_reader_would_take_is_left_out(
    writer: PartWriter, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(part_writer, "LONGEST_LINE", 600)
    writer.sent(T0 + 1, LINK, "topics", b"a" * 700)
    writer.sent(T0 + 1, LINK, "topics", b"b")
    writer.flush()
    monkeypatch.undo()
    writer.missed(T0 + 2, 3, "too fast")
    kept, lost = records(writer)
    assert isinstance(kept, SentFrame) and kept.text == "b"
    assert isinstance(lost, Lost) and (lost.records, lost.why) == (4, "too fast")


def test_while_no_file_can_be_written_each_record_is_lost_and_a_keyframe_is_wanted(
    writer: PartWriter, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fleet_tui.records.recording.part_files.RETRY", 0.0)
    writer.flush()
    path = writer.files.paths[0]
    path.unlink()
    writer.event(T0 + 1, TimePassed(T0 + 1, WALL))
    writer.flush()
    writer.event(T0 + 2, TimePassed(T0 + 2, WALL))
    writer.flush()
    assert writer.wants_keyframe and not writer.files.is_open
    writer.keyframe(T0 + 3, fleet())
    assert not writer.wants_keyframe
    writer.flush(whole=True)
    (lost,) = open_recording(path).lost
    assert (lost.records, lost.why) == (2, "file removed")

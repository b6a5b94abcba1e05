"""Recordings: the same picture at every instant, whatever the disk does meanwhile."""

import json
import os
import stat
import subprocess
import time
from collections.abc import Callable, Iterator
from functools import reduce
from pathlib import Path

import pytest

from fleet_tui.config.fleet import adapters_of, feeds_of, limit_of
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.maps.map_process import decode_apart
from fleet_tui.model import events
from fleet_tui.model.commands import PauseRobot
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.recording import part_files, recorder
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.part_files import PartLimits
from fleet_tui.records.recording.recorder import Recorder
from fleet_tui.records.recording.records import EventRecord, Keyframe, Mark, ReceivedFrame, SentFrame
from fleet_tui.records.recording.taps import Taps
from fleet_tui.robots.ros.reading import FrameReader
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.state.reducer import apply
from fleet_tui.state.store import Store
from fleet_tui.text.language import Message
from tests.support.fleets import T0, WALL, fleet
from tests.support.links import finished, ready
from tests.support.polling import HANGS
from tests.support.recordings import plain
from tests.support.watched_store import WatchedStore, config_of

ORIGIN = Origin("ana", "here:1", "r")
CONFIG = config_of("ws://site:9090")


@pytest.fixture
def store() -> Store:
    return Store(fleet())


@pytest.fixture
def recording(tmp_path: Path, store: Store) -> Iterator[Recorder]:
    recording = Recorder(tmp_path / "night.jsonl.gz", CONFIG, store, ORIGIN)
    yield recording
    recording.close()


def tell(recorder: Recorder, store: Store, event: events.Event) -> None:
    """As the link does."""
    recorder.on_event(event)
    store.apply(event)


def ticks(recorder: Recorder, store: Store, count: int, begin: float = T0) -> None:
    for n in range(count):
        tell(recorder, store, events.TimePassed(begin + n / 100, WALL))


def wait(holds: Callable[[], object], within: float = HANGS) -> None:
    until = time.monotonic() + within
    while not holds():
        assert time.monotonic() < until, "never"
        time.sleep(0.01)


def played(path: Path, config: Config) -> Iterator[tuple[object, FleetState]]:
    """Each record with the state after it, as a replay makes it."""
    read = open_recording(path)
    adapters = adapters_of(config)
    readings = {
        link: FrameReader(
            link, limit_of(config, link), adapters, feeds_of(config, adapters, link), decode_apart
        )
        for link in config.bridges
    }
    state = fleet()
    for record in read.records():
        match record:
            case Keyframe():
                state = read.state(record)
            case EventRecord(event=event):
                state = apply(state, event)
            case ReceivedFrame(channel="topics"):
                at = record.at if record.came is None else record.came
                brought = readings[record.link].read(record.payload, record.binary, at)
                state = reduce(apply, brought, state) if isinstance(brought, tuple) else state
        yield record, state


class Everything(WatchedStore):
    """Remembers every state."""

    def __init__(self, state: FleetState) -> None:
        super().__init__(state)
        self.states = [state]

    def apply(self, event: events.Event) -> None:
        super().apply(event)
        self.states.append(self.state)


async def test_a_replay_is_at_every_instant_what_the_run_was(server: RosbridgeServer, tmp_path: Path) -> None:
    """Begun in the middle of a run, with commands, alarms and live maps, over keyframes and parts."""
    config, path = config_of(server.url, 2, 2), tmp_path / "x.jsonl.gz"
    store, taps = Everything(initial_state(config, time.monotonic())), Taps()
    link = FleetLink(config, store, taps)
    link.open()
    await store.until(ready)
    running = taps.attach(Recorder(path, config, store, ORIGIN, PartLimits(part_seconds=1.5)))
    await store.until(lambda _: running.records > 5)
    link.show_map("robot_0", "floor_0")
    await store.until(lambda state: state.robots["robot_0"].maps["floor_0"].grid)
    await finished(link, store, PauseRobot("robot_0"))
    link.post(events.FloorMapLoaded("floor_1", None, Message("no such file")))
    server.bridge.publish_raw("/robot_0/battery", {"data": 5.0})
    await store.until(lambda state: state.alarms and len(running.paths) > 1)
    later = time.monotonic() + 1.0
    await store.until(lambda state: state.now > later)
    taps.detach(running)
    link.close()
    records = list(played(path, config))
    assert {type(record) for record, _ in records} == {Keyframe, ReceivedFrame, SentFrame, EventRecord, Mark}
    begin = plain(records[0][1])
    at = next(n for n, state in enumerate(store.states) if plain(state) == begin)
    for record, state in records:
        at += isinstance(record, EventRecord) or (
            isinstance(record, ReceivedFrame) and plain(state) != plain(store.states[at])
        )
        assert plain(state) == plain(store.states[at]), record
    assert at > 100 and open_recording(path).marks


def test_only_the_owner_reads_it(recording: Recorder) -> None:
    assert stat.S_IMODE(recording.path.stat().st_mode) == 0o600


def test_it_can_be_read_while_it_is_written(recording: Recorder, store: Store) -> None:
    ticks(recording, store, 5)
    recording.on_received("rosbridge", "topics", b"\xff", True, time.monotonic())
    assert recording.flush()
    read = open_recording(recording.path)
    assert [type(record) for record in read.records()] == [Keyframe, *[EventRecord] * 5, ReceivedFrame]
    assert read.note == ""  # and is whole when somebody asks for it
    ticks(recording, store, 3)
    wait(lambda: len(list(open_recording(recording.path).records())) == 10)
    assert "still being written" in open_recording(recording.path).note
    recording.close()
    assert open_recording(recording.path).note == ""


def test_any_program_can_read_it(recording: Recorder, store: Store) -> None:
    ticks(recording, store, 2)
    recording.close()
    lines = subprocess.run(["zcat", recording.path], check=True, capture_output=True).stdout.splitlines()
    assert [json.loads(line)["kind"] for line in lines] == ["header", "keyframe", "told", "told"]


def test_old_parts_go_and_each_begins_with_all_that_is_known(tmp_path: Path, store: Store) -> None:
    path = tmp_path / "ring.jsonl.gz"
    recording = Recorder(path, CONFIG, store, ORIGIN, PartLimits(part_bytes=1, kept=3))
    for n in range(8):
        ticks(recording, store, 1, T0 + n / 10)
        assert recording.flush()
        wait(lambda: recording.writer.wants_keyframe)
    recording.close()
    assert len(recording.paths) == 3 and sorted(tmp_path.iterdir()) == recording.paths
    first = recording.paths[0]
    assert open_recording(path).parts == recording.paths
    first.rename(tmp_path / "alone.gz")
    (begin, *_) = open_recording(tmp_path / "alone.gz").records()
    assert isinstance(begin, Keyframe) and begin.fleet_state().now > T0


def test_what_comes_too_fast_is_counted_and_the_picture_is_right_again(
    recording: Recorder, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    ticks(recording, store, 1)
    assert recording.flush()
    monkeypatch.setattr(recorder, "MOST_WAITING", 0)
    recording.on_sent("rosbridge", "topics", b"1")
    for _ in range(3):
        recording.on_sent("rosbridge", "topics", b"2")
    assert recording.problem == "data rate too high"
    tell(recording, store, events.TimePassed(T0 + 0.5, WALL))
    monkeypatch.undo()
    wait(lambda: recording.flush())
    ticks(recording, store, 1, T0 + 0.6)
    assert recording.problem == ""
    recording.close()
    read = open_recording(recording.path)
    (lost,) = read.lost
    assert lost.records == 4 and "faster" in lost.why
    after = next(record for record in read.records(lost.at) if isinstance(record, Keyframe))
    assert read.state(after).now == T0 + 0.5


def test_the_disk_is_full_for_a_while(
    recording: Recorder, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    ticks(recording, store, 3)
    assert recording.flush()
    write = os.write
    with monkeypatch.context() as full:
        full.setattr(part_files, "RETRY", 0.0)

        room = iter([1])

        def refuse(fd: int, content: bytes) -> int:
            for size in room:
                return write(fd, content[:size])
            raise OSError(28, "No space left on device")

        full.setattr("fleet_tui.records.recording.part_file.os.write", refuse)
        ticks(recording, store, 3, T0 + 0.1)
        recording.flush()
        assert recording.problem == "No space left on device"
        ticks(recording, store, 3, T0 + 0.2)
        recording.flush()
        assert len(recording.paths) == 1
    wait(lambda: recording.flush() and recording.writer.wants_keyframe)
    ticks(recording, store, 3, T0 + 0.3)
    assert recording.flush() and recording.problem == ""
    recording.close()
    read = open_recording(recording.path)
    assert len(read.parts) == 2 and "truncated" in read.note
    (lost,) = read.lost
    assert lost.records >= 6 and lost.why == "No space left on device"
    assert read.state([one for one in read.records() if isinstance(one, Keyframe)][-1]).now == T0 + 0.22


def test_the_folder_is_taken_away(tmp_path: Path, store: Store) -> None:
    recording = Recorder(tmp_path / "in" / "x.gz", CONFIG, store, ORIGIN)
    ticks(recording, store, 3)
    assert recording.flush()
    recording.path.unlink()
    recording.path.parent.rmdir()
    recording.flush()
    assert recording.problem == "file removed"
    wait(lambda: recording.flush() and recording.writer.wants_keyframe)
    ticks(recording, store, 3)
    assert recording.flush() and recording.problem == ""
    recording.close()
    assert open_recording(recording.path).keyframes


def test_nothing_is_taken_after_the_end(recording: Recorder, store: Store) -> None:
    ticks(recording, store, 1)
    recording.close()
    ticks(recording, store, 1)
    assert len(list(open_recording(recording.path).records())) == 2

"""The last minutes that a console always keeps, and the recordings that are asked for."""

import itertools
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from fleet_tui.config.schema import RecordingConfig
from fleet_tui.config.start import extended, initial_state
from fleet_tui.model import events
from fleet_tui.records.recording import recordings as module
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.recordings import Recordings, remove_stale
from fleet_tui.records.recording.records import Keyframe, RecordingError
from fleet_tui.state.store import Store
from tests.support.fleets import T0, WALL, fleet
from tests.support.watched_store import config_of

CONFIG = config_of("ws://site:9090")


@pytest.fixture
def store() -> Store:
    return Store(fleet())


@pytest.fixture
def kept(tmp_path: Path, store: Store) -> Iterator[Recordings]:
    kept = Recordings(CONFIG, store, tmp_path)
    yield kept
    kept.close()


def tick(kept: Recordings, store: Store, at: float = T0) -> None:
    event = events.TimePassed(at, WALL)
    kept.taps.on_event(event)
    store.apply(event)


def test_the_last_minutes_are_at_hand_while_they_are_written(
    kept: Recordings, store: Store, tmp_path: Path
) -> None:
    assert kept.recent() == []
    kept.keep_recent()
    tick(kept, store)
    (path,) = kept.recent()
    assert path.parent == tmp_path / "recent" and path.stat().st_mode & 0o777 == 0o600
    assert path.parent.stat().st_mode & 0o777 == 0o700
    assert len(list(open_recording(path).records())) == 2
    assert kept.notes() == []


def test_only_the_last_minutes_stay(tmp_path: Path, store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("fleet_tui.records.recording.recorder.KEYFRAME_EVERY", 0.0)
    monkeypatch.setattr(module, "RECENT_PART", 1e-6)
    config = msgspec.structs.replace(CONFIG, recording=RecordingConfig(recent_minutes=1e-6 / 60 * 2))
    kept = Recordings(config, store, tmp_path)
    kept.keep_recent()
    first = kept.recent()
    for n in range(8):
        tick(kept, store, T0 + n / 100)
    paths = kept.recent()
    assert len(paths) == 3 and not first[0].exists()
    joined = tmp_path / "joined.gz"
    joined.write_bytes(b"".join(path.read_bytes() for path in paths))
    assert len(open_recording(joined).keyframes) == 3
    kept.close()


def test_the_bytes_of_the_last_minutes_are_bounded(tmp_path: Path, store: Store) -> None:
    config = msgspec.structs.replace(CONFIG, recording=RecordingConfig(recent_mb=1.0))
    kept = Recordings(config, store, tmp_path)
    kept.keep_recent()
    for n in range(60):
        kept.taps.on_received("rosbridge", "topics", os.urandom(100_000), True, 0.0)
        kept.recent()
        tick(kept, store, T0 + n / 100)
    paths = kept.recent()
    total = sum(path.stat().st_size for path in paths)
    kept.close()
    assert 500_000 < total < 1_250_000 and len(paths) >= 5
    assert sorted((tmp_path / "recent").iterdir()) == paths


def test_none_are_kept_where_none_are_wanted(tmp_path: Path, store: Store) -> None:
    config = msgspec.structs.replace(CONFIG, recording=RecordingConfig(recent_minutes=0))
    kept = Recordings(config, store, tmp_path)
    kept.keep_recent()
    assert kept.recent() == [] and not (tmp_path / "recent").exists()


def test_where_they_cannot_be_kept_that_is_said(tmp_path: Path, store: Store) -> None:
    (tmp_path / "recent").touch()
    kept = Recordings(CONFIG, store, tmp_path)
    kept.keep_recent()
    (note,) = kept.notes()
    assert note.startswith("last minutes not kept: ") and "not writable" in note
    tick(kept, store)
    kept.close()


def test_what_ended_processes_left_goes_but_for_the_last(kept: Recordings, tmp_path: Path) -> None:
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    kept.keep_recent()
    host = kept.recent()[0].name.partition("-")[0]
    kept.close()
    folder = tmp_path / "left"
    folder.mkdir()
    running = os.getppid()
    names = {
        f"{host}-{gone.pid}-20240531-120000.jsonl.gz": False,
        f"{host}-{gone.pid}-20240531-120000.0001.jsonl.gz": False,
        f"{host}-{gone.pid}-20240601-120000.jsonl.gz": True,
        f"{host}-{gone.pid}-20240601-120000.0001.jsonl.gz": True,
        f"{host}-{os.getpid()}-20240501-120000.jsonl.gz": False,
        f"{host}-{running}-20240501-120000.jsonl.gz": True,
        f"elsewhere-{gone.pid}-20240501-120000.jsonl.gz": True,
        "mine.txt": True,
    }
    for name in names:
        (folder / name).touch()
    remove_stale(folder)
    assert {path.name for path in folder.iterdir()} == {name for name, stays in names.items() if stays}
    remove_stale(tmp_path / "nowhere")


def test_a_recording_is_begun_and_ended(kept: Recordings, store: Store, tmp_path: Path) -> None:
    assert kept.stop() == "no recording running"
    path = kept.start()
    assert path.parent == tmp_path / "recordings"
    assert kept.notes() == ["rec 0 s"] and kept.recorder is not None
    tick(kept, store)
    said = kept.stop()
    assert said.startswith("recorded 0 s, 0.0 MB: ") and said.endswith(str(path))
    assert kept.notes() == [] and open_recording(path).note == ""


def test_a_recording_that_is_not_written_is_not_called_one(
    kept: Recordings, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = kept.start()
    tick(kept, store)
    path.unlink()
    recorder = kept.recorder
    assert recorder is not None and recorder.flush()
    assert kept.notes() == ["rec: not written: file removed"]
    with pytest.raises(RecordingError):
        monkeypatch.setattr(module, "_now", lambda: "no/where\0")
        kept.start()
    assert kept.recorder is recorder
    assert "incomplete: file removed" in kept.stop()


def test_a_demo_does_not_push_out_what_a_site_left(tmp_path: Path) -> None:
    demo = Recordings(CONFIG, Store(fleet()), tmp_path, demo=True)
    demo.keep_recent()
    (path,) = demo.recent()
    demo.close()
    assert path.parent == tmp_path / "recent" / "demo"
    assert module.recent_runs(tmp_path) == {}


def test_each_recording_has_the_robots_of_its_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    seconds = itertools.count()
    monkeypatch.setattr(module, "_now", lambda: f"20260102-0304{next(seconds):02}")
    before, after = config_of("ws://site:9090", 1), config_of("ws://site:9090", 2)
    store = Store(initial_state(before, T0))
    kept = Recordings(before, store, tmp_path)
    kept.keep_recent()
    first = [kept.start(), *kept.recent()]
    tick(kept, store)
    kept.extend(after, lambda: store.put(extended(store.state, after)))
    tick(kept, store, T0 + 1)
    assert kept.recorder is not None
    second = [kept.recorder.path, *kept.recent()]
    kept.close()
    for paths, robots in ((first, 1), (second, 2)):
        for path in paths:
            recording = open_recording(path)
            (keyframe,) = [one for one in recording.records() if isinstance(one, Keyframe)]
            assert len(recording.state(keyframe).robots) == robots

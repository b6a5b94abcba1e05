"""Taps of several recorders on one link."""

from pathlib import Path

import pytest

from fleet_tui.model import events
from fleet_tui.records.audit.entries import Origin
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.recorder import Recorder
from fleet_tui.records.recording.records import EventRecord, Keyframe
from fleet_tui.records.recording.taps import Taps
from fleet_tui.state.store import Store
from tests.support.fleets import T0, WALL, fleet
from tests.support.watched_store import config_of

ORIGIN = Origin("ana", "here:1", "r")
CONFIG = config_of("ws://site:9090")


@pytest.fixture
def store() -> Store:
    return Store(fleet())


def test_several_record_at_once_and_end_by_themselves(tmp_path: Path, store: Store) -> None:
    taps = Taps()
    one = taps.attach(Recorder(tmp_path / "one.gz", CONFIG, store, ORIGIN))
    taps.on_event(events.TimePassed(T0, WALL))
    other = taps.attach(Recorder(tmp_path / "other.gz", CONFIG, store, ORIGIN))
    taps.on_event(events.TimePassed(T0 + 1, WALL))
    taps.detach(one)
    taps.on_event(events.TimePassed(T0 + 2, WALL))
    taps.detach(other)
    assert store.watchers == []
    for path, count in ((one.path, 2), (other.path, 2)):
        assert [type(record) for record in open_recording(path).records()] == [
            Keyframe,
            *[EventRecord] * count,
        ]

"""A store that keeps its state at each tick."""

import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from fleet_tui.cli.session import opened
from fleet_tui.config.schema import Config
from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.links.queue_file import QueueFile
from fleet_tui.model.events import Event, TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.play.cursor import RecordingCursor
from fleet_tui.records.recording.recorder import Recorder
from fleet_tui.records.recording.recording import Recording
from fleet_tui.records.recording.records import EventRecord
from tests.support.recordings import plain
from tests.support.tapes import ORIGIN
from tests.support.watched_store import WatchedStore


class Ticking(WatchedStore):
    """Keeps the state after every tick, by its time."""

    def __init__(self, state: FleetState) -> None:
        super().__init__(state)
        self.ticks: dict[float, FleetState] = {}

    def apply(self, event: Event) -> None:
        super().apply(event)
        if isinstance(event, TimePassed):
            self.ticks[event.at] = self.state


@contextmanager
def taped(config: Config, folder: Path) -> Iterator[tuple[FleetLink, Ticking]]:
    """A live link that is recorded; afterwards its replay is compared with it at each instant."""
    store = Ticking(initial_state(config, time.monotonic()))
    tap = Recorder(folder / "run.jsonl.gz", config, store, ORIGIN)
    try:
        with opened(FleetLink(config, store, tap, QueueFile(None, "ana")), config) as link:
            yield link, store
    finally:
        tap.close()
    _replays(open_recording(tap.path), store.ticks)


def _replays(recording: Recording, ticks: Mapping[float, FleetState]) -> None:
    assert not recording.note
    head, was = RecordingCursor(recording), dict[float, object]()
    while (record := head.take()) is not None:
        if isinstance(record, EventRecord) and isinstance(record.event, TimePassed):
            was[head.at] = state = plain(ticks[record.event.at])
            assert plain(head.state) == state
        elif head.at in was:
            was[head.at] = plain(head.state)  # on a busy machine more is recorded in that very instant
    assert len(was) > 20 and len(recording.keyframes) > 3
    instants = list(was.items())
    for at, state in [*instants[::-3], *instants[::5]]:
        head.seek(at)
        assert plain(head.state) == state

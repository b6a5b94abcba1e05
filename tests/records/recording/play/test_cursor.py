"""Replay of a recording gives the same state at every instant as the live run did."""

import time
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.maps.images import load_floor_map
from fleet_tui.model.commands import PauseRobot, ResumeRobot
from fleet_tui.model.desk.events import AlarmAcknowledged, AlarmShelved
from fleet_tui.model.events import FloorGraphLoaded, TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.link import Phase
from fleet_tui.records.recording import recorder
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.play.cursor import RecordingCursor
from fleet_tui.records.recording.recorder import Recorder
from fleet_tui.records.recording.recording import Recording
from fleet_tui.records.recording.records import EventRecord
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.fleets import T0, WALL, place_order, pose
from tests.support.links import finished, phase, ready
from tests.support.recordings import plain
from tests.support.tapes import ORIGIN, MadeUp, shift
from tests.support.ticking import Ticking
from tests.support.watched_store import WatchedStore, config_of


async def eventful(link: FleetLink, store: WatchedStore, server: RosbridgeServer, image: Path) -> None:
    """Orders, pauses, maps, alarms and what an operator does about them, a cut link, another bridge."""
    await store.until(ready)
    link.show_map("robot_0", "floor_0")
    link.post(load_floor_map("floor_1", image, added=False))
    link.post(FloorGraphLoaded("floor_1", RouteGraph(), {"1": "Base"}, "a fault"))
    graph = store.state.robots["robot_0"].maps["floor_0"].graph
    assert graph is not None
    start, end, *_ = graph.vertices
    link.submit(place_order("robot_0", start, end))
    await finished(link, store, PauseRobot("robot_1"))
    await store.until(lambda state: state.robots["robot_0"].maps["floor_0"].grid)
    await server.drop_clients()
    await store.until(phase(Phase.WAITING))
    await store.until(phase(Phase.UP))
    await finished(link, store, ResumeRobot("robot_1"))
    port = int(server.url.rpartition(":")[2])
    await server.stop()
    state = await store.until(lambda state: state.alarms)
    link.post(AlarmAcknowledged(*state.alarms[0].key))
    link.post(AlarmShelved(*state.alarms[0].key, state.now + 1.0))
    await finished(link, store, PauseRobot("robot_0"))
    other = RosbridgeServer(OhFleet(robots=2, floors=2, seed=2), port=port)
    await other.start()
    await store.until(phase(Phase.UP))
    received = store.state.now
    await store.until(lambda state: (state.robots["robot_1"].last_received or 0.0) > received)
    await other.stop()


async def lived(folder: Path, server: RosbridgeServer) -> tuple[Recording, dict[float, FleetState]]:
    """A live run: its recording, and its state after every tick."""
    image = folder / "hall.pgm"
    image.write_bytes(b"P5 3 2 255 " + bytes([0, 128, 254, 254, 254, 0]))
    config = config_of(server.url, 2, 2)
    store = Ticking(initial_state(config, time.monotonic()))
    tap = Recorder(folder / "run.jsonl.gz", config, store, ORIGIN)
    link = FleetLink(config, store, tap)
    link.open()
    try:
        await eventful(link, store, server, image)
    finally:
        link.close()
        tap.close()
    return open_recording(tap.path), store.ticks


@pytest.fixture(autouse=True)
def often(monkeypatch: pytest.MonkeyPatch) -> None:
    """A keyframe every second, so that there are some to go to."""
    monkeypatch.setattr(recorder, "KEYFRAME_EVERY", 1.0)


async def test_every_instant_is_as_it_was(tmp_path: Path, server: RosbridgeServer) -> None:
    recording, ticks = await lived(tmp_path, server)
    assert not recording.note
    head, was = RecordingCursor(recording), list[tuple[float, object]]()
    later = dict[float, object]()
    while (record := head.take()) is not None:
        if isinstance(record, EventRecord) and isinstance(record.event, TimePassed):
            state = plain(ticks[record.event.at])
            assert plain(head.state) == state
            was.append((head.at, state))
        elif was and head.at == was[-1][0]:
            later[head.at] = plain(head.state)  # on a busy machine more is recorded in that very instant
    assert len(was) > 30 and len(recording.keyframes) > 3
    head.seek(was[-1][0])  # records of a later instant may stand after the last tick
    for at, state in was[-2:-14:-1]:
        head.step_tick(-1)
        assert (head.at, plain(head.state)) == (at, later.get(at, state))

    @given(st.lists(st.sampled_from(was), min_size=1, max_size=4))
    def anywhere(places: list[tuple[float, object]]) -> None:
        for at, state in places:
            head.seek(at)
            assert plain(head.state) == later.get(at, state)

    anywhere()


@pytest.mark.nightly
async def test_a_record_back_is_as_it_was_before_it(tmp_path: Path) -> None:
    head = RecordingCursor(shift(tmp_path / "night.jsonl.gz"))
    seen = [(head.at, plain(head.state))]
    while head.take() is not None:
        seen.append((head.at, plain(head.state)))
    for was in seen[-2::-1]:
        head.step_record(-1)
        assert (head.at, plain(head.state)) == was
    head.step_record(-1)
    assert (head.at, plain(head.state)) == seen[0]


def test_a_tick_back_passes_a_keyframe_between_two_ticks(tmp_path: Path) -> None:
    made = MadeUp(config_of("ws://site:9090"), keyframe_every=1.0)
    for second in (0.0, 0.6, 1.2, 1.8):
        made.tell(second, TimePassed(T0 + second, WALL + second))
        made.tell(second + 0.5, pose(T0 + second + 0.5))
    head = RecordingCursor(made.written(tmp_path / "run.jsonl.gz"))
    head.seek(T0 + 1.8)
    places = list[float]()
    for _ in range(4):
        head.step_tick(-1)
        places.append(round(head.at - T0, 1))
    assert places == [1.2, 0.6, 0.0, 0.0]

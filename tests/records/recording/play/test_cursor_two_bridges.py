"""Two bridges, and a map that is decoded beside the loop: replay gives the states that the run had."""

import time
from pathlib import Path

import numpy as np
import pytest
from msgspec.structs import replace

from fleet_tui.config.schema import Link
from fleet_tui.config.start import initial_state
from fleet_tui.links.fleet_link import FleetLink
from fleet_tui.model.events import TimePassed
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.recording.indexing import open_recording
from fleet_tui.records.recording.play.cursor import RecordingCursor
from fleet_tui.records.recording.recorder import Recorder
from fleet_tui.records.recording.records import EventRecord, ReceivedFrame
from fleet_tui.simulator.frames import OutgoingFrame, Payload
from fleet_tui.simulator.oh_ressources.fleet import OhFleet
from fleet_tui.simulator.server import RosbridgeServer
from tests.support.recordings import plain
from tests.support.tapes import ORIGIN
from tests.support.ticking import Ticking
from tests.support.watched_store import config_of

SIDE = 3000
"""Large enough for a process of its own."""
TOPIC = "/robot_0/floor_0/map"


def large_map() -> OutgoingFrame:
    position, turned = {"x": 0.0, "y": 0.0, "z": 0.0}, {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
    origin = {"position": position, "orientation": turned}
    info = {"resolution": 0.05, "width": SIDE, "height": SIDE, "origin": origin}
    cells = np.random.default_rng(1).integers(0, 101, SIDE * SIDE).astype(np.int8)
    return OutgoingFrame(TOPIC, Payload({"header": {"frame_id": "floor_0"}, "info": info, "data": cells}))


def _width(state: FleetState) -> int:
    grid = state.robots["robot_0"].maps["floor_0"].grid
    return grid.frame.width if grid else 0


@pytest.mark.nightly
async def test_two_bridges_and_a_large_map(tmp_path: Path, server: RosbridgeServer) -> None:
    other = RosbridgeServer(OhFleet(robots=1, floors=1, seed=2, first=1))
    await other.start()
    config = config_of(server.url, 2, 1)
    one, two = config.robots
    config = replace(config, links={"annex": Link(other.url)}, robots=[one, replace(two, link="annex")])
    store = Ticking(initial_state(config, time.monotonic()))
    tap = Recorder(tmp_path / "run.jsonl.gz", config, store, ORIGIN)
    link = FleetLink(config, store, tap)
    link.open()
    try:
        await store.until(lambda state: all(robot.pose for robot in state.robots.values()))
        link.show_map("robot_0", "floor_0")
        await store.until(lambda state: state.robots["robot_0"].maps["floor_0"].grid)
        server.bridge.publish_raw(TOPIC, large_map().frame("cbor"))
        await store.until(lambda state: _width(state) == SIDE)
        await other.stop()
        down = store.state.now + 3.0
        await store.until(lambda state: state.now > down and state.links["annex"].next_try)
    finally:
        link.close()
        tap.close()
    recording = open_recording(tap.path)
    head, ticks, maps = RecordingCursor(recording), 0, 0
    while (record := head.take()) is not None:
        maps += isinstance(record, ReceivedFrame) and len(record.payload) > SIDE * SIDE
        if isinstance(record, EventRecord) and isinstance(record.event, TimePassed):
            ticks += 1
            assert plain(head.state) == plain(store.ticks[record.event.at])
    assert ticks > 30 and maps == 1

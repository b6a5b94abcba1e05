"""Scans on their way to the store of streams: placed on the robot, in our time."""

import numpy as np
from msgspec.structs import replace

from fleet_tui.links.rosbridge.set_up.stream_writer import StreamWriter
from fleet_tui.model.geometry import Pose
from fleet_tui.model.robot import StampClock
from fleet_tui.model.set_up.streams import Beams, LaserScan, PlannedPath
from fleet_tui.state.store import Store
from tests.support.fleets import R0, fleet


def test_a_scan_is_placed_on_its_robot_and_dated_by_its_stamp() -> None:
    state = fleet()
    robot = replace(
        state.robots[R0], laser=Pose(0.5, 0.0), clock=StampClock(offset=1000.0, stamp=0.0, at=0.0)
    )
    store = Store(replace(state, robots={R0: robot}))
    store.streams.watch(R0, "scan")
    writer = StreamWriter(store)
    assert writer.wants(R0, "scan") and not writer.wants(R0, "path")
    scan = LaserScan(np.ones(1, np.float32), 0.0, 0.1, 0.1, 9.0, "laser", 4.0)
    writer.put(R0, "scan", scan, 1004.2)
    found = store.streams.get(R0, "scan")
    assert found is not None and isinstance(found.value, Beams)
    assert (found.at, found.taken_at, found.value.points.tolist()) == (1004.2, 1004.0, [[1.5, 0.0]])
    writer.put("stranger", "scan", scan, 1.0)


def test_a_path_is_kept_as_it_is() -> None:
    store = Store(fleet())
    store.streams.watch(R0, "path")
    path = PlannedPath(np.zeros((2, 2), np.float32), "map", 5.0)
    StreamWriter(store).put(R0, "path", path, 9.0)
    found = store.streams.get(R0, "path")
    assert found is not None and found.value is path and found.taken_at == 9.0

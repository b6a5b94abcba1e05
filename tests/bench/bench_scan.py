"""P24: a watched laser of 720 beams at 5 Hz: from the frame to its match with the map, in per cent of a core.

Run: python -m tests.bench.bench_scan
"""

import json
import math
import time

import cbor2
import numpy as np

from fleet_tui.links.rosbridge.set_up.stream_writer import StreamWriter
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import grid_from_ros
from fleet_tui.model.set_up.streams import Beams, LaserScan, beams_of
from fleet_tui.robots.adapter import Limit, Site
from fleet_tui.robots.nav2.adapter import Nav2
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.reading import FrameReader
from fleet_tui.simulator.floorplan import HEIGHT, ORIGIN, RESOLUTION, WIDTH
from fleet_tui.simulator.frames import OutgoingFrame
from fleet_tui.simulator.senses.laser import BEAMS, ranges, scan
from fleet_tui.simulator.warehouse import build_building
from fleet_tui.situation.pose_checks.match import match
from fleet_tui.situation.pose_checks.nearby import best_near
from fleet_tui.state.store import Store
from tests.bench.rows import Row, row
from tests.support.fleets import R0, fleet

RATE, FRAMES = 5.0, 500
TRUE = Pose(8.0, 0.0, 0.4)
AT_MOST = 3.0
"""Per cent of a core."""
TOPIC = f"/{R0}/scan"


def per_cent(frames: list[bytes], is_binary: bool, with_match: bool) -> float:
    """The share of a core that a laser takes at its rate."""
    floor = build_building(1).floors[0]
    grid = grid_from_ros(MapFrame(RESOLUTION, WIDTH, HEIGHT, Pose(*ORIGIN)), floor.cells.tobytes())
    store, adapter = Store(fleet()), Nav2(Profile(kind="nav2"), Site())
    store.streams.watch(R0, "scan")
    limit, feeds = Limit(64.0, ""), list(adapter.feeds(R0, ["floor_0"]))
    sink = StreamWriter(store)
    reading = FrameReader("rosbridge", limit, {R0: adapter}, feeds, None, streams=sink)  # type: ignore[arg-type]  # no map
    start = time.process_time()
    for number, frame in enumerate(frames):
        reading.read(frame, is_binary, number / RATE)
        found = store.streams.get(R0, "scan")
        assert found is not None and isinstance(found.value, Beams) and len(found.value.points) > 500
        if with_match:
            match(grid, found.value.points, Pose(TRUE.x + number * 1e-3, TRUE.y, TRUE.yaw))
    return (time.process_time() - start) / (len(frames) / RATE) * 100


def seconds_of_search() -> float:
    """The longest search for the best fit, with the distances of the map measured in it."""
    cells, longest = build_building(1).floors[0].cells, 0.0
    laser = LaserScan(ranges(cells, TRUE), -math.pi, 2 * math.pi / BEAMS, 0.1, 12.0, "laser", None)
    points = beams_of(laser, None).points
    for heading in range(8):
        grid = grid_from_ros(MapFrame(RESOLUTION, WIDTH, HEIGHT, Pose(*ORIGIN)), cells.tobytes())
        start = time.perf_counter()
        assert best_near(grid, points, Pose(TRUE.x + 1.5, TRUE.y - 1.0, heading)) is not None
        longest = max(longest, time.perf_counter() - start)
    return longest


def main() -> list[Row]:
    cells = build_building(1).floors[0].cells
    header = {"stamp": {"sec": 1, "nanosec": 0}, "frame_id": "laser"}
    sent = OutgoingFrame(TOPIC, scan(cells, TRUE, header))
    binary, text = sent.frame("cbor"), sent.frame("none")
    assert isinstance(binary, bytes) and isinstance(text, str)
    assert cbor2.loads(binary)["topic"] == json.loads(text)["topic"] and np.pi == math.pi
    what = "laser of 720 beams at 5 Hz"
    ours = per_cent([binary] * FRAMES, True, with_match=False)
    return [
        row("P24", f"{what}: read and placed", ours, "%", AT_MOST),
        row("P24", f"{what}: with its match", per_cent([binary] * FRAMES, True, True), "%", AT_MOST),
        row("P24", f"{what}: as JSON", per_cent([text.encode()] * FRAMES, False, False), "%", None),
        row(
            "P24", "best fit nearby, map of 800 x 520, longest of 8", seconds_of_search() * 1000, "ms", 300.0
        ),
        row("P24", "a scan on the wire", len(binary) / 1000, "kB", None, len(text) / 1000, "JSON"),
    ]


if __name__ == "__main__":
    main()

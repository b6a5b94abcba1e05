"""Values of streams, from the wire to their store: scans placed on their robots, stamps as our time."""

import time
from typing import TYPE_CHECKING

from fleet_tui.links.rosbridge.set_up.mounts import Mounts
from fleet_tui.model.kind import FRAMES
from fleet_tui.model.robot import Robot
from fleet_tui.state.store import Store

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import Beams, LaserScan, StreamValue


class StreamWriter:
    """Writes the streams of one bridge. On the network loop."""

    def __init__(self, store: Store) -> None:
        self._store = store
        self._streams = store.streams
        self._mounts = Mounts(store.streams)

    def wants(self, robot: str, key: str) -> bool:
        """Tell whether a stream is watched, or its values are needed to place another one."""
        if key == FRAMES:
            return self._mounts.seeks(robot, time.monotonic())
        return self._streams.wants(robot, key)

    def put(self, robot: str, key: str, value: "StreamValue", at: float) -> None:
        """Keep a value that arrived at a monotonic second."""
        # With numpy, which a value of a stream has imported already.
        from fleet_tui.model.set_up.streams import CameraImage, LaserScan, PlannedPath, Streamed

        known = self._store.state.robots.get(robot)
        if known is None:
            return
        if not isinstance(value, LaserScan | PlannedPath | CameraImage):
            self._mounts.take(robot, value)
            return
        taken_at = at
        if value.stamp is not None and known.clock is not None:
            taken_at = min(at, value.stamp + known.clock.offset)
        shown = self._beams(known, value, at) if isinstance(value, LaserScan) else value
        self._streams.put(robot, key, Streamed(shown, at, taken_at))

    def _beams(self, robot: Robot, scan: "LaserScan", at: float) -> "Beams":
        from fleet_tui.model.set_up.streams import beams_of

        mount = self._mounts.of(robot, scan, at)
        if mount is None:
            is_sought = self._mounts.seeks(robot.name, at)
            return beams_of(scan, None, robot.laser_flipped, is_sought)
        return beams_of(scan, mount.pose, mount.is_flipped)

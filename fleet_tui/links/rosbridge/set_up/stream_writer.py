"""Values of streams, from the wire to their store: scans placed on their robots, stamps as our time."""

import time
from typing import TYPE_CHECKING

from fleet_tui.model.kind import FRAMES
from fleet_tui.model.robot import Robot
from fleet_tui.state.store import Store

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import Beams, LaserScan, StreamValue

from typing import TYPE_CHECKING

from fleet_tui.model.kind import SCAN
from fleet_tui.model.set_up.frames import Frames, Mount, Transform, mount_of
from fleet_tui.state.streams import Streams
from fleet_tui.text.limits import MOST_FRAMES

if TYPE_CHECKING:  # numpy
    from fleet_tui.model.set_up.streams import LaserScan


LOOK_FOR = 3.0
"""Seconds for which static transforms are subscribed: they are latched, and arrive at once."""


class Mounts:
    """Runs on the network loop. Times are monotonic seconds."""

    def __init__(self, streams: Streams) -> None:
        self._streams = streams
        self._frames: dict[str, dict[str, Transform]] = {}
        self._sought_since: dict[str, float] = {}

    def take(self, robot: str, frames: Frames) -> None:
        """Keep the static transforms of a robot: each publisher sends its own."""
        known = self._frames.setdefault(robot, {})
        known |= frames
        for frame in list(known)[: max(0, len(known) - MOST_FRAMES)]:
            del known[frame]

    def of(self, robot: Robot, scan: "LaserScan", at: float) -> Mount | None:
        """Return the place of the laser that a scan is from, which arrived at `at`; None while it is
        unknown."""
        if robot.laser is not None:
            return Mount(robot.laser, robot.laser_flipped)
        found = mount_of(self._frames.get(robot.name, {}), robot.base_frame, scan.frame_id)
        if found is not None:
            self._sought_since.pop(robot.name, None)
        elif self._streams.get(robot.name, SCAN) is None:  # watched from now on
            self._sought_since[robot.name] = at
        return found

    def seeks(self, robot: str, now: float) -> bool:
        """Tell whether the transforms of a robot are needed: its scan is watched, and has no place yet."""
        since = self._sought_since.get(robot)
        return since is not None and now - since < LOOK_FOR and self._streams.wants(robot, SCAN)


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

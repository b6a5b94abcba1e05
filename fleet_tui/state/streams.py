"""Streams beside the fleet state: the newest value of each that is watched. Callable from any thread."""

from typing import TYPE_CHECKING

from fleet_tui.model.geometry import Pose
from fleet_tui.model.kind import SCAN
from fleet_tui.model.robot import Reading, Robot

if TYPE_CHECKING:  # numpy: the console paints before it is imported
    from fleet_tui.model.set_up.streams import Streamed

Watch = tuple[str, str]
"""A robot, and the key of a stream."""
TRACK = 30
"""Poses kept of a robot whose scan is watched."""
APART = 0.3
"""Seconds between a scan and the nearest pose above which the robot's place at that time is unknown."""


class Streams:
    """The watched streams. Each change replaces a whole value, so that no reader waits."""

    def __init__(self) -> None:
        self._watched: dict[Watch, int] = {}
        self._values: dict[Watch, Streamed] = {}
        self._tracks: dict[str, tuple[Reading[Pose], ...]] = {}

    def watch(self, robot: str, key: str) -> None:
        """Subscribe to a stream of a robot, once more for each watcher."""
        self._watched[robot, key] = self._watched.get((robot, key), 0) + 1

    def unwatch(self, robot: str, key: str) -> None:
        """Unsubscribe one watcher; with the last one the value is dropped."""
        left = self._watched.get((robot, key), 0) - 1
        if left > 0:
            self._watched[robot, key] = left
            return
        self._watched.pop((robot, key), None)
        self._values.pop((robot, key), None)
        if key == SCAN:
            self._tracks.pop(robot, None)

    def wants(self, robot: str, key: str) -> bool:
        """Tell whether a stream is watched."""
        return (robot, key) in self._watched

    def put(self, robot: str, key: str, value: "Streamed") -> None:
        """Keep the newest value of a watched stream."""
        if self.wants(robot, key):
            self._values[robot, key] = value

    def get(self, robot: str, key: str) -> "Streamed | None":
        """Return the newest value of a stream, None before the first."""
        return self._values.get((robot, key))

    def note(self, robot: Robot) -> None:
        """Keep a pose of a robot whose scan is watched, to place its scans by."""
        if robot.pose is not None and self.wants(robot.name, SCAN):
            track = self._tracks.get(robot.name, ())
            if not track or track[-1].at < robot.pose.at:
                self._tracks[robot.name] = (*track[1 - TRACK :], robot.pose)
            elif track[-1].value != robot.pose.value:  # localised again: the earlier places are void
                self._tracks[robot.name] = (robot.pose,)

    def pose_at(self, robot: str, at: float) -> Pose | None:
        """Return the pose of a robot at a monotonic second, None if it reported none near that time."""
        track = self._tracks.get(robot, ())
        before = next((one for one in reversed(track) if one.at <= at), None)
        after = next((one for one in track if one.at >= at), None)
        if before is not None and after is not None and 0.0 < after.at - before.at <= 2 * APART:
            return _between(before, after, at)
        near = [one for one in (before, after) if one is not None and abs(one.at - at) <= APART]
        return min(near, key=lambda one: abs(one.at - at)).value if near else None


def _between(before: Reading[Pose], after: Reading[Pose], at: float) -> Pose:
    """Return the pose between two others, turned the short way."""
    part = (at - before.at) / (after.at - before.at)
    step = before.value.inverse.after(after.value)
    x = before.value.x + part * (after.value.x - before.value.x)
    y = before.value.y + part * (after.value.y - before.value.y)
    return Pose(x, y, before.value.yaw + part * step.yaw)

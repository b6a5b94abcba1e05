"""Poses, quaternions and the placement of a map's pixels in the world. Metres and radians throughout."""

import math

from msgspec import Struct

Line = tuple[float, float, float, float]
"""x1, y1, x2, y2 in metres."""


class Pose(Struct, frozen=True):
    """A planar pose: x, y in metres, yaw in radians, counter-clockwise from the x axis."""

    x: float
    y: float
    yaw: float = 0.0

    def after(self, step: "Pose") -> "Pose":
        """Return the pose that is `step` away from this one, `step` being in this one's frame."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        x, y = self.x + cos * step.x - sin * step.y, self.y + sin * step.x + cos * step.y
        return Pose(x, y, math.remainder(self.yaw + step.yaw, math.tau))

    @property
    def inverse(self) -> "Pose":
        """Return the inverse pose: `pose.after(pose.inverse)` is the origin."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        return Pose(-cos * self.x - sin * self.y, sin * self.x - cos * self.y, -self.yaw)


def yaw_of_quaternion(x: float, y: float, z: float, w: float) -> float:
    """The yaw in radians of a quaternion, which need not be a unit one.

    Raises ValueError for a quaternion of length zero, which is no rotation.
    """
    norm = x * x + y * y + z * z + w * w
    if not math.isfinite(norm) or norm < 1e-12:
        raise ValueError("quaternion of length zero")
    return math.atan2(2.0 * (w * z + x * y), norm - 2.0 * (y * y + z * z))


class MapFrame(Struct, frozen=True):
    """The placement of a map image in the world (nav_msgs/MapMetaData).

    resolution: metres per pixel; width, height: pixels; origin: pose of the lower-left pixel
    in the world. `added`: the robot stack adds the origin instead of subtracting it.
    Pixels are (column, row) with row 0 at the TOP of the image.
    """

    resolution: float
    width: int
    height: int
    origin: Pose = Pose(0.0, 0.0)
    added: bool = False

    def to_pixel(self, x: float, y: float) -> tuple[float, float]:
        """World metres to (column, row), as fractions of pixels."""
        sign = 1.0 if self.added else -1.0
        dx, dy = x + sign * self.origin.x, y + sign * self.origin.y
        cos, sin = math.cos(self.origin.yaw), math.sin(self.origin.yaw)
        right, up = cos * dx + sin * dy, cos * dy - sin * dx
        return right / self.resolution, self.height - up / self.resolution

    def to_world(self, column: float, row: float) -> tuple[float, float]:
        """(column, row) to world metres: the inverse of `to_pixel`."""
        right, up = column * self.resolution, (self.height - row) * self.resolution
        cos, sin = math.cos(self.origin.yaw), math.sin(self.origin.yaw)
        sign = -1.0 if self.added else 1.0
        return (cos * right - sin * up + sign * self.origin.x, sin * right + cos * up + sign * self.origin.y)


def metres_from(at: tuple[float, float], line: Line) -> float:
    """Return the metres from a place to a line between two others."""
    (x, y), (x0, y0, x1, y1) = at, line
    square = (x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0)  # ** would raise on a pose at 1e300
    share = ((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / square if square else 0.0
    share = min(1.0, max(0.0, share))
    return math.dist(at, (x0 + share * (x1 - x0), y0 + share * (y1 - y0)))

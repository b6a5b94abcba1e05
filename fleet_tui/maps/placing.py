"""Gives a picture of a floor its scale and its place by two of its points, a known distance apart."""

import math

from msgspec.structs import replace

from fleet_tui.errors import MapError
from fleet_tui.model.geometry import MapFrame, Pose

Pixel = tuple[float, float]
"""Column and row, from the picture's upper left corner."""


def placed(
    frame: MapFrame,
    points: tuple[Pixel, Pixel],
    distance: float,
    at: tuple[float, float] | None = None,
    heading: float | None = None,
) -> MapFrame:
    """Return the frame of a picture in which two points are `distance` metres apart.

    `at`: the place of the first point in metres, else the lower left corner is at (0, 0). `heading`: the
    direction from the first to the second point in degrees, counter-clockwise from x, else the picture is not
    turned. Raises MapError for points or a distance that give no scale.
    """
    if not all(map(math.isfinite, (distance, *(at or ()), heading or 0.0))):
        raise MapError("distance, place and heading must be finite numbers")
    for column, row in points:
        if not (0.0 <= column <= frame.width and 0.0 <= row <= frame.height):
            size = f"{frame.width} x {frame.height} px"
            raise MapError(f"point {column:g}, {row:g} is not in the picture of {size}")
    pixels = math.dist(*points)
    if pixels < 1.0 or distance <= 0.0:
        raise MapError("two points at least a pixel apart and a distance above 0 are needed")
    (column, row), (to_column, to_row) = points
    drawn = math.atan2(row - to_row, to_column - column)
    yaw = 0.0 if heading is None else math.remainder(math.radians(heading) - drawn, math.tau)
    turned = replace(frame, resolution=distance / pixels, origin=Pose(0.0, 0.0, yaw))
    if at is None:
        return turned
    x, y = turned.to_world(column, row)
    return replace(turned, origin=Pose(at[0] - x, at[1] - y, yaw))

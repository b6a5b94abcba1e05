"""Gives a picture of a floor its scale and its place by two of its points, a known distance apart."""

import math

from msgspec.structs import replace

from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.text.errors import MapError
from fleet_tui.text.language import Message

Pixel = tuple[float, float]
"""Column and row, from the picture's upper left corner."""
FINEST = 1e-4
COARSEST = 100.0
"""Metres per pixel of a map."""
FARTHEST = 1e6
"""Metres from the origin."""


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
    _check(frame, points, distance, at, heading)
    pixels = math.dist(*points)
    (column, row), (to_column, to_row) = points
    drawn = math.atan2(row - to_row, to_column - column)
    yaw = 0.0 if heading is None else math.remainder(math.radians(heading) - drawn, math.tau)
    turned = replace(frame, resolution=distance / pixels, origin=Pose(0.0, 0.0, yaw))
    if at is None:
        return turned
    x, y = turned.to_world(column, row)
    return replace(turned, origin=Pose(at[0] - x, at[1] - y, yaw))


def _check(
    frame: MapFrame,
    points: tuple[Pixel, Pixel],
    distance: float,
    at: tuple[float, float] | None,
    heading: float | None,
) -> None:
    """Raise MapError for numbers that give no map."""
    if not all(abs(metres) <= FARTHEST for metres in at or ()):
        raise MapError(
            Message("the place of the first point must be within {farthest} m", farthest=f"{FARTHEST:,.0f}")
        )
    if not abs(heading or 0.0) <= 360.0:
        raise MapError(Message("the heading must be from -360 to 360 degrees"))
    for column, row in points:
        if not (0.0 <= column <= frame.width and 0.0 <= row <= frame.height):
            size = f"{frame.width} x {frame.height} px"
            raise MapError(
                Message(
                    "point {column}, {row} is not in the picture of {size}",
                    column=f"{column:g}",
                    row=f"{row:g}",
                    size=size,
                )
            )
    pixels = math.dist(*points)
    if pixels < 1.0:
        raise MapError(Message("the two points must be at least a pixel apart"))
    if not FINEST <= distance / pixels <= COARSEST:
        least, most = FINEST * pixels, COARSEST * pixels
        limits = Message(
            "from {least} to {most} m, not {distance}",
            least=f"{least:g}",
            most=f"{most:g}",
            distance=f"{distance:g}",
        )
        raise MapError(
            Message(
                "the distance of points {pixels} px apart must be {limits}",
                pixels=f"{pixels:.0f}",
                limits=limits,
            )
        )

"""The occupancy grid as a value. Without numpy: the console paints before it is imported."""

from typing import TYPE_CHECKING, Final

from fleet_tui.model.geometry import MapFrame
from fleet_tui.text.errors import MapError
from fleet_tui.text.language import Message

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


MAX_PIXELS = 100_000_000
UNKNOWN = 0
FREE = 1
OCCUPIED = 2
"""The classes of cells."""


class OccupancyGrid:
    """A map ready to draw. `levels[k]` is uint8 of shape (ceil(height / 2**k), ceil(width / 2**k)), row 0 at
    the top; an entry of level k is the maximum of the 2**k x 2**k cells it covers.

    No dataclass: recordings have their own format for it.
    """

    __slots__ = ("frame", "levels")

    def __init__(self, frame: MapFrame, levels: tuple["NDArray[np.uint8]", ...]) -> None:
        self.frame: Final = frame
        self.levels: Final = levels


def class_at(grid: OccupancyGrid, x: float, y: float) -> int:
    """Return the class of the cell at a place in metres: beyond the map it is unknown."""
    column, row = grid.frame.to_pixel(x, y)
    if not (0.0 <= column < grid.frame.width and 0.0 <= row < grid.frame.height):
        return UNKNOWN
    return int(grid.levels[0][int(row), int(column)])


def check_frame(frame: MapFrame) -> None:
    """Raise MapError for a size or resolution that no map can have."""
    if not frame.resolution > 0.0:
        raise MapError(
            Message("map resolution {resolution} m/px: must be above 0", resolution=frame.resolution)
        )
    if frame.width < 1 or frame.height < 1:
        raise MapError(
            Message(
                "map size {width} x {height} px: both must be at least 1",
                width=frame.width,
                height=frame.height,
            )
        )
    if frame.width * frame.height > MAX_PIXELS:
        raise MapError(
            Message(
                "map of {width} x {height} px exceeds {max_pixels} px",
                width=frame.width,
                height=frame.height,
                max_pixels=f"{MAX_PIXELS:,}",
            )
        )

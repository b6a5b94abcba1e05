"""The occupancy grid as a value. Without numpy: the console paints before it is imported."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from fleet_tui.model.geometry import MapFrame

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


@dataclass(frozen=True, slots=True, eq=False)
class OccupancyGrid:
    """A map ready to draw. `levels[k]` is uint8 of shape (ceil(height / 2**k), ceil(width / 2**k)),
    row 0 at the top; an entry of level k is the maximum of the 2**k x 2**k cells it covers."""

    frame: MapFrame
    levels: tuple["NDArray[np.uint8]", ...]

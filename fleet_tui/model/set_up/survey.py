"""Facts of a map for an operator: its size, and the ground that is known."""

import numpy as np
from msgspec import Struct

from fleet_tui.model.grid import FREE, OCCUPIED, OccupancyGrid
from fleet_tui.text.language import Message


class Survey(Struct, frozen=True):
    """Size in cells and metres, metres per cell, place of the lower left corner, and areas in square
    metres."""

    columns: int
    rows: int
    resolution: float
    origin: tuple[float, float, float]
    free: float
    occupied: float

    @property
    def known(self) -> float:
        """Return the area that is free or occupied."""
        return self.free + self.occupied

    @property
    def size(self) -> tuple[float, float]:
        """Return width and height in metres."""
        return self.columns * self.resolution, self.rows * self.resolution

    @property
    def text(self) -> Message:
        """Return size and known area in words."""
        width, height = self.size
        cells = Message("{columns} x {rows} cells", columns=self.columns, rows=self.rows)
        return Message(
            "{width} x {height} m, {cells} of {resolution} m, {known} m2 known",
            width=f"{width:.1f}",
            height=f"{height:.1f}",
            cells=cells,
            resolution=f"{self.resolution:.3g}",
            known=f"{self.known:.0f}",
        )


def survey(grid: OccupancyGrid) -> Survey:
    """Return the facts of a map."""
    frame, cell = grid.frame, grid.frame.resolution**2
    counts = np.bincount(grid.levels[0].ravel(), minlength=3)
    origin = frame.origin.x, frame.origin.y, frame.origin.yaw
    areas = float(counts[FREE] * cell), float(counts[OCCUPIED] * cell)
    return Survey(frame.width, frame.height, frame.resolution, origin, *areas)

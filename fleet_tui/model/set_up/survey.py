"""Facts of a map for an operator: its size, and the ground that is known."""

import numpy as np
from msgspec import Struct

from fleet_tui.model.grid import FREE, OCCUPIED, OccupancyGrid


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
    def text(self) -> str:
        """Return size and known area in words."""
        width, height = self.size
        cells = f"{self.columns} x {self.rows} cells"
        return f"{width:.1f} x {height:.1f} m, {cells} of {self.resolution:.3g} m, {self.known:.0f} m2 known"


def survey(grid: OccupancyGrid) -> Survey:
    """Return the facts of a map."""
    frame, cell = grid.frame, grid.frame.resolution**2
    counts = np.bincount(grid.levels[0].ravel(), minlength=3)
    origin = frame.origin.x, frame.origin.y, frame.origin.yaw
    areas = float(counts[FREE] * cell), float(counts[OCCUPIED] * cell)
    return Survey(frame.width, frame.height, frame.resolution, origin, *areas)

"""A map as text."""

import os
import sys

from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.map.raster import ground

SIZE = 80, 24
"""Columns and lines without a terminal."""
SMALLEST = 20, 8


def output_size() -> tuple[int, int]:
    """Return the columns and lines of the terminal that is written to; a line is left for the prompt."""
    if not sys.stdout.isatty():
        return SIZE
    columns, lines = os.get_terminal_size(sys.stdout.fileno())
    return max(columns, SMALLEST[0]), max(lines - 1, SMALLEST[1])


def output_drawing() -> Drawing:
    """Return braille where the output has it, else ASCII."""
    encoding = (sys.stdout.encoding or "").lower().replace("-", "")
    return Drawing.BRAILLE if encoding.startswith("utf") else Drawing.ASCII


def map_text(grid: OccupancyGrid, width: int, height: int, drawing: Drawing) -> str:
    """Return the whole map in at most so many columns and lines."""
    extent = grid.frame.width, grid.frame.height
    lines = min(height, Camera.lines_of(extent, width))
    cells = ground(grid, Camera.fit(extent, width, max(1, lines)), drawing)
    rows = ("".join(map(chr, row)).rstrip() for row in cells.codes.tolist())
    return "\n".join(rows).rstrip("\n")

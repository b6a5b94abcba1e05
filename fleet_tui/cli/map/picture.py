"""A map as text."""

import os
import sys
from collections.abc import Iterator

from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.text.errors import MapError
from fleet_tui.text.language import Message
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.ground.raster import ground

SIZE = 80, 24
"""Columns and lines without a terminal."""
SMALLEST = 20, 8
MARGIN = 7
TICK = 10
"""Cells for the number of a pixel row, and from one pixel column with a number to the next."""
Part = tuple[float, float, float, float]
"""First column and row, width, height, in pixels."""


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
    camera = Camera.fit(extent, width, max(1, min(height, Camera.lines_of(extent, width))))
    return "\n".join(_rows(grid, camera, drawing)).rstrip("\n")


def numbered_text(grid: OccupancyGrid, part: Part, width: int, height: int, drawing: Drawing) -> str:
    """Return a part of the map in at most so many columns and lines: above it the pixel columns at the first,
    the eleventh cell and so on, before each line its pixel row. Raises MapError for a part without pixels."""
    column, row, across, down = part
    extent = grid.frame.width, grid.frame.height
    if not (column < extent[0] and row < extent[1] and across > 0.0 and down > 0.0):
        size = f"{extent[0]} x {extent[1]} px"
        raise MapError(
            Message(
                "--part {column} {row} {across} {down} has no pixels of the map of {size}",
                column=f"{column:g}",
                row=f"{row:g}",
                across=f"{across:g}",
                down=f"{down:g}",
                size=size,
            )
        )
    area = column, row, column + max(across, 1.0), row + max(down, 1.0)
    lines = min(height - 1, Camera.lines_of(extent, width - MARGIN, area))
    camera = Camera.fit(extent, width - MARGIN, max(1, lines), area)
    heads = (f"{camera.to_pixel(x, 0)[0]:<{TICK}.0f}" for x in range(0, camera.width, TICK))
    text = [" " * MARGIN + "".join(heads)[: camera.width].rstrip()]
    for y, line in enumerate(_rows(grid, camera, drawing)):
        text.append(f"{camera.to_pixel(0, y)[1]:>{MARGIN - 1}.0f} {line}")
    return "\n".join(text)


def _rows(grid: OccupancyGrid, camera: Camera, drawing: Drawing) -> Iterator[str]:
    for codes in ground(grid, camera, drawing).codes.tolist():
        yield "".join(map(chr, codes)).rstrip()

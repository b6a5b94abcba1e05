"""The visible part of the map: an immutable camera over map pixels, snapped to whole cells.

A cell is 2 x 4 dots; `scale` is map pixels per dot, down the view `scale / tall`. Cells are counted from the
map's upper left pixel, so a dot always covers the same pixels and panning does not shimmer.
"""

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

from fleet_tui.model.attention import SeenArea
from fleet_tui.model.geometry import MapFrame

DOTS_X = 2
DOTS_Y = 4
MIN_SCALE = 0.125
SMALL = 1200
"""Cells of a view below which a fitted area is stretched: a few more cells are worth more than its shape."""
MOST_TALL = 1.2
FILLED = 1.3
"""By how much it is drawn longer down or across at most, and if it then takes all cells of the view."""
ZOOM_STEP = math.sqrt(2.0)
BEYOND = 0.25
"""Share of the view's size around it that counts as seen: the map may be moved there next."""
_DEAD_ZONE = 0.3  # of the view, to each side of its middle: a followed robot moves freely in it


Area = tuple[float, float, float, float]
"""left, top, right, bottom in map pixels."""


@dataclass(frozen=True, slots=True)
class Camera:
    """column, row: the view's centre in map pixels; scale: pixels per dot; width, height: cells;
    extent: the map's width and height in pixels; tall: how much longer lengths are drawn down than across."""

    column: float
    row: float
    scale: float
    width: int
    height: int
    extent: tuple[int, int]
    tall: float = 1.0

    @classmethod
    def fit(cls, extent: tuple[int, int], width: int, height: int, area: Area | None = None) -> "Camera":
        """Return the camera that shows the area, by default the whole map, as large as possible; in a small
        view it fills more of it than its shape would."""
        left, top, right, bottom = area or (0.0, 0.0, *extent)
        middle = (left + right) / 2, (top + bottom) / 2
        scales = _fit_scales((right - left, bottom - top), width, height)
        if width * height >= SMALL or min(scales) == MIN_SCALE:
            return cls(*middle, max(scales), width, height, extent)
        x, y = _snug(left, right, width, DOTS_X), _snug(top, bottom, height, DOTS_Y)
        across = max(x.scale, _stretched(x, y.scale, scales[0]))
        down = max(y.scale, _stretched(y, x.scale, scales[1]))
        column = x.middle if across == x.scale else middle[0]
        row = y.middle if down == y.scale else middle[1]
        return cls(column, row, across, width, height, extent, across / down)

    @staticmethod
    def lines_of(extent: tuple[int, int], width: int, area: Area | None = None) -> int:
        """Return the lines from which the area, by default the whole map, fills `width` cells when fitted."""
        left, top, right, bottom = area or (0.0, 0.0, *extent)
        scale = max(_fit_scales((right - left, 0.0), width, 1))
        return math.ceil((bottom - top) / (DOTS_Y * scale)) + 1

    @property
    def dot(self) -> tuple[float, float]:
        """Return the size of a dot in map pixels: across, down."""
        return self.scale, self.scale / self.tall

    @property
    def cell(self) -> tuple[float, float]:
        """Return the size of a cell in map pixels: across, down."""
        across, down = self.dot
        return DOTS_X * across, DOTS_Y * down

    @property
    def origin(self) -> tuple[int, int]:
        """Return the upper left cell of the view, in whole cells from the map's upper left corner."""
        across, down = self.cell
        return round(self.column / across - self.width / 2), round(self.row / down - self.height / 2)

    def to_cell(self, column: float, row: float) -> tuple[int, int]:
        """Return the cell (x, y) of the view for a map pixel; may lie outside the view."""
        left, top = self.origin
        across, down = self.cell
        return math.floor(column / across) - left, math.floor(row / down) - top

    def to_pixel(self, x: int, y: int) -> tuple[float, float]:
        """Return the map pixel (column, row) in the middle of cell (x, y)."""
        left, top = self.origin
        across, down = self.cell
        return (left + x + 0.5) * across, (top + y + 0.5) * down

    def shows(self, x: int, y: int) -> bool:
        """Tell whether cell (x, y) is in the view."""
        return 0 <= x < self.width and 0 <= y < self.height

    def centred(self, column: float, row: float) -> "Camera":
        """Return the camera centred there, or on the nearest point of the map: the map always stays in
        view."""
        columns, rows = self.extent
        return replace(self, column=min(max(column, 0.0), columns), row=min(max(row, 0.0), rows))

    def centred_within(self, column: float, row: float, area: Area) -> "Camera":
        """Return the camera centred as near to there as shows nothing beyond the area."""
        left, top, right, bottom = area
        across, down = self.cell
        held = _held(column, left, right, self.width * across), _held(row, top, bottom, self.height * down)
        return self.centred(*held)

    def panned(self, right: int, down: int) -> "Camera":
        """Return the camera moved by whole cells."""
        wide, high = self.cell
        return self.centred(self.column + right * wide, self.row + down * high)

    def zoomed(self, factor: float, about: tuple[float, float] | None = None) -> "Camera":
        """Return the camera zoomed in by `factor` (above 1) or out, with map pixel `about` staying in
        place."""
        furthest = max(2.0 * Camera.fit(self.extent, self.width, self.height).scale, MIN_SCALE)
        scale = min(max(self.scale / factor, MIN_SCALE), furthest)
        column, row = about or (self.column, self.row)
        ratio = scale / self.scale
        nearer = replace(self, scale=scale)
        return nearer.centred(column + (self.column - column) * ratio, row + (self.row - row) * ratio)

    def resized(self, width: int, height: int) -> "Camera":
        """Return the camera with the same centre in a view of another size in cells; a large one shows the
        shape as it is."""
        tall = self.tall if width * height < SMALL else 1.0
        return replace(self, width=width, height=height, tall=tall)

    def at_scale_of(self, other: "Camera", frame: MapFrame, own: MapFrame) -> "Camera":
        """Return the camera with the metres per dot of another one, over a map of that `frame`."""
        return replace(self, scale=other.scale * frame.resolution / own.resolution)

    def followed(self, column: float, row: float, area: Area) -> "Camera":
        """Return the camera unchanged while the point is near the middle, else centred on it within the area,
        each axis for itself: at the floor's edge the point stays far from the middle of one.

        One jump now and then instead of a step per tick: the background rarely moves.
        """
        x, y = self.to_cell(column, row)
        far_x = abs(x - self.width / 2) > self.width * _DEAD_ZONE
        far_y = abs(y - self.height / 2) > self.height * _DEAD_ZONE
        there = self.centred_within(column, row, area)
        return self.centred(there.column if far_x else self.column, there.row if far_y else self.row)

    def reframed(self, old: MapFrame, new: MapFrame) -> "Camera":
        """Return the same place and size of view in metres, after the map's frame changed."""
        scale = self.scale * old.resolution / new.resolution
        moved = replace(self, scale=scale, extent=(new.width, new.height))
        return moved.centred(*new.to_pixel(*old.to_world(self.column, self.row))).zoomed(1.0)


def _held(at: float, low: float, high: float, view: float) -> float:
    """Return the centre of a view of this length nearest to `at` that stays between two ends."""
    spare = (high - low - view) / 2
    middle = (low + high) / 2
    return min(max(at, middle - spare), middle + spare) if spare > 0 else middle


def _fit_scales(extent: tuple[float, float], width: int, height: int) -> tuple[float, float]:
    # One extra cell on each side: snapping to whole cells then never cuts the map's rim off.
    across = extent[0] / (DOTS_X * max(width - 2, 1))
    return max(across, MIN_SCALE), max(extent[1] / (DOTS_Y * max(height - 1, 1)), MIN_SCALE)


class _Snug(NamedTuple):
    """The scale at which a length of the map takes all cells of a view, and their middle in pixels."""

    scale: float
    middle: float


def _snug(low: float, high: float, cells: int, dots: int) -> _Snug:
    """Let the cells end with the length or begin with it, whichever makes them smaller; if neither does well,
    one of them is left over. A wall may be drawn half a dot later: for that there is space at its end."""
    high += (high - low) / (cells * dots * 2)
    first, safe = math.floor(low * cells / (high - low)), (high - low) / max(cells - 1, 1)
    ending = (high / (first + cells), first) if first + cells > 0 else (math.inf, 0)
    beginning = (low / (first + 1), first + 1) if first + 1 < 0 else (math.inf, 0)
    cell, begin = min(ending, beginning)
    if cell > safe:
        return _Snug(safe / dots, (low + high) / 2)
    cell *= 1 + 1e-9  # so that rounding leaves the last pixel in the view
    return _Snug(cell / dots, (begin + cells / 2) * cell)


def _stretched(one: _Snug, other: float, safe: float) -> float:
    """Return the scale of an axis that the scale of the other one limits. Below the `safe` one snapping could
    cut the rim off, unless the axis takes all cells."""
    wanted = other / MOST_TALL
    if wanted >= safe:
        return wanted
    return one.scale if other <= one.scale * FILLED else safe


def seen_area(camera: Camera, frame: MapFrame) -> SeenArea:
    """Return the area in metres that a view shows, and a little more."""
    cell, high = camera.cell
    across, down = (0.5 + BEYOND) * camera.width * cell, (0.5 + BEYOND) * camera.height * high
    ends = [(x, y) for x in (-across, across) for y in (-down, down)]
    places = [frame.to_world(camera.column + x, camera.row + y) for x, y in ends]
    (left, *_, right), (low, *_, top) = (sorted(one) for one in zip(*places, strict=True))
    return SeenArea(left, low, right, top, cell * frame.resolution)


def scale_bar(camera: Camera, frame: MapFrame, width: int) -> tuple[str, int]:
    """Return a round length (1, 2 or 5 x 10^k metres) of at most `width` cells: its text and its cells.

    Of at least one cell, even if `width` is too small for it.
    """
    cell = DOTS_X * camera.scale * frame.resolution
    power = 10.0 ** math.floor(math.log10(max(width, 1) * cell))
    length = max((step * power for step in (1, 2, 5) if step * power <= width * cell), default=power)
    text = f"{length / 1000:g} km" if length >= 1000 else f"{length:g} m"
    return text, max(round(length / cell), 1)

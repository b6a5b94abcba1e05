"""Lint against the map: room for the robot at vertices and along edges."""

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from fleet_tui.features.graphs.rules.elements import named
from fleet_tui.features.graphs.rules.finding import GraphFinding
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.occupancy import FREE, UNKNOWN
from fleet_tui.text.language import Message

MARGIN = 0.1
"""Metres beyond half the robot's width that a vertex is kept free."""
WIDEST = 30
"""Pixels of a radius; wider ones are looked at on a coarser map."""
STEP = 0.5
"""Pixels between the places of an edge that are looked at."""

_Mask = NDArray[np.bool_]
_Floats = NDArray[np.float64]


class _Obstacles:
    """The cells that are not free, as far as the graph reaches."""

    def __init__(self, floor: DocumentFloor, grid: OccupancyGrid, radius: float) -> None:
        frame = grid.frame
        self._frame = frame
        self._scale = max(1, math.ceil(radius / frame.resolution / WIDEST))
        pixels = [frame.to_pixel(v.x, v.y) for v in floor.vertices.values()]
        finite = [pixel for pixel in pixels if max(map(abs, pixel)) < 1e9] or [(0.0, 0.0)]
        margin = radius / frame.resolution + 2 * self._scale
        self._left = max(0, math.floor(min(column for column, _ in finite) - margin))
        self._top = max(0, math.floor(min(row for _, row in finite) - margin))
        right = math.ceil(max(column for column, _ in finite) + margin)
        bottom = math.ceil(max(row for _, row in finite) + margin)
        cells = grid.levels[0][self._top : max(bottom, 0), self._left : max(right, 0)]
        self.taken = _coarser(cells != FREE, self._scale)
        self.unknown = _coarser(cells == UNKNOWN, self._scale)

    def radius(self, metres: float) -> float:
        """Return metres in cells, and half a cell: from its middle to its edge."""
        return metres / self._frame.resolution / self._scale + 0.5

    def cells(self, x: float, y: float) -> tuple[float, float]:
        """Return the place of a point in cells."""
        column, row = self._frame.to_pixel(x, y)
        return (column - self._left) / self._scale, (row - self._top) / self._scale


def _coarser(mask: _Mask, scale: int) -> _Mask:
    """Return the mask with one cell for `scale` x `scale`: set if one of them is."""
    if scale == 1:
        return mask
    rows, columns = mask.shape
    padded = np.pad(mask, ((0, -rows % scale), (0, -columns % scale)))
    blocks = padded.reshape(-(-rows // scale), scale, -(-columns // scale), scale)
    return np.asarray(blocks.any(axis=(1, 3)))


def widened(mask: _Mask, radius: float) -> _Mask:
    """Return the cells whose middle is within `radius` of a set one's."""
    found = mask.copy()
    for down in range(int(radius) + 1):
        across = int(math.sqrt(max(radius * radius - down * down, 0.0)))
        row = spread(mask, across)
        if down:
            found[down:] |= row[:-down]
            found[:-down] |= row[down:]
        else:
            found |= row
    return found


def spread(mask: _Mask, across: int) -> _Mask:
    """Return the cells with a set one at most `across` columns away. The reach doubles with each step."""
    found, reach = mask.copy(), 0
    while reach < across:
        step = min(max(2 * reach, 1), across) - reach if reach else 1
        wider = found.copy()
        wider[:, step:] |= found[:, :-step]
        wider[:, :-step] |= found[:, step:]
        found, reach = wider, reach + step
    return found


def clearance(floor: DocumentFloor, grid: OccupancyGrid, width: float) -> list[list[GraphFinding]]:
    """Return the findings at vertices, and those along edges, for a robot of `width` metres."""
    obstacles = _Obstacles(floor, grid, width / 2 + MARGIN)
    if not obstacles.taken.size:
        return []
    return [list(_at_vertices(floor, obstacles, width)), list(_along_edges(floor, obstacles, width))]


def _hit(mask: _Mask, places: _Floats) -> _Mask:
    """Tell which places, rows of column and row, are on a set cell; off the map is unknown ground, too."""
    with np.errstate(invalid="ignore"):
        inside = ((places >= 0) & (places < mask.shape[::-1])).all(axis=1)
    found = np.ones(len(places), np.bool_)
    cells = places[inside].astype(np.intp)
    found[inside] = mask[cells[:, 1], cells[:, 0]]
    return found


def _at_vertices(floor: DocumentFloor, obstacles: _Obstacles, width: float) -> Iterator[GraphFinding]:
    vertices = list(floor.vertices.values())
    places = np.array([obstacles.cells(one.x, one.y) for one in vertices], np.float64).reshape(-1, 2)
    unknown = _hit(obstacles.unknown, places)
    near = _hit(widened(obstacles.taken & ~obstacles.unknown, obstacles.radius(width / 2 + MARGIN)), places)
    for n in np.flatnonzero(unknown | near):
        id_ = vertices[n].id
        if unknown[n]:
            text = Message("vertex {named}: on unknown ground", named=named(vertices[n]))
        else:
            text = Message(
                "vertex {named}: nearer to an obstacle than {width} m",
                named=named(vertices[n]),
                width=f"{width / 2 + MARGIN:.2f}",
            )
        yield GraphFinding("clearance", text, False, "", (id_,))


def _along_edges(floor: DocumentFloor, obstacles: _Obstacles, width: float) -> Iterator[GraphFinding]:
    blocked = widened(obstacles.taken, obstacles.radius(width / 2))
    edges = [edge for edge in floor.edges.values() if _is_drawn(floor, edge)]
    ends = np.array(
        [
            obstacles.cells(at.x, at.y)
            for edge in edges
            for at in (floor.vertices[edge.start], floor.vertices[edge.end])
        ],
        np.float64,
    ).reshape(-1, 2, 2)
    for part in range(0, len(edges), 500):  # bounds the memory
        for n in _meeting(blocked, ends[part : part + 500]):
            edge = edges[part + n]
            text = Message(
                "edge {id} from {start} to {end}: no room for a robot {width} m wide",
                id=edge.id,
                start=edge.start,
                end=edge.end,
                width=f"{width:g}",
            )
            yield GraphFinding("no room", text, False, "", (), (edge.id,))


def _is_drawn(floor: DocumentFloor, edge: DocumentEdge) -> bool:
    at = [floor.vertices.get(end) for end in (edge.start, edge.end)]
    return all(one is not None and abs(one.x) < 1e6 and abs(one.y) < 1e6 for one in at)


def _meeting(blocked: _Mask, ends: _Floats) -> list[int]:
    """Return the rows of lines (start, end; in cells) that meet a set cell."""
    way = ends[:, 1] - ends[:, 0]
    steps = np.minimum(np.hypot(way[:, 0], way[:, 1]) / STEP, 100_000).astype(np.intp) + 2
    line = np.repeat(np.arange(len(steps)), steps)
    along = np.arange(len(line)) - np.repeat(np.cumsum(steps) - steps, steps)
    share = along / (steps[line] - 1)
    hit = _hit(blocked, ends[line, 0] + way[line] * share[:, None])
    return [int(n) for n in np.unique(line[hit])]

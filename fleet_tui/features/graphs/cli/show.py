"""The `graph show` command: the graph in braille, over its map."""

import os
import sys
from collections.abc import Callable

from fleet_tui.features.graphs.cli.answers import GraphAnswers, graph_counts, load
from fleet_tui.features.graphs.cli.map_image import map_grid
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.graphs.document import DocumentFloor, of_floor
from fleet_tui.model.graphs.live import role_of
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.ui.view.map.area import worth_seeing
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.layer_stack import backdrop
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Scene, SceneVertex

SIZE = 80, 24
"""Columns and lines without a terminal."""
SMALLEST = 20, 8
MARGIN = 1.0
"""Metres around the graph."""
FAR = 1e6
"""Metres beyond which a vertex is not drawn."""


def show(
    say: Callable[[str], None], file: str, map_file: str | None, wanted: str | None, answers: GraphAnswers
) -> int:
    """Print each floor, a line of counts above it. Raises GraphError, MapError."""
    read, _ = load(file, wanted, answers)
    grid = map_grid(map_file, read.document) if map_file else None
    width, height = _size()
    for floor in read.document.floors.values():
        head = f"{floor.name}: {graph_counts(of_floor(floor)).removeprefix('1 floor, ')}"
        say(fit(head, width).rstrip())
        say(floor_picture(floor, grid, width, height - 1, _drawing()))
    return 0


def _size() -> tuple[int, int]:
    """Return the columns and lines of the terminal that is written to; a line is left for the prompt."""
    if not sys.stdout.isatty():
        return SIZE
    columns, lines = os.get_terminal_size(sys.stdout.fileno())
    return max(columns, SMALLEST[0]), max(lines - 1, SMALLEST[1])


def _drawing() -> Drawing:
    encoding = (sys.stdout.encoding or "").lower().replace("-", "")
    return Drawing.BRAILLE if encoding.startswith("utf") else Drawing.ASCII


def floor_picture(
    floor: DocumentFloor, grid: OccupancyGrid | None, width: int, height: int, drawing: Drawing
) -> str:
    """Return the picture of a floor as lines of text."""
    scene = _scene(floor, grid)
    camera = Camera.fit((scene.frame.width, scene.frame.height), width, height, worth_seeing(scene, ()))
    cells = backdrop(scene, camera, MapOptions(drawing, edges=True))
    return "\n".join(line.rstrip() for line in cells.text().splitlines())


def _scene(floor: DocumentFloor, grid: OccupancyGrid | None) -> Scene:
    places = {
        id_: (one.x, one.y) for id_, one in floor.vertices.items() if abs(one.x) < FAR and abs(one.y) < FAR
    }
    vertices = tuple(
        SceneVertex(id_, *place, role_of(floor.vertices[id_].type), sanitize(floor.vertices[id_].label))
        for id_, place in places.items()
    )
    drawn = [edge for edge in floor.edges.values() if edge.start in places and edge.end in places]
    lines = {edge.id: (*places[edge.start], *places[edge.end]) for edge in drawn}
    frame = grid.frame if grid is not None else _frame(list(places.values()))
    return Scene(
        floor.name,
        frame,
        grid,
        vertices,
        tuple(lines.values()),
        one_way=tuple(lines[edge.id] for edge in drawn if not edge.two_way),
    )


def _frame(places: list[tuple[float, float]]) -> MapFrame:
    """Return a frame around the vertices of at most some thousand pixels."""
    places = places or [(0.0, 0.0)]
    left, low = min(x for x, _ in places) - MARGIN, min(y for _, y in places) - MARGIN
    width, height = max(x for x, _ in places) + MARGIN - left, max(y for _, y in places) + MARGIN - low
    resolution = max(width, height) / 2000
    return MapFrame(
        resolution, max(1, round(width / resolution)), max(1, round(height / resolution)), Pose(left, low)
    )

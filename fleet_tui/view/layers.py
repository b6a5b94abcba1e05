"""The map's layers, one function each, drawn in the order of the lists in `picture`."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.geometry import MapFrame
from fleet_tui.view.camera import DOTS_X, DOTS_Y, Camera
from fleet_tui.view.cells import Cells
from fleet_tui.view.glyphs import robot_glyph, robot_inks, robot_tag, vertex_glyph
from fleet_tui.view.labels import Room
from fleet_tui.view.raster import BRAILLE, Drawing, ground, pack
from fleet_tui.view.roles import Ink
from fleet_tui.view.scene import Scene, SceneRobot, SceneVertex
from fleet_tui.view.text import visible

Points = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Look:
    """What the operator chose to see. cursor: the map pixel (column, row) of the map's cursor."""

    drawing: Drawing = Drawing.BRAILLE
    edges: bool = False
    labels: bool = True
    cursor: tuple[float, float] | None = None

    @property
    def plain(self) -> bool:
        """Whether only ASCII may be used."""
        return self.drawing is Drawing.ASCII


def draw_ground(cells: Cells, scene: Scene, camera: Camera, look: Look) -> None:
    """The occupancy map, over everything that was there."""
    below = ground(scene.grid, camera, look.drawing)
    cells.codes[:] = below.codes
    cells.inks[:] = below.inks


def draw_edges(cells: Cells, scene: Scene, camera: Camera, look: Look) -> None:
    """The route graph's edges as thin lines that leave every wall visible."""
    if not (look.edges and scene.edges):
        return
    ends = np.array(scene.edges, np.float64)
    left, top = camera.origin
    corner = np.array([left * DOTS_X, top * DOTS_Y])
    starts, stops = (
        pixels(scene.frame, points) / camera.scale - corner for points in (ends[:, :2], ends[:, 2:])
    )
    mask = np.zeros((camera.height * DOTS_Y, camera.width * DOTS_X), np.bool_)
    _trace(mask, starts, stops)
    bits = pack(mask)
    free = (bits > 0) & (cells.inks != Ink.WALL) & (cells.inks != Ink.WALL_BEYOND)
    cells.codes[free] = ord("+") if look.plain else BRAILLE[bits[free]]
    cells.inks[free] = Ink.EDGE


def _trace(mask: NDArray[np.bool_], starts: Points, stops: Points) -> None:
    """Set the dots (x, y) along each line, after cutting the lines to the mask."""
    low, high = _within(mask.shape, starts, stops)
    way = stops - starts
    seen = (low < high) & np.isfinite(way).all(axis=1)
    starts, way, low, high = starts[seen], way[seen], low[seen], high[seen]
    steps = (np.abs(way).max(axis=1) * (high - low)).astype(np.intp) + 2
    line = np.repeat(np.arange(len(steps)), steps)
    along = np.arange(len(line)) - np.repeat(np.cumsum(steps) - steps, steps)
    share = low[line] + (high - low)[line] * along / (steps[line] - 1)
    dots = np.floor(starts[line] + way[line] * share[:, None]).astype(np.intp)
    rows, columns = mask.shape
    inside = (dots >= 0).all(axis=1) & (dots[:, 0] < columns) & (dots[:, 1] < rows)
    mask[dots[inside, 1], dots[inside, 0]] = True


def _within(shape: tuple[int, ...], starts: Points, stops: Points) -> tuple[Points, Points]:
    """From which to which share of its length each line is inside the mask (Liang-Barsky)."""
    size = np.array([shape[1], shape[0]], np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        one, other = -starts / (stops - starts), (size - starts) / (stops - starts)
    # A line along an axis divides by zero: +-inf outside, nan exactly on the border (taken as inside).
    low = np.nan_to_num(np.minimum(one, other), nan=-np.inf, neginf=-np.inf, posinf=np.inf)
    high = np.nan_to_num(np.maximum(one, other), nan=np.inf, neginf=-np.inf, posinf=np.inf)
    return np.maximum(low.max(axis=1), 0.0), np.minimum(high.min(axis=1), 1.0)


def draw_vertices(cells: Cells, scene: Scene, camera: Camera, look: Look) -> None:
    """The vertices by role, the important ones over the others."""
    placed = seen_vertices(scene, camera)
    for vertex, (x, y) in sorted(placed, key=lambda at: vertex_glyph(at[0], look.plain)[1]):
        glyph, ink = vertex_glyph(vertex, look.plain)
        cells.write(x, y, glyph, Ink.TARGET if vertex.id in scene.target_vertices else ink)


def draw_labels(cells: Cells, scene: Scene, camera: Camera, look: Look) -> None:
    """Labels where there is room for the whole of them: the mission's first, then by vertex id."""
    if not look.labels:
        return
    placed = seen_vertices(scene, camera)
    room = Room(camera.width, camera.height)
    for vertex, (x, y) in placed:
        if vertex.role.value != "plain" or vertex.label:
            room.take(x, y, 1)
    targets = scene.target_vertices
    labelled = [at for at in placed if at[0].label]
    for vertex, (x, y) in sorted(labelled, key=lambda at: (at[0].id not in targets, at[0].id)):
        text = visible(vertex.label)
        if look.plain:
            text = text.encode("ascii", "replace").decode()
        spot = room.label_spot(x, y, text, cells.inks)
        if spot:
            cells.write(*spot, text, Ink.TARGET if vertex.id in targets else Ink.LABEL)


def draw_robots(cells: Cells, scene: Scene, camera: Camera, look: Look) -> None:
    """Every robot as an arrow with its number beside it, the selected one last and so on top."""
    turned = scene.frame.origin.yaw
    placed = _seen_robots(scene, camera)
    heads = {at for _, at in placed}
    glyphs = {}  # of two robots in one cell the later one is seen
    room = Room(camera.width, camera.height)
    for robot, (x, y) in placed:
        glyph = robot_glyph(robot, turned, look.plain)
        glyphs[x, y] = (glyph[:1] if (x + 1, y) in heads else glyph), robot_inks(robot)[0]
    for at, (glyph, _) in glyphs.items():
        room.take(*at, len(glyph))
    for robot, (x, y) in reversed(placed):
        tag = robot_tag(robot, look.plain)
        spot = room.tag_spot(x, y, len(glyphs[x, y][0]), len(tag))
        cells.write(*spot, tag, robot_inks(robot)[1])
    for at, (glyph, ink) in glyphs.items():
        cells.write(*at, glyph, ink)


def _seen_robots(scene: Scene, camera: Camera) -> list[tuple[SceneRobot, tuple[int, int]]]:
    """The robots in the view with their cells; the selected one comes last."""
    found = []
    for robot in sorted(scene.robots, key=lambda robot: (robot.selected, -robot.number)):
        pixel = scene.frame.to_pixel(robot.pose.x, robot.pose.y)
        if all(map(math.isfinite, pixel)):
            x, y = camera.to_cell(*pixel)
            if camera.shows(x, y):
                found.append((robot, (x, y)))
    return found


def draw_cursor(cells: Cells, scene: Scene, camera: Camera, look: Look) -> None:
    """The map's cursor: the cell's own character, marked."""
    if look.cursor is None:
        return
    x, y = camera.to_cell(*look.cursor)
    if camera.shows(x, y):
        cells.inks[y, x] = Ink.CURSOR


def seen_vertices(scene: Scene, camera: Camera) -> list[tuple[SceneVertex, tuple[int, int]]]:
    """The vertices in the view, each with its cell (x, y)."""
    if not scene.vertices:
        return []
    points = np.array([(vertex.x, vertex.y) for vertex in scene.vertices])
    with np.errstate(invalid="ignore"):
        dots = pixels(scene.frame, points) / camera.scale
        places = np.floor(dots / (DOTS_X, DOTS_Y)) - camera.origin
        inside = ((places >= 0) & (places < (camera.width, camera.height))).all(axis=1)
    seen: Sequence[int] = np.flatnonzero(inside).tolist()
    cells = places[inside].astype(np.intp).tolist()
    return [(scene.vertices[i], (x, y)) for i, (x, y) in zip(seen, cells, strict=True)]


def pixels(frame: MapFrame, points: Points) -> Points:
    """World metres (n x 2) to map pixels (column, row), as `MapFrame.to_pixel` does for one."""
    # Robots send what they like: infinities become "not in the view".
    zero, right, up = (np.array(frame.to_pixel(*p)) for p in ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)))
    with np.errstate(invalid="ignore", over="ignore"):
        return np.asarray(points @ np.array([right - zero, up - zero]) + zero, np.float64)

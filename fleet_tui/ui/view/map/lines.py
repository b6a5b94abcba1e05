"""The layers made of lines and dots: edges, the remaining mission."""

import math

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.geometry import Line
from fleet_tui.ui.view.map.camera import DOTS_X, DOTS_Y, Camera
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.map.tracing import BRAILLE, Mask, blank_mask, ends_of, pack, thicken, trace, within
from fleet_tui.ui.view.roles import LABELS, WALLS, StyleRole

OFF_EDGE = 1.0
"""Metres from which a robot is off its edge."""
_ARROW_ROOM = 8.0  # visible dots of an edge below which it has no arrow head
_NEXT = ":"
"""The next orders' way in ASCII."""
_ARROWS = ("▸▴◂▾", ">^<v")  # east first, counter-clockwise; the second in ASCII


def _table(*roles: StyleRole) -> NDArray[np.bool_]:
    found = np.zeros(len(StyleRole), np.bool_)
    found[list(roles)] = True
    return found


_GROUND = _table(StyleRole.FLOOR, StyleRole.UNKNOWN)
_OPEN = _table(StyleRole.FLOOR, StyleRole.UNKNOWN, StyleRole.EDGE, StyleRole.TRAIL, StyleRole.TRAIL_OLD)
_WAYS = (StyleRole.MISSION, StyleRole.MISSION_NEXT)
_KEPT = _table(StyleRole.MISSION_NEXT, StyleRole.MISSION)
_WALLS = _table(*WALLS, StyleRole.MISSION_NEXT_THROUGH, StyleRole.MISSION_THROUGH)
_THROUGH = {
    StyleRole.MISSION_NEXT: StyleRole.MISSION_NEXT_THROUGH,
    StyleRole.MISSION: StyleRole.MISSION_THROUGH,
}


def draw_edges(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the route graph's edges as thin lines that leave every wall visible."""
    if not (look.edges and scene.edges):
        return
    mask = blank_mask(camera)
    trace(mask, *ends_of(scene, camera, scene.edges))
    bits = pack(mask)
    free = (bits > 0) & _GROUND[cells.roles]
    cells.codes[free] = ord("+") if look.plain else BRAILLE[bits[free]]
    cells.roles[free] = StyleRole.EDGE
    if scene.one_way:
        _point(cells, scene, camera, look)


@np.errstate(divide="ignore", invalid="ignore", over="ignore")
def _point(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw an arrow head in the middle of the visible part of each one-way edge, if it fits."""
    starts, stops = ends_of(scene, camera, scene.one_way)
    low, high = within((camera.height * DOTS_Y, camera.width * DOTS_X), starts, stops)
    way = stops - starts
    seen = (np.abs(way).max(axis=1) * (high - low) >= _ARROW_ROOM) & np.isfinite(way).all(axis=1)
    middles = (starts + way * ((low + high) / 2)[:, None])[seen]
    quarters = np.rint(np.arctan2(-way[seen, 1], way[seen, 0]) / (np.pi / 2)).astype(np.intp) % 4
    arrows = _ARROWS[look.plain]
    for (x, y), quarter in zip((middles // (DOTS_X, DOTS_Y)).astype(np.intp), quarters, strict=True):
        if camera.shows(x, y) and cells.roles[y, x] == StyleRole.EDGE:
            cells.write(int(x), int(y), arrows[quarter], StyleRole.EDGE)


def draw_closed(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw a cross in the middle of each closed edge."""
    _mark(cells, scene, camera, scene.closed, "X" if look.plain else "✕")


def draw_deadlocks(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the next edges of robots that wait for each other, dashed: that is what their poses tell."""
    if not scene.deadlocked:
        return
    mask = blank_mask(camera)
    trace(mask, *ends_of(scene, camera, scene.deadlocked), dashed=True)
    _alarm(cells, pack(mask), look)


def draw_blocked(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the edges on which a robot is in the way, over the mission, each with a sign in its middle."""
    if not scene.blocked:
        return
    _, bits = _thick(scene, camera, scene.blocked)
    _alarm(cells, bits, look)
    _mark(cells, scene, camera, scene.blocked, "!")


def _alarm(cells: Cells, bits: NDArray[np.uint8], look: MapOptions) -> None:
    """Draw dots over open ground and the mission."""
    drawn = (bits > 0) & (_OPEN | _KEPT)[cells.roles]
    cells.codes[drawn] = ord("x") if look.plain else BRAILLE[bits[drawn]]
    cells.roles[drawn] = StyleRole.ALARM


def _mark(cells: Cells, scene: Scene, camera: Camera, edges: tuple[Line, ...], sign: str) -> None:
    """Draw a sign in the middle of each edge, in no label."""
    for x0, y0, x1, y1 in edges:
        x, y = camera.to_cell(*scene.frame.to_pixel((x0 + x1) / 2, (y0 + y1) / 2))
        if camera.shows(x, y) and cells.roles[y, x] not in LABELS:
            cells.write(x, y, sign, StyleRole.ALARM)


def draw_mission(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the selected robot's remaining way: of the current order thick, of the next ones dashed."""
    if scene.mission is None:
        return
    if scene.mission.following:
        mask = blank_mask(camera)
        trace(mask, *ends_of(scene, camera, scene.mission.following), dashed=True)
        stroke(cells, mask, StyleRole.MISSION_NEXT, look, _NEXT)
    if scene.mission.current:
        _draw_way(cells, scene, camera, look, scene.mission.current)


def _draw_way(
    cells: Cells, scene: Scene, camera: Camera, look: MapOptions, lines: tuple[Line, ...], done: float = 0.0
) -> None:
    """Draw lines thick, to differ from an edge without colour, too."""
    mask, thick = _thick(scene, camera, lines, done)
    stroke(cells, mask, StyleRole.MISSION, look, "*", thick)


@np.errstate(invalid="ignore", over="ignore")
def _thick(
    scene: Scene, camera: Camera, lines: tuple[Line, ...], done: float = 0.0
) -> tuple[Mask, NDArray[np.uint8]]:
    """Return the dots of lines, and the same lines wider, as bits."""
    starts, stops = ends_of(scene, camera, lines)
    along = np.abs(stops - starts).min(axis=1) < 1.0
    mask, straight = blank_mask(camera), blank_mask(camera)
    trace(mask, starts, stops, done=done)
    trace(straight, starts[along], stops[along], done=done)
    return mask, thicken(mask, straight)


def draw_approach(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the first piece of that way, the rest of the edge that the selected robot is on.

    While it is near the edge, the edge's own dots: they don't jitter with the pose.
    """
    robot = scene.selected
    if scene.mission is None or scene.mission.edge is None or robot is None:
        return
    x, y, to_x, to_y = edge = scene.mission.edge
    pose, along = robot.pose, (to_x - x, to_y - y)
    ahead = (pose.x - x) * along[0] + (pose.y - y) * along[1]
    square = along[0] * along[0] + along[1] * along[1]  # ** would raise on a vertex at 1e300
    done = min(max(ahead / max(square, 1e-12), 0.0), 1.0)
    if math.dist((pose.x, pose.y), (x + done * along[0], y + done * along[1])) > OFF_EDGE:
        edge, done = (pose.x, pose.y, to_x, to_y), 0.0
    _draw_way(cells, scene, camera, look, (edge,), done)


def stroke(
    cells: Cells,
    mask: Mask,
    role: StyleRole,
    look: MapOptions,
    plain: str,
    thick: NDArray[np.uint8] | None = None,
) -> None:
    """Draw the dots in one role except over more important cells; as ASCII the character `plain`. `thick`:
    the same lines wider, as bits.

    A mission goes on through walls, on their colour.
    """
    passed = pack(mask)
    bits = passed if thick is None or look.plain else thick
    drawn = (bits > 0) & _OPEN[cells.roles]
    if role in _WAYS:
        crossed = (passed > 0) & _KEPT[cells.roles]
        dotted = crossed & (cells.codes >= BRAILLE[1]) & (cells.codes <= BRAILLE[-1])
        cells.codes[dotted] |= bits[dotted]
        cells.codes[crossed & (cells.codes == ord(_NEXT))] = ord(plain)
        cells.roles[crossed] = role
        through = (passed > 0) & _WALLS[cells.roles]
        cells.codes[through] = ord(plain) if look.plain else BRAILLE[bits[through]]
        cells.roles[through] = _THROUGH[role]
    cells.codes[drawn] = ord(plain) if look.plain else BRAILLE[bits[drawn]]
    cells.roles[drawn] = role

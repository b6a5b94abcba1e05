"""The layers of streams: the laser scan and the planned path of the selected robot."""

import numpy as np

from fleet_tui.model.set_up.streams import placed
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.scene import Scene
from fleet_tui.view.map.tracing import BRAILLE, blank_mask, dots_of, pack, set_dots, trace
from fleet_tui.view.roles import WALLS, StyleRole


def draw_path(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the planned path, on free ground and over edges."""
    if scene.path is None or len(scene.path) < 2:
        return
    dots = dots_of(scene, camera, np.asarray(scene.path, np.float64))
    # One point for each cell: a path has thousands.
    moved = np.any(np.diff(np.floor(dots), axis=0) != 0, axis=1)
    dots = dots[np.concatenate(([True], moved))]
    mask = blank_mask(camera)
    trace(mask, dots[:-1], dots[1:])
    bits = pack(mask)
    free = (bits > 0) & (cells.roles <= StyleRole.MISSION_NEXT)
    free &= ~np.isin(cells.roles, WALLS)
    cells.codes[free] = ord(":") if look.plain else BRAILLE[bits[free]]
    cells.roles[free] = StyleRole.MISSION_NEXT


def draw_scan(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the ends of the laser's beams, dim if their place is not certain. On a wall of the map, where they
    are to be, its own blocks take their colour: so it still reads as a wall."""
    if scene.beams is None or scene.beams_at is None:
        return
    points = placed(scene.beams, scene.beams_at)
    mask = blank_mask(camera)
    set_dots(mask, dots_of(scene, camera, np.asarray(points, np.float64)))
    bits = pack(mask)
    drawn = (bits > 0) & (cells.roles < StyleRole.VERTEX_LABELLED)
    off_wall = drawn & ~np.isin(cells.roles, WALLS)
    cells.codes[off_wall] = ord("%") if look.plain else BRAILLE[bits[off_wall]]
    cells.roles[drawn] = StyleRole.TRAIL if scene.beams_are_old else StyleRole.SCAN

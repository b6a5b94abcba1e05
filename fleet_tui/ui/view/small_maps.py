"""Small maps of the floors that the map does not show, for screens with space left."""

from collections.abc import Sequence
from dataclasses import replace

from msgspec.structs import replace as with_floor

from fleet_tui.model.fleet import FleetState
from fleet_tui.text.language import counted, tr, translate
from fleet_tui.text.sanitize import cell_width
from fleet_tui.ui.view.layout import USUAL_SHAPE
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.selection import Selection

LEAST_WIDTH = 30
LEAST_HEIGHT = 9
"""Cells and lines of a small map in which its floor is recognised."""
CAPTION_GAPS = 6
"""Cells of a caption around the floor and its robots."""


def other_floors(state: FleetState, selection: Selection) -> list[Scene]:
    """Return the scenes of all floors but the shown one."""
    names = [name for name in state.floors if name != selection.floor]
    return [floor_scene(state, with_floor(selection, floor=name)) for name in names]


def _robots(scene: Scene, width: int) -> str:
    """Return the names of the robots on a floor, their number if that is too long for a caption."""
    names, count = ", ".join(robot.name for robot in scene.robots), len(scene.robots)
    if cell_width(names) > width - cell_width(scene.floor) - CAPTION_GAPS:
        return translate(counted("{count} robot", "{count} robots", count))
    return names or tr("no robot")


def grid_of(count: int, width: int, height: int) -> tuple[int, int]:
    """Return the columns and rows in which `count` floors are shown largest: fewer places than floors if
    there is no space for all of them."""
    most = max(1, min(count, (width // LEAST_WIDTH) * (height // LEAST_HEIGHT)))
    grids = [(columns, -(-most // columns)) for columns in range(1, most + 1)]
    return max(grids, key=lambda one: min(width // one[0] * USUAL_SHAPE, height // one[1]))


class SmallMaps:
    """The pictures of several floors as one, each below a caption with its robots. A floor keeps its place
    while the same floor is shown on the map."""

    def __init__(self) -> None:
        self._pictures: dict[str, MapPicture] = {}
        self._scenes: Sequence[Scene] = ()
        self._options = MapOptions()

    def show(self, scenes: Sequence[Scene], options: MapOptions) -> None:
        """Take the newest scenes, and the options of the map."""
        self._scenes = scenes
        self._options = options

    def cells(self, width: int, height: int) -> Cells | None:
        """Return all of them in this many cells, None without a floor or space."""
        if not self._scenes or width < 1 or height < 1:
            return None
        whole = Cells.blank(width, height, StyleRole.TEXT)
        columns, rows = grid_of(len(self._scenes), width, height)
        across, down = width // columns, height // rows
        for place, scene in enumerate(self._scenes[: columns * rows]):
            x, y = place % columns * across, place // columns * down
            # Between two of them is a gap; at the screen's edge a name would seem to be cut.
            part = self._cells_of(scene, across - 1, down)
            if part is not None:
                inside = slice(y, y + part.codes.shape[0]), slice(x, x + part.codes.shape[1])
                whole.codes[inside], whole.roles[inside] = part.codes, part.roles
        return whole

    def _cells_of(self, scene: Scene, width: int, height: int) -> Cells | None:
        """Return the picture of a floor: without a map of its ground, of its edges."""
        picture = self._pictures.setdefault(scene.floor, MapPicture())
        edges = self._options.edges or scene.grid is None
        picture.options = replace(self._options, edges=edges, trails=False, cursor=None, pointed=None)
        picture.show(replace(scene, elsewhere="").with_note(_robots(scene, width)))
        return picture.cells(width, height, focused=False)

    def floor_at(self, x: int, y: int, width: int, height: int) -> str:
        """Return the floor at a cell of the picture of this size, empty for none."""
        columns, rows = grid_of(len(self._scenes), width, height)
        column, row = x // (width // columns), y // (height // rows)
        place = row * columns + column
        is_inside = column < columns and row < rows and place < len(self._scenes)
        return self._scenes[place].floor if is_inside else ""

"""The map's layers, one function each, drawn in the order of the lists in `picture`."""

from dataclasses import dataclass

from fleet_tui.model.graph import Role
from fleet_tui.model.order import natural
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.map.camera import Camera
from fleet_tui.view.map.cells import Cells
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.map.glyphs import vertex_glyph
from fleet_tui.view.map.labels import CellOccupancy, Label, draw_label
from fleet_tui.view.map.places import seen_vertices
from fleet_tui.view.map.raster import ground
from fleet_tui.view.map.scene import Scene, SceneVertex
from fleet_tui.view.roles import StyleRole


@dataclass(frozen=True, slots=True)
class MapOptions:
    """The operator's options for the map. cursor: place of the map's cursor, x, y in metres; pointed: the id
    of the vertex under it; hatched: mark unknown ground, where colours don't show it."""

    drawing: Drawing = Drawing.BRAILLE
    edges: bool = False
    labels: bool = True
    trails: bool = False
    cursor: tuple[float, float] | None = None
    pointed: str | None = None
    hatched: bool = False

    @property
    def plain(self) -> bool:
        """Tell whether only ASCII may be used."""
        return self.drawing is Drawing.ASCII


def draw_ground(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the occupancy map, over the previous content."""
    below = ground(scene.grid, camera, look.drawing, look.hatched)
    cells.codes[:] = below.codes
    cells.roles[:] = below.roles


def draw_vertices(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the vertices by role, the important ones over the others. On the current way a plain one is part
    of the line."""
    placed = seen_vertices(scene, camera)
    for vertex, (x, y) in sorted(placed, key=lambda at: vertex_glyph(at[0], look.plain)[1]):
        glyph, role = vertex_glyph(vertex, look.plain)
        if role is StyleRole.VERTEX and cells.roles[y, x] in (StyleRole.MISSION, StyleRole.MISSION_THROUGH):
            glyph, role = ("*" if look.plain else "•"), StyleRole.MISSION
        cells.write(x, y, glyph, StyleRole.TARGET if vertex.id in scene.target_vertices else role)


def draw_labels(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> tuple[Label, ...]:
    """Draw and return the labels that fit whole, so more of them the closer the zoom.

    First the mission's ends, then the vertex under the cursor, elevators and docking stations, the others;
    equals by vertex id. The order is the same at every zoom: a label stays when zooming in, unless an earlier
    one now fits there.
    """
    if not look.labels:
        return ()
    placed = seen_vertices(scene, camera)
    occupancy = CellOccupancy(camera.width, camera.height)
    for vertex, (x, y) in placed:
        if vertex.role is not Role.PLAIN or vertex.label:
            occupancy.take(x, y, 1)
    targets = scene.target_vertices
    labelled = [at for at in placed if at[0].label]
    drawn: list[Label] = []
    for vertex, (x, y) in sorted(labelled, key=lambda at: _rank(at[0], targets, look)):
        text = sanitize(vertex.label)
        if look.plain:
            text = text.encode("ascii", "replace").decode()
        spot = occupancy.label_spot(x, y, text, cells.roles)
        if spot:
            drawn.append(Label((x, y), spot, text, vertex.id in targets))
            draw_label(cells, drawn[-1])
    return tuple(drawn)


def _rank(vertex: SceneVertex, targets: tuple[str, ...], look: MapOptions) -> tuple[bool, bool, bool, object]:
    """Return the sort key of a label, the smallest first."""
    return vertex.id not in targets, vertex.id != look.pointed, vertex.role is Role.PLAIN, natural(vertex.id)


def draw_cursor(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the map's cursor: the cell's own character, marked."""
    if look.cursor is None:
        return
    x, y = camera.to_cell(*scene.frame.to_pixel(*look.cursor))
    if camera.shows(x, y):
        cells.roles[y, x] = StyleRole.CURSOR

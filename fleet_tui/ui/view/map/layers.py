"""The map's layers, one function each, drawn in the order of the lists in `picture`."""

from collections.abc import Container
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from fleet_tui.model.by_identity import Same
from fleet_tui.model.graph import Role
from fleet_tui.model.order import natural
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.map.camera import Camera
from fleet_tui.ui.view.map.cells import Cells, Roles
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.glyphs import vertex_glyph
from fleet_tui.ui.view.map.ground.raster import ground
from fleet_tui.ui.view.map.places import Place, cells_of_vertices
from fleet_tui.ui.view.map.placing.labels import Label, draw_label
from fleet_tui.ui.view.map.placing.occupancy import CellOccupancy
from fleet_tui.ui.view.map.scene import Scene, SceneVertex
from fleet_tui.ui.view.map.tracing import pixels_of
from fleet_tui.ui.view.roles import StyleRole

CELLS_OF_LABEL = 48
"""Cells of the view for each label that is tried: more would fill it, and take long."""
CELLS_OF_FEW = 45
"""Cells of the view for each label from which one rather covers walls than is left out."""


@dataclass(frozen=True, slots=True)
class MapOptions:
    """The operator's options for the map. cursor: place of the map's cursor, x, y in metres; pointed: the id
    of the vertex under it; hatched: mark unknown ground, where colours don't show it; edges: None shows them
    where no map is known."""

    drawing: Drawing = Drawing.BRAILLE
    edges: bool | None = None
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
    ways = pixels_of(scene, scene.edges) if scene.edges else None
    below = ground(scene.grid, camera, look.drawing, look.hatched, ways)
    cells.codes[:] = below.codes
    cells.roles[:] = below.roles


def draw_vertices(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the vertices by role, the important ones over the others. On the current way a plain one is part
    of the line."""
    indices, places = cells_of_vertices(scene, camera)
    all_codes, all_roles = _glyphs(Same(scene.vertices), look.plain)
    order = np.argsort(all_roles[indices], kind="stable")
    indices, (x, y) = indices[order], places[order].T
    codes, roles = all_codes[indices], all_roles[indices]
    below = cells.roles[y, x]
    on_way = (below == StyleRole.MISSION) | (below == StyleRole.MISSION_THROUGH)
    on_way &= roles == StyleRole.VERTEX
    codes[on_way], roles[on_way] = ord("*" if look.plain else "•"), StyleRole.MISSION
    if look.edges:
        # Who looks at edges looks at what they join.
        bare = roles == StyleRole.VERTEX
        codes[bare], roles[bare] = ord("*" if look.plain else "•"), StyleRole.VERTEX_LABELLED
    if targets := scene.target_vertices:
        roles[[scene.vertices[i].id in targets for i in indices.tolist()]] = StyleRole.TARGET
    cells.codes[y, x], cells.roles[y, x] = codes, roles


@lru_cache(maxsize=4)
def _glyphs(
    vertices: Same[tuple[SceneVertex, ...]], plain: bool
) -> tuple[NDArray[np.uint32], NDArray[np.uint8]]:
    """Return the code points and roles of vertices."""
    bare, labelled = (vertex_glyph(Role.PLAIN, is_labelled, plain) for is_labelled in (False, True))
    glyphs = [
        vertex_glyph(vertex.role, bool(vertex.label), plain)
        if vertex.role is not Role.PLAIN
        else (labelled if vertex.label else bare)  # most of them are: no look into the cache for each
        for vertex in vertices.value
    ]
    return np.array([ord(glyph) for glyph, _ in glyphs], np.uint32), np.array(
        [role for _, role in glyphs], np.uint8
    )


def draw_labels(
    cells: Cells, scene: Scene, camera: Camera, look: MapOptions, quiet: Roles
) -> tuple[Label, ...]:
    """Draw and return the labels that fit whole, so more of them the closer the zoom. `quiet`: the picture
    without missions but with all edges, along which they lead: no label moves with the selection.

    First elevators and docking stations, then the others; equals by vertex id. The order is the same at every
    zoom: a label stays when zooming in, unless an earlier one now fits there. Only where the mission's ends
    or the vertex under the cursor would have none they are first.
    """
    if not look.labels:
        return ()
    indices, places = cells_of_vertices(scene, camera)
    ranked, is_marked = _ranks(Same(scene.vertices))
    at = dict(zip(indices.tolist(), places.tolist(), strict=True))
    labelled = [(scene.vertices[i], at[i]) for i in ranked if i in at]
    wanted = {*scene.target_vertices, look.pointed}
    asked = sum(vertex.id in wanted for vertex, _ in labelled)
    marks = places[is_marked[indices]].tolist()
    drawn = _placed(labelled, wanted, marks, camera, look, quiet)
    if sum(vertex.id in wanted for vertex, _ in drawn) < asked:
        labelled.sort(key=lambda seen: seen[0].id not in wanted)
        drawn = _placed(labelled, wanted, marks, camera, look, quiet)
    labels = tuple(label._replace(is_target=one.id in scene.target_vertices) for one, label in drawn)
    for label in labels:
        draw_label(cells, label)
    return labels


def _placed(
    labelled: list[tuple[SceneVertex, Place]],
    wanted: Container[str | None],
    marks: list[Place],
    camera: Camera,
    look: MapOptions,
    quiet: Roles,
) -> list[tuple[SceneVertex, Label]]:
    """Return the labels that find a place, in their order, none over the `marks` of vertices. Among many only
    those of the `wanted` vertices cover walls."""
    occupancy = CellOccupancy(camera.width, camera.height)
    for x, y in marks:
        occupancy.take(x, y, 1)
    found = []
    are_few = len(labelled) * CELLS_OF_FEW <= camera.width * camera.height
    for vertex, (x, y) in labelled[: camera.width * camera.height // CELLS_OF_LABEL + 1]:
        text = sanitize(vertex.label)
        if look.plain:
            text = text.encode("ascii", "replace").decode()
        covers_walls = are_few or vertex.id in wanted
        spot = occupancy.label_spot(x, y, text, quiet, covers_walls)
        if spot:
            found.append((vertex, Label((x, y), spot, text, False, covers_walls)))
    return found


@lru_cache(maxsize=4)
def _ranks(vertices: Same[tuple[SceneVertex, ...]]) -> tuple[tuple[int, ...], NDArray[np.bool_]]:
    """Return the indices of labelled vertices in the order of their labels, and the vertices that no label
    may cover."""
    plain = Role.PLAIN
    labelled = [i for i, vertex in enumerate(vertices.value) if vertex.label]
    labelled.sort(key=lambda i: (vertices.value[i].role is plain, natural(vertices.value[i].id)))
    marked = [bool(vertex.label) or vertex.role is not plain for vertex in vertices.value]
    return tuple(labelled), np.array(marked, np.bool_)


def draw_cursor(cells: Cells, scene: Scene, camera: Camera, look: MapOptions) -> None:
    """Draw the map's cursor: the cell's own character, marked."""
    if look.cursor is None:
        return
    x, y = camera.to_cell(*scene.frame.to_pixel(*look.cursor))
    if camera.shows(x, y):
        cells.roles[y, x] = StyleRole.CURSOR

"""The map mode of the graph editor: a draft in place of the live graph, and a cursor."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from fleet_tui.model.geometry import Line
from fleet_tui.model.graph import Role
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex
from fleet_tui.model.graphs.draft import Change
from fleet_tui.model.graphs.live import role_of
from fleet_tui.text.language import EMPTY, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.map.layer_stack import Layer
from fleet_tui.ui.view.map.layers import draw_cursor
from fleet_tui.ui.view.map.modes.mode import place_text
from fleet_tui.ui.view.map.places import seen_vertices
from fleet_tui.ui.view.map.scene import Mission, Scene, SceneVertex
from fleet_tui.ui.view.map.viewport import Point, Viewport

NEAR = 1.0
"""Cells within which an edge is picked."""


class EditMode:
    """Shows a draft; arrows move the cursor by cells. `selected` and `edge` are the ids of the selected
    vertex or edge, empty for none; `held`: the selected vertex moves to the next place."""

    layers: tuple[Layer, ...] = (draw_cursor,)
    points = False

    def __init__(self, floor: DocumentFloor, cursor: Point, roles: Callable[[str], Role] = role_of) -> None:
        self.cursor = cursor
        self.note = EMPTY
        self._roles = roles
        self._made = dict[str, SceneVertex]()
        self._lines = dict[str, Line]()
        self._arrows = dict[str, Line]()
        """The lines of edges that lead one way."""
        self._changed = set[str]()
        """Edges that were drawn, turned or moved since the mode was entered."""
        self.selected = self.edge = ""
        self.held = False
        self._grasped = ""
        self.show(floor)

    def show(self, floor: DocumentFloor, change: Change | None = None) -> None:
        """Show the draft as it is now, after a change if that was all; a selected element that is gone is not
        selected any more."""
        self.floor = floor
        self.selected = self.selected if self.selected in floor.vertices else ""
        self.edge = self.edge if self.edge in floor.edges else ""
        self.held = self.held and bool(self.selected)
        if change is None:
            self._made = {id_: self._shown(vertex) for id_, vertex in floor.vertices.items()}
            self._lines = {}
            self._arrows = {}
            for id_ in floor.edges:
                self._renew_edge(id_)
        else:
            self._renew(change)
        self._vertices, self._edges = tuple(self._made.values()), tuple(self._lines.values())
        self._drawn = tuple(self._lines[id_] for id_ in self._changed if id_ in self._lines)
        self._one_way = tuple(self._arrows.values())

    def _renew(self, change: Change) -> None:
        """Renew the changed elements: of thousands one or two."""
        floor = self.floor
        touched = {one.id for pair in change.vertices for one in pair if one is not None}
        edges = {one.id for pair in change.edges for one in pair if one is not None}
        if touched & self._made.keys():
            edges.update(
                id_ for id_, one in floor.edges.items() if one.start in touched or one.end in touched
            )
        self._changed |= edges
        for id_ in touched:
            self._made.pop(id_, None)
            if id_ in floor.vertices:
                self._made[id_] = self._shown(floor.vertices[id_])
        for id_ in edges:
            self._renew_edge(id_)

    def _renew_edge(self, id_: str) -> None:
        self._lines.pop(id_, None)
        self._arrows.pop(id_, None)
        edge = self.floor.edges.get(id_)
        if edge is not None and (line := self._line(edge)):
            self._lines[id_] = line
            if not edge.two_way:
                self._arrows[id_] = line

    def _shown(self, vertex: DocumentVertex) -> SceneVertex:
        return SceneVertex(vertex.id, vertex.x, vertex.y, self._roles(vertex.type), sanitize(vertex.label))

    def _line(self, edge: DocumentEdge) -> Line | None:
        """Return the line of an edge, None if one of its vertices is unknown."""
        start, end = self.floor.vertices.get(edge.start), self.floor.vertices.get(edge.end)
        return None if start is None or end is None else (start.x, start.y, end.x, end.y)

    def banner(self, shown: str) -> str:
        """Return the cursor's place, the counts, and the distance from the selected vertex."""
        place = place_text(tr("EDIT"), self.floor.name, shown, self.cursor)
        text = " ".join(filter(None, (place, translate(self.note))))
        if self.selected:
            vertex = self.floor.vertices[self.selected]
            away = math.dist((vertex.x, vertex.y), self.cursor)
            name = sanitize(vertex.label or vertex.id)
            does = tr("moving") if self.held else tr("from")
            text += f", {does} {name} {away:.1f} m"
        return text

    def adjusted(self, scene: Scene) -> Scene:
        """Return the scene with the draft's graph, the selected edge as a way, and those that were drawn or
        moved as the next one; other floors as they are."""
        if scene.floor != self.floor.name:
            return scene
        chosen_edge = (self._lines[self.edge],) if self.edge in self._lines else ()
        way = Mission(chosen_edge, self._drawn) if chosen_edge or self._drawn else None
        chosen = (self.selected,) if self.selected else ()
        return replace(
            scene,
            vertices=self._vertices,
            edges=self._edges,
            one_way=self._one_way,
            mission=way,
            target_vertices=chosen,
        )

    def move(self, view: Viewport, scene: Scene, dx: int, dy: int) -> None:
        """Move the cursor; at the edge the view moves with it."""
        self.cursor = view.stepped(scene, self.cursor, dx, dy)

    def pick(self, view: Viewport, scene: Scene) -> None:
        """Pick nothing: the editor's own key selects."""

    def press(self, view: Viewport, scene: Scene, at: Point) -> bool:
        """Take a press of the mouse at a place: the vertex there is grasped."""
        self._grasped = ""
        if scene.floor != self.floor.name:
            return False
        self.cursor = at
        self._grasped = self.vertex_at(view, scene, at)
        return bool(self._grasped)

    def drag(self, at: Point) -> None:
        """Move the grasped vertex along."""
        if self._grasped in self.floor.vertices:
            self.cursor = at
            self.selected = self._grasped
            self.edge = ""
            self.held = True

    def vertex_at(self, view: Viewport, scene: Scene, at: Point) -> str:
        """Return the id of the vertex in the cell of a place, the nearest one; empty without one."""
        camera = view.camera(scene)
        cell = camera.to_cell(*scene.frame.to_pixel(*at))
        here = [vertex for vertex, place in seen_vertices(self.adjusted(scene), camera) if place == cell]
        nearest = min(here, key=lambda vertex: math.dist((vertex.x, vertex.y), at), default=None)
        return nearest.id if nearest is not None else ""

    def edge_at(self, view: Viewport, scene: Scene, at: Point) -> str:
        """Return the id of the edge nearest to a place, empty if none is near."""
        if not self._edges:
            return ""
        lines, place = np.array(self._edges, np.float64), np.array(at)
        start, way = lines[:, :2], lines[:, 2:] - lines[:, :2]
        length = np.maximum((way**2).sum(axis=1), 1e-12)
        along = np.clip(((place - start) * way).sum(axis=1) / length, 0.0, 1.0)
        away = np.hypot(*(start + way * along[:, None] - place).T)
        nearest = int(np.argmin(away))
        return list(self._lines)[nearest] if away[nearest] <= NEAR * cell_metres(view, scene) else ""


def cell_metres(view: Viewport, scene: Scene) -> float:
    """Return the metres that a cell is high, twice its width."""
    camera = view.camera(scene)
    return math.dist(*(scene.frame.to_world(*camera.to_pixel(0, row)) for row in (0, 1)))

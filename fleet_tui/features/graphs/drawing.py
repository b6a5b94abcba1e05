"""Drawing in the graph editor: vertices and edges at the cursor."""

import math
from functools import partial

from msgspec.structs import replace

from fleet_tui.features.graphs.edge_values import COST, SPEED, EdgeValues, values_text
from fleet_tui.features.graphs.edit_mode import EditMode, cell_metres
from fleet_tui.features.graphs.editor import GraphEditor
from fleet_tui.features.graphs.rules import edits
from fleet_tui.features.graphs.values import HEADING, VertexValues
from fleet_tui.model.graphs.document import DocumentVertex
from fleet_tui.model.graphs.draft import GraphDraft
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Entry
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.map.viewport import Point

OLD_POSE = 1.0
"""Seconds from which a pose is too old to place a vertex at."""


class GraphDrawing:
    """Turns keys and the mouse into steps of the draft."""

    def __init__(
        self, console: Console, editor: GraphEditor, values: VertexValues, edge_values: EdgeValues
    ) -> None:
        self._console = console
        self._notices = console.notices
        self._editor = editor
        self._values = values
        self._edge_values = edge_values

    def _at_cursor(self, mode: EditMode, scene: Scene) -> str:
        return mode.vertex_at(self._editor.picture.viewport, scene, mode.cursor)

    def _taken(self, draft: GraphDraft, mode: EditMode, scene: Scene) -> str:
        """Return the vertex at the cursor, or where it would be put in line, empty for none."""
        there = edits.vertex_there(draft.floor, *self._place(draft, mode, scene))
        return self._at_cursor(mode, scene) or there

    def _place(self, draft: GraphDraft, mode: EditMode, scene: Scene) -> Point:
        """Return the cursor's place, in line with near vertices or on the grid."""
        near = cell_metres(self._editor.picture.viewport, scene) / 2
        return edits.snapped(draft.floor, *mode.cursor, near)

    def add_at_cursor(self) -> None:
        """Add a vertex at the cursor, and select it; one that is there already is selected."""
        if opened := self._editor.opened:
            draft, mode, scene = opened
            if taken := self._taken(draft, mode, scene):
                mode.selected = taken
                mode.edge = ""
                self._editor.refresh()
                self._notices.say(
                    Message("selected vertex {taken}: zoom in to place another here", taken=sanitize(taken))
                )
                return
            self._add(draft, mode, self._place(draft, mode, scene))

    def add_at_robot(self) -> None:
        """Add a vertex at the selected robot's pose, with its heading."""
        opened, robot = self._editor.opened, self._console.store.state.robots[self._console.navigation.robot]
        if opened is None:
            return
        draft, mode, _ = opened
        pose = robot.pose
        if pose is None or robot.floor != draft.floor.name:
            self._notices.say(
                Message("{name} has no pose on {floor}", name=robot.name, floor=sanitize(draft.floor.name))
            )
        elif self._console.store.state.now - pose.at > OLD_POSE:
            self._notices.say(Message("the pose of {name} is old: not used", name=robot.name))
        else:
            x, y = round(pose.value.x, 3), round(pose.value.y, 3)
            self._add(draft, mode, (x, y), round(pose.value.yaw, 4))

    def _add(self, draft: GraphDraft, mode: EditMode, at: Point, heading: float | None = None) -> None:
        vertex = DocumentVertex(next(draft.free_ids()), *at, heading=heading)
        self._editor.do(edits.added(vertex))
        mode.cursor = at
        mode.selected = vertex.id
        mode.edge = ""
        self._editor.refresh()

    def connect(self) -> None:
        """Add an edge from the selected vertex to the one at the cursor, which is made if none is there; then
        that is selected, so that a way is drawn by cursor and key alone."""
        opened = self._editor.opened
        if opened is None:
            return
        draft, mode, scene = opened
        if not mode.selected:
            self._notices.say(Message("select the vertex that the edge begins at: cursor on it, Enter"))
            return
        end, new = self._taken(draft, mode, scene), None
        ids = draft.free_ids()
        if not end:
            end = next(ids)
            new = edits.added(DocumentVertex(end, *self._place(draft, mode, scene)))
        if end == mode.selected:
            self._notices.say(Message("move the cursor to the vertex that the edge ends at"))
            return
        there = edits.edge_between(draft.floor, mode.selected, end)
        if there is not None:
            self._notices.say(
                Message("edge {id} joins them already: Enter on it, d turns it", id=sanitize(there.id))
            )
            return
        edge = edits.connected(next(ids), next(ids), mode.selected, end)
        self._editor.do(edge if new is None else edits.joined(new, edge))
        mode.selected = end
        self._editor.refresh()

    def select(self) -> None:
        """Put down the held vertex; else select the element at the cursor, or open its menu if it is
        selected."""
        opened = self._editor.opened
        if opened is None:
            return
        draft, mode, scene = opened
        if mode.held:
            self._put_down(draft, mode, scene)
            return
        vertex = self._at_cursor(mode, scene)
        edge = "" if vertex else mode.edge_at(self._editor.picture.viewport, scene, mode.cursor)
        if (vertex or edge) and (vertex, edge) == (mode.selected, mode.edge):
            self._menu(draft, mode)
            return
        mode.selected = vertex
        mode.edge = edge
        if not (vertex or edge):
            self._notices.say(Message("nothing here: i adds a vertex"))
        self._editor.refresh()

    def clicked(self, dragged: bool) -> None:
        """Put down what the mouse dragged, or select what it clicked at."""
        opened = self._editor.opened
        if opened is not None and (opened[1].held or not dragged):
            self.select()

    def _menu(self, draft: GraphDraft, mode: EditMode) -> None:
        """List the actions on the selected element."""
        if mode.edge:
            edge = draft.floor.edges[mode.edge]
            ways = Message("both ways") if edge.two_way else Message("one way")
            told = Message(
                "{start} -> {end}, {ways}, {values_text}",
                start=edge.start,
                end=edge.end,
                ways=ways,
                values_text=values_text(edge),
            )
            entries: list[Entry] = [
                (Message("Direction (d)"), self.turn),
                (Message("Speed"), partial(self._console.begin, f"{SPEED} ")),
                (Message("Cost"), partial(self._console.begin, f"{COST} ")),
                (Message("Remove (x)"), self.remove),
            ]
            self._console.open_menu(sanitize(Message("edge {id}: {facts}", id=edge.id, facts=told)), entries)
            return
        vertex = draft.floor.vertices[mode.selected]
        heading = (
            "any"
            if vertex.heading is None
            else Message("{degrees} degrees", degrees=f"{math.degrees(vertex.heading):.0f}")
        )
        told = Message(
            "{label}, type {type}, heading {heading}",
            label=vertex.label or "no label",
            type=vertex.type or "none",
            heading=heading,
        )
        self._console.open_menu(
            sanitize(
                Message(
                    "vertex {id} at {x}, {y} m: {facts}",
                    id=vertex.id,
                    x=f"{vertex.x:.2f}",
                    y=f"{vertex.y:.2f}",
                    facts=told,
                )
            ),
            [
                (Message("Label (n)"), self._values.name),
                (Message("Type (t)"), self._values.choose_type),
                (Message("Heading"), partial(self._console.begin, f"{HEADING} ")),
                (Message("Move (m)"), self.hold),
                (Message("Remove (x)"), self.remove),
            ],
        )

    def _put_down(self, draft: GraphDraft, mode: EditMode, scene: Scene) -> None:
        vertex = draft.floor.vertices[mode.selected]
        others = replace(
            draft.floor, vertices={k: v for k, v in draft.floor.vertices.items() if k != vertex.id}
        )
        near = cell_metres(self._editor.picture.viewport, scene) / 2
        x, y = edits.snapped(others, *mode.cursor, near)
        if there := edits.vertex_there(others, x, y):
            self._notices.say(Message("vertex {there} is there already", there=sanitize(there)))
            return
        mode.held = False
        self._editor.do(edits.renewed(vertex, replace(vertex, x=x, y=y)))

    def hold(self) -> None:
        """Pick up the selected vertex, or the one at the cursor."""
        if (opened := self._editor.opened) and (vertex := self._values.chosen()):
            _, mode, _ = opened
            mode.selected = vertex.id
            mode.edge = ""
            mode.held = True
            self._notices.say(Message("move the cursor, then Enter puts it down; Esc puts it back"))
            self._editor.refresh()

    def remove(self) -> None:
        """Remove the selected edge or vertex, or the vertex at the cursor."""
        if opened := self._editor.opened:
            draft, mode, _ = opened
            if mode.edge:
                self._editor.do(edits.edge_removed(draft.floor.edges[mode.edge]))
            elif vertex := self._values.chosen():
                self._editor.do(edits.removed(draft.floor, vertex.id))

    def turn(self) -> None:
        """Give the selected edge, or the one at the cursor, its next direction."""
        if edge := self._edge_values.chosen():
            self._editor.do(edits.turned(edge))

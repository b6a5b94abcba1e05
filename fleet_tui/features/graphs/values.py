"""The label, type and heading of the selected vertex in the graph editor."""

import math
from functools import partial

from msgspec.structs import replace

from fleet_tui.features.graphs.editor import GraphEditor
from fleet_tui.features.graphs.rules import edits
from fleet_tui.model.graphs.document import DocumentVertex
from fleet_tui.text.language import Message, verbatim
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Entry, Typed

NAME = "name"
TYPE = "type"
HEADING = "heading"
"""First words of typed lines on the selected vertex."""
USUAL_TYPES = ("docking_station", "elevator")
"""Types offered where no vertex has one."""


class VertexValues:
    """Chosen from a menu, or typed into the palette."""

    def __init__(self, console: Console, editor: GraphEditor) -> None:
        self._console = console
        self._editor = editor

    def chosen(self) -> DocumentVertex | None:
        """Return the selected vertex, else select and return the one at the cursor; say so if there is
        none."""
        opened = self._editor.opened
        if opened is None:
            return None
        draft, mode, scene = opened
        id_ = mode.selected or mode.vertex_at(self._editor.picture.viewport, scene, mode.cursor)
        if not id_:
            self._console.notices.say(Message("no vertex is selected: cursor on it, Enter"))
            return None
        mode.selected = id_
        mode.edge = ""
        return draft.floor.vertices[id_]

    def choose_type(self) -> None:
        """List the types of vertices; the last entry is typed."""
        opened, vertex = self._editor.opened, self.chosen()
        if opened is not None and vertex is not None:
            used = {one.type for one in opened[0].floor.vertices.values() if one.type}
            types = sorted(used) or USUAL_TYPES
            entries: list[Entry] = [(Message("none"), partial(self._renew, type_=""))]
            entries += [(verbatim(type_), partial(self._renew, type_=type_)) for type_ in types]
            entries.append((Message("another one: type it"), partial(self._console.begin, f"{TYPE} ")))
            self._console.open_menu(
                Message("Type of vertex {id}", id=sanitize(vertex.id)), entries, searched=True
            )

    def name(self) -> None:
        """Type the label of the selected vertex."""
        if vertex := self.chosen():
            self._console.begin(f"{NAME} {vertex.label}")

    def _renew(self, label: str | None = None, type_: str | None = None) -> None:
        if vertex := self.chosen():
            after = vertex
            after = after if label is None else replace(after, label=label)
            after = after if type_ is None else replace(after, type=type_)
            self._editor.do(edits.renewed(vertex, after))

    def _face(self, degrees: float | None) -> None:
        if vertex := self.chosen():
            yaw = None if degrees is None else math.remainder(math.radians(degrees), math.tau)
            self._editor.do(edits.renewed(vertex, replace(vertex, heading=yaw)))

    def typed(self, line: str) -> Typed | None:
        """Parse a typed line as a label, type or heading of the selected vertex; None for any other."""
        word, _, rest = line.strip().partition(" ")
        if not self._editor.is_open or word not in (NAME, TYPE, HEADING):
            return None
        text = rest.strip()
        if word == NAME:
            said = (
                Message("Label of the vertex: {text}", text=sanitize(text))
                if text
                else Message("Remove the vertex's label")
            )
            return Typed([(said, partial(self._renew, label=text))])
        if word == TYPE:
            return Typed(
                [
                    (
                        Message("Type of the vertex: {text}", text=sanitize(text) or "none"),
                        partial(self._renew, type_=text),
                    )
                ]
            )
        try:
            degrees = float(text) if text and text != "any" else None
        except ValueError:
            degrees = math.nan
        if degrees is not None and not math.isfinite(degrees):
            return Typed(problem=Message("heading in degrees, counter-clockwise from the x axis, or: any"))
        shown = Message("any") if degrees is None else Message("{degrees} degrees", degrees=f"{degrees:g}")
        return Typed([(Message("Heading at the vertex: {shown}", shown=shown), partial(self._face, degrees))])

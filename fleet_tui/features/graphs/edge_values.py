"""The speed and cost of the selected edge in the graph editor."""

import math
from functools import partial

from msgspec.structs import replace

from fleet_tui.features.graphs.editor import GraphEditor
from fleet_tui.features.graphs.rules import edits
from fleet_tui.model.graphs.document import DocumentEdge
from fleet_tui.text.language import Message
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.typed import Typed

SPEED = "speed"
COST = "cost"
"""First words of typed lines on the selected edge, and names of its values."""
_EXPECTED = {SPEED: Message("speed in m/s, above 0, or: any"), COST: Message("cost, 0 or more, or: any")}


class EdgeValues:
    """Typed into the palette."""

    def __init__(self, console: Console, editor: GraphEditor) -> None:
        self._notices = console.notices
        self._editor = editor

    def chosen(self) -> DocumentEdge | None:
        """Return the selected edge, else select and return the one at the cursor; say so if there is none."""
        opened = self._editor.opened
        if opened is None:
            return None
        draft, mode, scene = opened
        id_ = mode.edge or mode.edge_at(self._editor.picture.viewport, scene, mode.cursor)
        if not id_:
            self._notices.say(Message("no edge is selected: cursor on it, Enter"))
            return None
        mode.edge = id_
        mode.selected = ""
        return draft.floor.edges[id_]

    def typed(self, line: str) -> Typed | None:
        """Parse a typed line as the speed or cost of the selected edge; None for any other."""
        word, _, rest = line.strip().partition(" ")
        if not self._editor.is_open or word not in _EXPECTED:
            return None
        text = rest.strip()
        try:
            value = float(text) if text and text != "any" else None
        except ValueError:
            value = math.nan
        if value is not None and not (0 < value < math.inf or (word == COST and value == 0)):
            return Typed(problem=_EXPECTED[word])
        return Typed(
            [(Message("Edge: {shown}", shown=_shown(word, value)), partial(self._renew, word, value))]
        )

    def _renew(self, word: str, value: float | None) -> None:
        if edge := self.chosen():
            after = replace(edge, **{word: value})
            self._editor.do(edits.edge_renewed(edge, after, _shown(word, value)))


def values_text(edge: DocumentEdge) -> str:
    """Return the values of an edge in words."""
    return ", ".join(_shown(word, getattr(edge, word)) for word in _EXPECTED)


def _shown(word: str, value: float | None) -> Message:
    unit = " m/s" if word == SPEED else ""
    return (
        Message("{attribute} any", attribute=word)
        if value is None
        else Message("{attribute} {value}{unit}", attribute=word, value=f"{value:g}", unit=unit)
    )

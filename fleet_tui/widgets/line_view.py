"""One line of text that is always visible."""

from collections.abc import Sequence

from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Run, cut, width_of
from fleet_tui.widgets.ink_view import InkView


class LineView(InkView):
    """Shows runs at the left and others at the right. If both don't fit, the left stays whole, or with
    `keep_right` the right."""

    DEFAULT_CSS = "LineView { height: 1; }"

    def __init__(self, *, id: str, keep_right: bool = False) -> None:
        super().__init__(id=id)
        self._keep_right = keep_right

    def show(self, left: Sequence[Run], right: Sequence[Run] = ()) -> None:
        """Show these runs."""
        width, at_right = self.size.width, width_of(right)
        if width < 1:
            return
        if self._keep_right:
            left = cut(left, max(0, width - at_right - 1))
        gap = width - width_of(left) - at_right
        if gap > 0:
            left = [*left, (" " * gap, StyleRole.TEXT), *right]
        self.paint_rows([cut(left, width)])

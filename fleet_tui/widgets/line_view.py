"""One line of text that is always in view."""

from collections.abc import Sequence

from fleet_tui.view.cells import Cells
from fleet_tui.view.roles import Ink
from fleet_tui.view.table import Run, cut, width_of
from fleet_tui.widgets.cells_view import CellsView


def write_runs(cells: Cells, x: int, y: int, runs: Sequence[Run]) -> int:
    """Put runs into row y from cell x; returns the cell after the last."""
    width = cells.codes.shape[1]
    if x + width_of(runs) > width:
        runs = cut(runs, max(0, width - x))
    for text, ink in runs:
        cells.write(x, y, text, ink)
        x += width_of([(text, ink)])
    return x


class LineView(CellsView):
    """Shows runs at the left and others at the right. Where both don't fit, the left stays whole,
    or with `keep_right` the right."""

    DEFAULT_CSS = "LineView { height: 1; }"

    def __init__(self, *, id: str, keep_right: bool = False) -> None:
        super().__init__(id=id)
        self._keep_right = keep_right

    def show(self, left: Sequence[Run], right: Sequence[Run] = ()) -> None:
        """Show these."""
        width = self.size.width
        if width < 1:
            return
        cells = Cells.blank(width, 1, Ink.TEXT)
        if self._keep_right:
            left = cut(left, max(0, width - width_of(right) - 1))
        end = write_runs(cells, 0, 0, left)
        if end + width_of(right) < width:
            write_runs(cells, width - width_of(right), 0, right)
        self.paint(cells)

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
    """Shows runs at the left and, where there is room, others at the right."""

    DEFAULT_CSS = "LineView { height: 1; }"

    def show(self, left: Sequence[Run], right: Sequence[Run] = ()) -> None:
        """Show these; what doesn't fit at the right is left out."""
        width = self.size.width
        if width < 1:
            return
        cells = Cells.blank(width, 1, Ink.TEXT)
        end = write_runs(cells, 0, 0, left)
        if end + width_of(right) < width:
            write_runs(cells, width - width_of(right), 0, right)
        self.paint(cells)

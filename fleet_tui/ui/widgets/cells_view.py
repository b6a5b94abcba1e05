"""A widget that shows a picture in cells and sends only the changes to the terminal."""

from collections.abc import Mapping

from rich.style import Style
from textual.geometry import Region
from textual.strip import Strip

from fleet_tui.ui.terminal.cell_strip import CellStrip
from fleet_tui.ui.view.map.cells import Cells
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.widgets.runs_view import RunsView


class CellsView(RunsView):
    """Paints `Cells`: cell (0, 0) is the widget's upper left corner."""

    def __init__(self, styles: Mapping[StyleRole, Style] | None = None, *, id: str | None = None) -> None:
        super().__init__(styles, id=id)
        self.painted: Cells | None = None

    def paint(self, cells: Cells) -> None:
        """Show `cells`, which must not be changed any more. Only the differences are sent."""
        changes = cells.changes(self.painted)
        self.painted = cells
        self._renew([y for y, _, _ in changes], len(cells.codes))
        if changes:
            self.refresh(*(Region(x, y, end - x, 1) for y, x, end in changes))

    def _strip(self, y: int) -> Strip:
        assert self.painted is not None
        return CellStrip(self.painted, y, self._styles)

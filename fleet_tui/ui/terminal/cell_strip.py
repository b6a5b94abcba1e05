"""A row of cells as a Textual strip."""

from collections.abc import Sequence
from typing import Any

from rich.segment import Segment
from rich.style import Style
from textual.strip import Strip

from fleet_tui.ui.terminal.row_strip import RowStrip
from fleet_tui.ui.view.map.cells import Cells, Codes, Roles


class CellStrip(RowStrip):
    """Row y of a picture, with a style for the number of each role.

    It is cut into segments only on demand, as for a menu over it: on the way to the screen buffer it stays
    two rows of numbers.
    """

    def __init__(self, cells: Cells, y: int, styles: Sequence[Style]) -> None:
        # The base is initialised by __getattr__: its seven caches cost more than the rest.
        self._cells = cells
        self._y = y
        self._cell_length = cells.codes.shape[1]
        self.codes: Codes = cells.codes[y]
        self.roles: Roles = cells.roles[y]
        self.styles = styles

    def __getattr__(self, name: str) -> Any:
        """Initialise the ordinary strip on the first access to any part of it."""
        if name not in Strip.__slots__:
            raise AttributeError(name)
        segments = [Segment(text, self.styles[role]) for text, role in self._cells.runs(self._y)]
        super().__init__(segments, self._cell_length)
        return getattr(self, name)

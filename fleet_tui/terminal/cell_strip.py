"""A row of cells as a strip of Textual's."""

from collections.abc import Sequence
from typing import Any

from rich.segment import Segment
from rich.style import Style
from textual.strip import Strip

from fleet_tui.terminal.row_strip import RowStrip
from fleet_tui.view.map.cells import Cells, Codes, Inks


class CellStrip(RowStrip):
    """Row y of a picture, with a style for each ink's number.

    It is cut into segments only where somebody asks for them, as where a menu lies over it: on the way
    to the glass it stays the two rows of numbers that it is.
    """

    def __init__(self, cells: Cells, y: int, styles: Sequence[Style]) -> None:
        # The base is initialised by __getattr__: its seven caches cost more than all the rest.
        self._cells, self._y = cells, y
        self._cell_length = cells.codes.shape[1]
        self.codes: Codes = cells.codes[y]
        self.inks: Inks = cells.inks[y]
        self.styles = styles

    def __getattr__(self, name: str) -> Any:
        """Return what makes an ordinary strip, from the first time that some of it is looked for."""
        if name not in Strip.__slots__:
            raise AttributeError(name)
        segments = [Segment(text, self.styles[ink]) for text, ink in self._cells.runs(self._y)]
        super().__init__(segments, self._cell_length)
        return getattr(self, name)

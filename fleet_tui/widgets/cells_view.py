"""A widget that shows a picture in cells and sends only what changed to the terminal."""

from collections.abc import Mapping
from typing import ClassVar

from rich.segment import Segment
from rich.style import Style
from textual.geometry import Region
from textual.strip import Strip
from textual.widget import Widget

from fleet_tui.view.cells import Cells
from fleet_tui.view.roles import Ink


class CellsView(Widget):
    """Paints `Cells`. It has no border or padding: cell (0, 0) is the widget's upper left corner."""

    ALLOW_SELECT: ClassVar[bool] = False
    """Dragging means something else here."""

    def __init__(self, inks: Mapping[Ink, Style] | None = None, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._styles = _by_number(inks or {})
        self._painted: Cells | None = None
        self._strips: list[Strip] = []

    def set_inks(self, styles: Mapping[Ink, Style]) -> None:
        """Change the theme: every ink's style, at once."""
        self._styles = _by_number(styles)
        if self._painted is not None:
            self._strips = [self._strip(self._painted, y) for y in range(len(self._strips))]
            self.refresh()

    def paint(self, cells: Cells) -> None:
        """Show `cells`, which are not changed any more. Only what differs from before is sent."""
        changes = cells.changes(self._painted)
        if len(cells.codes) != len(self._strips):
            self._strips = [Strip([])] * len(cells.codes)
        for y, _, _ in changes:
            self._strips[y] = self._strip(cells, y)
        self._painted = cells
        if changes:
            self.refresh(*(Region(x, y, end - x, 1) for y, x, end in changes))

    def _strip(self, cells: Cells, y: int) -> Strip:
        styles = self._styles
        return Strip([Segment(text, styles[ink]) for text, ink in cells.runs(y)], cells.codes.shape[1])

    def render_line(self, y: int) -> Strip:
        """One row, whole."""
        return self._strips[y] if y < len(self._strips) else Strip.blank(self.size.width)

    def render_lines(self, crop: Region) -> list[Strip]:
        """The rows as they are kept: past the cache that would wrap each of them anew."""
        return [self.render_line(y).crop(crop.x, crop.right) for y in range(crop.y, crop.bottom)]


def _by_number(styles: Mapping[Ink, Style]) -> list[Style]:
    return [styles.get(ink, Style.null()) for ink in Ink]

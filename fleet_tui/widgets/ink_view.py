"""A widget that shows rows of runs and sends only the rows that changed to the terminal."""

from collections.abc import Mapping, Sequence
from typing import ClassVar

from rich.segment import Segment
from rich.style import Style
from textual.geometry import Region
from textual.strip import Strip
from textual.widget import Widget

from fleet_tui.view.roles import Ink

Run = tuple[str, int]
"""Text and the ink (an `Ink` or its number) that all of it has."""


class InkView(Widget):
    """Paints rows of runs. It has no border or padding: the first run begins in the widget's corner."""

    ALLOW_SELECT: ClassVar[bool] = False
    """Dragging means something else here."""

    def __init__(self, inks: Mapping[Ink, Style] | None = None, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._styles = _by_number(inks or {})
        self._rows: list[Sequence[Run]] = []
        self._strips: list[Strip] = []
        self._width: int | None = None  # cells of every row, where it need not be measured

    def set_inks(self, styles: Mapping[Ink, Style]) -> None:
        """Change the theme: every ink's style, at once."""
        self._styles = _by_number(styles)
        self._strips = [self._strip(row) for row in self._rows]
        self.refresh()

    def paint_rows(self, rows: Sequence[Sequence[Run]]) -> None:
        """Show `rows`, each as wide as the widget."""
        before = self._rows if len(self._rows) == len(rows) else [()] * len(rows)
        changed = [y for y, row in enumerate(rows) if row != before[y]]
        self._put({y: rows[y] for y in changed}, len(rows))
        if changed:
            width = self.size.width
            self.refresh(*(Region(0, y, width, 1) for y in changed))

    def _put(self, rows: Mapping[int, Sequence[Run]], height: int) -> None:
        """Keep these rows; those that are not among them stay, if the height does."""
        if height != len(self._rows):
            self._rows = [()] * height
            self._strips = [Strip([])] * height
        for y, row in rows.items():
            self._rows[y], self._strips[y] = row, self._strip(row)

    def _strip(self, row: Sequence[Run]) -> Strip:
        styles = self._styles
        return Strip([Segment(text, styles[ink]) for text, ink in row], self._width)

    def render_line(self, y: int) -> Strip:
        """One row, whole."""
        return self._strips[y] if y < len(self._strips) else Strip.blank(self.size.width)

    def render_lines(self, crop: Region) -> list[Strip]:
        """The rows as they are kept: past the cache that would wrap each of them anew."""
        return [self.render_line(y).crop(crop.x, crop.right) for y in range(crop.y, crop.bottom)]


def _by_number(styles: Mapping[Ink, Style]) -> list[Style]:
    return [styles.get(ink, Style.null()) for ink in Ink]

"""A widget that shows rows of runs and sends only the changed rows to the terminal."""

from collections.abc import Iterable, Mapping, Sequence
from typing import ClassVar

from rich.segment import Segment
from rich.style import Style
from textual.geometry import Region, Size
from textual.strip import Strip
from textual.widget import Widget

from fleet_tui.ui.terminal.row_strip import RowStrip
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.listing import BOTH, CURSOR
from fleet_tui.ui.view.tables.table import Run, width_of

CURSORS = (CURSOR, BOTH)


class RunsView(Widget):
    """Paints rows of runs. It has no border or padding: the first run begins in the widget's corner."""

    ALLOW_SELECT: ClassVar[bool] = False
    """Disables text selection: dragging has another use here."""
    marks_cursor = False
    """The row of the cursor has its own ground without the focus, too."""

    def __init__(self, styles: Mapping[StyleRole, Style] | None = None, *, id: str | None = None) -> None:
        super().__init__(id=id)
        self._styles = _by_number(styles or {})
        self._cursor_styles = _by_number({})
        self._rows: Sequence[Sequence[Run]] = []
        self.strips: list[Strip] = []

    @property
    def size(self) -> Size:
        """Return its cells. Textual looks up border, padding and scrollbars each time: it has none."""
        return self.region.size

    def set_role_styles(self, styles: Mapping[StyleRole, Style]) -> None:
        """Change the theme: the style of every role, at once."""
        ground = Style(bgcolor=styles.get(StyleRole.CURSOR_ROW, Style.null()).bgcolor)
        self._styles = _by_number(styles)
        self._cursor_styles = [style + ground for style in self._styles]
        self.strips = [self._strip(y) for y in range(len(self.strips))]
        self.refresh()

    def paint_rows(self, rows: Sequence[Sequence[Run]]) -> None:
        """Show `rows`, each as wide as the widget."""
        before = self._rows if len(self._rows) == len(rows) else [()] * len(rows)
        changed = [y for y, row in enumerate(rows) if row != before[y]]
        self._rows = rows
        self._renew(changed, len(rows))
        if changed:
            width = self.size.width
            self.refresh(*(Region(0, y, width, 1) for y in changed))

    def _renew(self, changed: Iterable[int], height: int) -> None:
        """Rebuild the strips of these rows; the others stay."""
        if height != len(self.strips):
            self.strips = [Strip([])] * height
        for y in changed:
            self.strips[y] = self._strip(y)

    def _strip(self, y: int) -> Strip:
        row = self._rows[y]
        sign, role = row[0] if row else ("", StyleRole.TEXT)
        has_cursor = sign in CURSORS and (self.marks_cursor or role is StyleRole.ACCENT)
        styles = self._cursor_styles if has_cursor else self._styles
        # Measured here: Rich would cache each of these texts, which are new every second.
        return RowStrip([Segment(text, styles[role]) for text, role in row], width_of(row))

    def render_line(self, y: int) -> Strip:
        """Return one row, whole. Before it is painted it has the background, not the terminal's own."""
        return self.strips[y] if y < len(self.strips) else Strip.blank(self.size.width, self.rich_style)

    def render_lines(self, crop: Region) -> list[Strip]:
        """Return the rows as stored, bypassing the cache that would wrap each of them again."""
        # Textual keeps the list of rows to paint until it renders the widget itself, which never happens.
        self._dirty_regions.clear()
        if crop.x == 0 and crop.size == self.size and crop.height == len(self.strips):
            return self.strips  # all of them, each as wide as the widget
        return [self.render_line(y).crop(crop.x, crop.right) for y in range(crop.y, crop.bottom)]


def _by_number(styles: Mapping[StyleRole, Style]) -> list[Style]:
    return [styles.get(role, Style.null()) for role in StyleRole]

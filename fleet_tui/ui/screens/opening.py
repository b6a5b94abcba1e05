"""The screens before the console: rows, a field for an address, and the keys."""

from collections.abc import Mapping, Sequence

from rich.style import Style
from textual.app import ComposeResult
from textual.screen import Screen

from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.opening import Rows, footer
from fleet_tui.ui.widgets.line_view import LineView
from fleet_tui.ui.widgets.runs_view import RunsView


class RowsScreen(Screen[None]):
    """One page of rows above a footer. Keys belong to the screen: no widget has the focus."""

    AUTO_FOCUS = ""

    DEFAULT_CSS = """
    RowsScreen { layout: vertical; background: $background; }
    RowsScreen #rows { width: 1fr; height: 1fr; }
    RowsScreen Input { border: none; height: 1; }
    """

    def __init__(self, styles: Mapping[StyleRole, Style], keys: Sequence[tuple[str, str]]) -> None:
        super().__init__()
        self._keys = keys
        self.page = RunsView(styles, id="rows")
        self._footer = LineView(id="keys")
        self._footer.set_role_styles(styles)

    def compose(self) -> ComposeResult:
        """Compose the page, and its keys below."""
        yield self.page
        yield self._footer

    def rows(self, width: int, height: int) -> Rows:
        raise NotImplementedError

    def show(self) -> None:
        width, height = self.page.size
        if width and height:
            self.page.paint_rows(self.rows(width, height))
            self._footer.show(footer(self._keys))

    def on_resize(self) -> None:
        """Fill the page at its new size."""
        self.call_after_refresh(self.show)

"""An overlay of several pages: their names, a filter, the rows of the open one, its keys."""

from collections.abc import Callable, Hashable, Mapping

from rich.style import Style
from textual.app import ComposeResult
from textual.containers import Horizontal

from fleet_tui.screens.overlay import Overlay
from fleet_tui.view.roles import StyleRole
from fleet_tui.widgets.filter_field import FilterField
from fleet_tui.widgets.line_view import LineView
from fleet_tui.widgets.rows_pane import RowsPane


class PagedOverlay(Overlay):
    """Its widgets; what they show is made by the overlay itself."""

    def __init__(self, id: str, choose: Callable[[Hashable], object], placeholder: str) -> None:
        """`choose` is called with the key of the row that Enter means."""
        super().__init__(id=id)
        self.rows = RowsPane(id=f"{id}-rows", choose=choose)
        self._field = FilterField(self.rows, id=f"{id}-filter", placeholder=placeholder)
        self.beside = RowsPane(id=f"{id}-beside")
        """Rows of a second page, for an overlay that has space for one."""
        self.beside.can_focus = self.beside.display = False
        self._tabs = LineView(id=f"{id}-pages", keep_right=True)
        self._foot = LineView(id=f"{id}-keys", keep_right=True)

    def compose(self) -> ComposeResult:
        """Compose the pages' names, a field that appears on use, the rows, the keys."""
        yield self._tabs
        yield self._field
        yield Horizontal(self.rows, self.beside, classes="pages")
        yield self._foot

    def set_role_styles(self, styles: Mapping[StyleRole, Style]) -> None:
        """Change every colour."""
        for view in (self._tabs, self.rows, self.beside, self._foot):
            view.set_role_styles(styles)

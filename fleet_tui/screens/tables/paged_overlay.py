"""Overlays over a table: filled while they are open, with a note on the marked row below."""

from collections.abc import Callable, Hashable, Mapping
from functools import partial

from rich.style import Style
from textual.app import ComposeResult
from textual.containers import Horizontal
from textual.timer import Timer
from textual.widget import Widget
from textual.widgets import Static

from fleet_tui.screens.overlay import Overlay
from fleet_tui.view.roles import StyleRole
from fleet_tui.widgets.field import Keys
from fleet_tui.widgets.filter_field import FilterField
from fleet_tui.widgets.line_view import LineView
from fleet_tui.widgets.rows_pane import RowsPane
from fleet_tui.widgets.runs_view import RunsView


class TableOverlay(Overlay):
    """Rows that `look` makes anew every so many seconds; `tick_closed` is called instead while it is closed,
    and tells whether that goes on."""

    def __init__(self, id: str, choose: Callable[[Hashable], object] | None, every: float) -> None:
        """`choose` is called with the key of the row that Enter means."""
        super().__init__(id=id)
        self.rows = RowsPane(id=f"{id}-rows", choose=choose)
        self.refreshing: Timer | None = None
        self._every = every
        self._note = Static(id=f"{id}-note", classes="row-note", markup=False)
        self._noted = ""
        self._views: tuple[RunsView, ...] = (self.rows,)

    def look(self) -> None:
        """Show the newest rows."""
        raise NotImplementedError

    def tick_closed(self) -> bool:
        return False

    def begin(self, first: Widget) -> None:
        """Open it with the focus on `first`, and keep it up to date."""
        self.open(first)
        self.look()
        if self.refreshing is None:
            self.refreshing = self.set_interval(self._every, self.tick)

    def tick(self) -> None:
        """Show the newest rows while it is open."""
        if self.is_open:
            self.look()
        elif not self.tick_closed() and self.refreshing is not None:
            self.refreshing.stop()
            self.refreshing = None

    def note(self, text: str) -> None:
        """Show a text below the rows."""
        if text != self._noted:  # an update lays out the whole screen
            self._noted = text
            self._note.update(text)

    def keys_of_rows(self) -> Keys:
        """Return the keys with which a field that has the focus moves the cursor of the rows."""
        steps = {"up": -1, "down": 1, "pageup": -10, "pagedown": 10}
        return {key: partial(self.rows.move, step) for key, step in steps.items()}

    def action_sort(self) -> None:
        """Sort by the next column that sorts, at last in the table's own order again."""
        self.rows.arrangement.next_column()
        self.look()

    def on_resize(self) -> None:
        """Fill it at its new size."""
        if self.is_open:
            self.look()

    def set_role_styles(self, styles: Mapping[StyleRole, Style]) -> None:
        """Change every colour."""
        for view in self._views:
            view.set_role_styles(styles)


class PagedOverlay(TableOverlay):
    """An overlay of several pages: their names, a filter, the rows of the open one, its keys."""

    def __init__(self, id: str, choose: Callable[[Hashable], object], every: float, placeholder: str) -> None:
        super().__init__(id, choose, every)
        self._field = FilterField(self.rows, id=f"{id}-filter", placeholder=placeholder)
        self.beside = RowsPane(id=f"{id}-beside")
        """Rows of a second page, for an overlay that has space for one."""
        self.beside.can_focus = self.beside.display = False
        self._tabs = LineView(id=f"{id}-pages", keep_right=True)
        self._foot = LineView(id=f"{id}-keys", keep_right=True)
        self._views = (self._tabs, self.rows, self.beside, self._foot)

    def compose(self) -> ComposeResult:
        """Compose the pages' names, a field that appears on use, the rows, the keys."""
        yield self._tabs
        yield self._field
        yield Horizontal(self.rows, self.beside, classes="pages")
        yield self._foot

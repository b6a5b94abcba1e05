"""Overlays over a table: filled while they are open, a filter above, a note on the marked row below."""

from collections.abc import Callable, Hashable, Mapping
from typing import ClassVar

from rich.style import Style
from textual import on
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Horizontal
from textual.timer import Timer
from textual.widget import Widget
from textual.widgets import Input, Static

from fleet_tui.text.language import Message
from fleet_tui.ui.screens.overlay import Overlay
from fleet_tui.ui.screens.tables.copy import copied_rows, copy
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.listing import Listing
from fleet_tui.ui.widgets.bindings import table_bindings
from fleet_tui.ui.widgets.field import Keys
from fleet_tui.ui.widgets.filter_field import FilterField
from fleet_tui.ui.widgets.line_view import LineView
from fleet_tui.ui.widgets.rows_pane import RowsPane
from fleet_tui.ui.widgets.runs_view import RunsView


class TableOverlay(Overlay):
    """Rows that `look` makes anew every so many seconds; `tick_closed` is called instead while it is closed,
    and tells whether that goes on."""

    BINDINGS: ClassVar[list[BindingType]] = table_bindings()

    def __init__(
        self,
        id: str,
        choose: Callable[[Hashable], object] | None,
        every: float,
        say: Callable[[Message], object],
    ) -> None:
        """`choose` is called with the key of the row that Enter means, `say` with the response to a key."""
        super().__init__(id=id, classes="over-table")
        self.rows = RowsPane(id=f"{id}-rows", choose=choose)
        self._list = self.rows.arrangement, self.rows.listing
        self.field = FilterField(self.rows, id=f"{id}-filter", keys=self.field_keys())
        self.refreshing: Timer | None = None
        self._every = every
        self._say = say
        self._note = Static(id=f"{id}-note", classes="row-note", markup=False)
        self._noted = ""
        self._views: tuple[RunsView, ...] = (self.rows,)

    def compose(self) -> ComposeResult:
        """Compose a field that appears on use, the rows, and the whole note of the marked one."""
        yield self.field
        yield self.rows
        yield self._note

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

    @on(Input.Changed)
    def _typed(self, event: Input.Changed) -> None:
        event.stop()
        self.filter(event.value)

    def filter(self, typed: str) -> None:
        self.rows.arrangement.typed = typed
        self.look()

    def put_filter(self, typed: str) -> None:
        """Filter by a text, with the focus on the rows; it is shown by the next look."""
        self.rows.arrangement.typed = typed
        self.field.put(typed)

    def enter_page(self) -> None:
        """Show other rows in the place of the list, with a filter and a cursor of their own."""
        self.rows.arrangement, self.rows.listing = RowArrangement(), Listing()
        self.put_filter("")

    @property
    def is_on_page(self) -> bool:
        return self.rows.listing is not self._list[1]

    def leave_page(self) -> None:
        """Show the list again, as it was."""
        if self.is_on_page:
            self.rows.arrangement, self.rows.listing = self._list
            self.put_filter(self.rows.arrangement.typed)

    def field_keys(self) -> Keys:
        """Return the keys of the field beside those that move the cursor."""
        return {"escape": self.leave_field}

    def leave_field(self) -> None:
        """Clear the filter, with the focus on the rows."""
        self.field.leave(clear=True)

    @property
    def copied(self) -> tuple[str, str]:
        """Return the text to copy, and its description."""
        return copied_rows(self.rows.listing)

    def action_back(self) -> None:
        """Return to the list, else clear the filter, or close."""
        if self.is_on_page:
            self.leave_page()
            self.look()
        elif self.rows.arrangement.typed:
            self.put_filter("")
            self.look()
        else:
            self.action_close()

    def action_filter(self) -> None:
        self.field.begin()

    def action_sort(self) -> None:
        """Sort by the next column that sorts, at last in the table's own order again."""
        self.rows.arrangement.next_column()
        self.look()

    def action_mark(self) -> None:
        """Mark the row to be copied with others, or no longer."""
        self.rows.listing.toggle_mark()
        self.look()

    def action_copy(self) -> None:
        copy(self, *self.copied, self._say)

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

    def __init__(
        self, id: str, choose: Callable[[Hashable], object], every: float, say: Callable[[Message], object]
    ) -> None:
        super().__init__(id, choose, every, say)
        self.beside = RowsPane(id=f"{id}-beside")
        """Rows of a second page, for an overlay that has space for one."""
        self.beside.can_focus = self.beside.display = False
        self._tabs = LineView(id=f"{id}-pages", keep_right=True)
        self._foot = LineView(id=f"{id}-keys", keep_right=True)
        self._views = (self._tabs, self.rows, self.beside, self._foot)

    def compose(self) -> ComposeResult:
        """Compose the pages' names, a field that appears on use, the rows, the keys."""
        yield self._tabs
        yield self.field
        yield Horizontal(self.rows, self.beside, classes="pages")
        yield self._foot

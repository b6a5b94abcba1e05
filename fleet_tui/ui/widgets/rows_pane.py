"""A pane of rows: a title in a rule, a cursor that stays with its row, buttons for the mouse."""

from collections.abc import Callable, Hashable
from functools import partial
from typing import Protocol

from textual import events, on

from fleet_tui.keys import Pane
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.listing import Listing
from fleet_tui.ui.view.tables.table import Table
from fleet_tui.ui.widgets.bindings import bindings
from fleet_tui.ui.widgets.field import Paged, row_keys
from fleet_tui.ui.widgets.messages import ButtonPressed, RowChosen, RowPicked
from fleet_tui.ui.widgets.runs_view import RunsView

ALL = 10**9
"""Rows: more than there are."""


class Scrolled(Paged, Protocol):
    """What the keys of tables move in."""

    def slide(self, step: int) -> None:
        """Slide long rows to the left or right."""

    def open_menu(self) -> None:
        """Open the menu of the cursor's row."""


def row_actions(rows: Scrolled) -> dict[str, Callable[[], None]]:
    """Return the actions of the keys of tables."""
    steps = row_keys(rows)
    return {
        "row_up": steps["up"],
        "row_down": steps["down"],
        "column_left": partial(rows.slide, -1),
        "column_right": partial(rows.slide, 1),
        "page_up": steps["pageup"],
        "page_down": steps["pagedown"],
        "first_row": partial(rows.move, -ALL),
        "last_row": partial(rows.move, ALL),
        "menu": rows.open_menu,
    }


class RowsPane(RunsView, can_focus=True):
    """Shows a Table."""

    BINDINGS = bindings(Pane.ROWS)

    def __init__(self, *, id: str, choose: Callable[[Hashable], object] | None = None) -> None:
        """`choose` is called with the key of the row that Enter means, at once, instead of the message
        RowChosen: for panes whose result gets the next key."""
        super().__init__(id=id)
        self._choose = choose or (lambda key: self.post_message(RowChosen(id, key)))
        self.listing = Listing()
        self.arrangement = RowArrangement()
        # The cursor of the fleet is the selected robot; another one is for keys while it has the focus.
        self.marks_cursor = id == "fleet"

    @property
    def row_width(self) -> int:
        """Return the cells of a row beside the cursor's mark."""
        return max(0, self.size.width - 1)

    def show(self, table: Table, sought: str = "") -> None:
        """Show the newest rows, with the cursor on the one that is sought."""
        self.listing.show(table)
        if sought:
            self.listing.go_to_best(sought)
        self.draw()

    def draw(self) -> None:
        """Paint the visible rows."""
        width, height = self.size
        if width > 0 and height > 0:
            self.paint_rows(self.listing.lines(width, height, self.has_focus))

    def action_key(self, id_: str) -> None:
        """Run the action of a key of tables."""
        row_actions(self)[id_]()

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Leave keys to the screen that are others there, as while a recording is played."""
        return self.screen.check_action(action, parameters)

    @property
    def page(self) -> int:
        return self.listing.page

    def move(self, step: int) -> None:
        """Move the cursor up or down, and report it."""
        if self.listing.move(step):
            self.pick()
            self.draw()

    def pick(self) -> None:
        """Report the row of the cursor, if there is one."""
        if self.listing.cursor is not None:
            self.post_message(RowPicked(self.id or "", self.listing.cursor))

    def slide(self, step: int) -> None:
        """Slide long rows to the left or right."""
        self.listing.slide(step)
        self.draw()

    def open_menu(self) -> None:
        """Request the menu of the cursor's row."""
        if self.listing.cursor is not None:
            self._choose(self.listing.cursor)

    def on_click(self, event: events.Click) -> None:
        """Press a button at the click, else mark the row; a second click opens its menu."""
        event.stop()
        if event.y and not self.listing.shows_row(event.y):
            return
        if event.y:
            self.move(self.listing.steps_to(event.y))
        button = self.listing.button_at(event.x, event.y)
        if button:
            self.post_message(ButtonPressed(self.id or "", button, self.listing.cursor if event.y else None))
        elif event.y and event.chain == 2:
            self.open_menu()

    @on(events.MouseScrollUp)
    @on(events.MouseScrollDown)
    def scroll_rows(self, event: events.MouseScrollUp | events.MouseScrollDown) -> None:
        """Scroll by three rows."""
        event.stop()
        self.move(3 if isinstance(event, events.MouseScrollDown) else -3)

    def on_resize(self) -> None:
        """Paint for the new size."""
        self.draw()

    def watch_has_focus(self, has_focus: bool) -> None:
        """Brighten the title of the focused pane."""
        super().watch_has_focus(has_focus)
        self.draw()

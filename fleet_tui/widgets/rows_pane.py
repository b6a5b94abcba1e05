"""A pane of rows: a title in a rule, a cursor that stays with its row, buttons for the mouse."""

from collections.abc import Hashable

from textual import events
from textual.geometry import Size

from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Button, Row, Run, Table, cut, width_of
from fleet_tui.widgets.bindings import bindings
from fleet_tui.widgets.ink_view import InkView
from fleet_tui.widgets.messages import ButtonPressed, RowChosen, RowPicked

MARK = "▸"
NO_MARK = (" ", StyleRole.TEXT)


class RowsPane(InkView, can_focus=True):
    """Shows a Table. `cursor` is the key of the row that keys and menus mean."""

    BINDINGS = bindings("table")

    def __init__(self, *, id: str, rows: int = 0) -> None:
        """`rows` is how many it would like to show where its height is up to it."""
        super().__init__(id=id)
        self._wanted = rows
        self._table = Table((), ())
        self._top = 0
        self._slid = 0
        self._place = 0
        self.cursor: Hashable | None = None

    @property
    def room(self) -> int:
        """The cells of a row beside the cursor's mark."""
        return max(0, self.size.width - 1)

    def get_content_height(self, container: Size, viewport: Size, width: int) -> int:
        """The rows it would like to show, and its title."""
        return self._wanted + 1

    def show(self, table: Table) -> None:
        """Show the newest rows. If the cursor's row is gone, the one now in its place has it."""
        self._table = table
        keys = table.keys
        if self.cursor in keys:
            self._place = keys.index(self.cursor)
        else:
            self._place = max(0, min(self._place, len(keys) - 1))
            self.cursor = keys[self._place] if keys else None
        self.draw()

    def draw(self) -> None:
        """Paint the rows that are in view."""
        width, height = self.size
        if width < 1 or height < 1:
            return
        self._scroll(height - 1)
        mark = MARK, StyleRole.ACCENT if self.has_focus else StyleRole.DIM
        shown = [
            (mark if row.key == self.cursor else NO_MARK, *_slide(row, self._slid, self.room))
            for row in self._table.rows[self._top : self._top + height - 1]
        ]
        if not shown:
            shown = [cut([NO_MARK, (self._table.empty, StyleRole.DIM)], width)]
        blank = [((" " * width, StyleRole.TEXT),)] * (height - 1 - len(shown))
        self.paint_rows([self._title(width), *shown, *blank][:height])

    def _scroll(self, rows: int) -> None:
        """The cursor's row stays in view, and no row is wasted at the end."""
        self._top = max(0, min(self._top, self._place, len(self._table.rows) - rows))
        self._top = max(self._top, self._place - rows + 1, 0)

    def _title(self, width: int) -> tuple[Run, ...]:
        title: list[Run] = [
            (text, StyleRole.TITLE_FOCUSED if ink is StyleRole.TITLE and self.has_focus else ink)
            for text, ink in self._table.title
        ]
        hidden = len(self._table.rows) - (self.size.height - 1)
        if hidden > 0 and not self._table.title_buttons:
            title.append((f" {self._place + 1}/{len(self._table.rows)}", StyleRole.DIM))
        runs = [("─ ", StyleRole.RULE), *title, (" ", StyleRole.RULE)]
        return cut([*runs, ("─" * (width - width_of(runs)), StyleRole.RULE)], width)

    def put_cursor(self, key: Hashable) -> None:
        """Set the cursor, which is shown with the next rows."""
        self.cursor = key

    def action_move(self, step: int) -> None:
        """The cursor up or down."""
        rows = self._table.rows
        if rows:
            self._place = max(0, min(self._place + step, len(rows) - 1))
            self._set_cursor(rows[self._place])

    def action_slide(self, step: int) -> None:
        """Long rows to the left or right."""
        self._slid = max(0, self._slid + step * 8)
        self.draw()

    def action_menu(self) -> None:
        """Ask for the menu of the cursor's row."""
        if self.cursor is not None:
            self.post_message(RowChosen(self.id or "", self.cursor))

    def _set_cursor(self, row: Row) -> None:
        self.cursor = row.key
        self.post_message(RowPicked(self.id or "", row.key))
        self.draw()

    def on_click(self, event: events.Click) -> None:
        """A button where one is, else the row; a second click opens its menu."""
        event.stop()
        if event.y == 0:
            self._press(self._table.title_buttons, event.x - 2, None)
            return
        index = self._top + event.y - 1
        if index < len(self._table.rows):
            row, self._place = self._table.rows[index], index
            self._set_cursor(row)
            if not self._press(row.buttons, event.x - 1, row.key) and event.chain == 2:
                self.action_menu()

    def _press(self, buttons: tuple[Button, ...], x: int, key: Hashable) -> bool:
        for button in buttons:
            if button.start <= x < button.end:
                self.post_message(ButtonPressed(self.id or "", button.name, key))
                return True
        return False

    def on_mouse_scroll_down(self, event: events.MouseScrollDown) -> None:
        """Three rows on."""
        event.stop()
        self.action_move(3)

    def on_mouse_scroll_up(self, event: events.MouseScrollUp) -> None:
        """Three rows back."""
        event.stop()
        self.action_move(-3)

    def on_resize(self) -> None:
        """Paint for the new size."""
        self.draw()

    def watch_has_focus(self, has_focus: bool) -> None:
        """Brighten the title of the focused pane."""
        super().watch_has_focus(has_focus)
        self.draw()


def _slide(row: Row, cells: int, room: int) -> tuple[Run, ...]:
    """A row without its first cells, never further than its end."""
    if not cells:
        return cut(row.runs, room)
    left = max(0, min(cells, width_of(row.runs) - room))
    runs: list[Run] = []
    for text, ink in row.runs:
        gone = min(left, len(text))
        left -= gone
        runs.append((text[gone:], ink))
    return cut(runs, room)

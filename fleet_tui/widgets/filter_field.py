"""A field that filters the rows of an overlay: hidden while nothing is typed in it."""

from functools import partial

from textual.actions import SkipAction
from textual.widgets import Input

from fleet_tui.widgets.field import Field, Keys
from fleet_tui.widgets.rows_pane import RowsPane


class FilterField(Field):
    """Moves the cursor of the rows while one types; Enter keeps the text, Esc clears it."""

    def __init__(self, rows: RowsPane, *, id: str, placeholder: str) -> None:
        self._rows = rows
        keys: Keys = {
            "enter": self.leave,
            "escape": partial(self.leave, clear=True),
            "up": partial(rows.move, -1),
            "down": partial(rows.move, 1),
            "pageup": partial(rows.move, -10),
            "pagedown": partial(rows.move, 10),
        }
        super().__init__(keys, id=id, placeholder=placeholder)

    def on_mount(self) -> None:
        """Hide it until it is used."""
        self.display = False

    def begin(self) -> None:
        """Take the focus. Raises SkipAction if it has it: the key is a letter of the text."""
        if self.screen.focused is self:
            raise SkipAction
        self.display = True
        self.screen.set_focus(self)

    def put(self, text: str) -> None:
        """Filter by a text, with the focus on the rows; nobody is told of a change."""
        with self.prevent(Input.Changed):
            self.value = text
        self.leave()

    def leave(self, clear: bool = False) -> None:
        """Give the focus to the rows."""
        if clear:
            self.value = ""
        self.display = bool(self.value)
        self.screen.set_focus(self._rows)

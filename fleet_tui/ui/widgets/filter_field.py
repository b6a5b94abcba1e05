"""A field that filters the rows of an overlay: hidden while nothing is typed in it."""

from textual.actions import SkipAction
from textual.widgets import Input

from fleet_tui.text.language import tr
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.widgets.field import Field, Keys, row_keys
from fleet_tui.ui.widgets.rows_pane import RowsPane


class FilterField(Field):
    """Moves the cursor of the rows while one types; Enter keeps the text, unless the `keys` have it."""

    def __init__(self, rows: RowsPane, *, id: str, keys: Keys) -> None:
        self._rows = rows
        super().__init__({**row_keys(rows), "enter": self.leave, **keys}, id=id)

    def on_mount(self) -> None:
        """Hide it until it is used."""
        self.display = False

    def begin(self) -> None:
        """Take the focus. Raises SkipAction if it has it: the key is a letter of the text."""
        if self.screen.focused is self:
            raise SkipAction
        self.placeholder = filter_help(self._rows.arrangement)
        self.display = True
        self.screen.set_focus(self)

    def put(self, text: str) -> None:
        """Filter by a text, which nobody is told of; the field gives up the focus."""
        with self.prevent(Input.Changed):
            self.value = text
        self.leave()

    def leave(self, clear: bool = False) -> None:
        """Give the focus to the rows, if it is here: their overlay may be closed."""
        had_focus = self.screen.focused is self
        if clear:
            self.value = ""
        self.display = bool(self.value)
        if had_focus:
            self.screen.set_focus(self._rows)


def filter_help(arrangement: RowArrangement) -> str:
    """Return how to filter rows, shown while nothing is typed."""
    keys = " ".join(f"{name}:" for name in arrangement.names)
    return tr("words !word {keys} Enter keeps, Esc clears", keys=keys)

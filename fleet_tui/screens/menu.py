"""A row's menu: what can be done with it."""

from collections.abc import Callable, Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import BindingType
from textual.widgets import OptionList, Static

from fleet_tui.screens.overlay import Overlay

Entry = tuple[str, Callable[[], None]]


class Menu(Overlay):
    """A short list; Enter does the marked entry."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("escape,q", "close", "Close"),
        ("j", "step('down')", "Down"),
        ("k", "step('up')", "Up"),
    ]

    def compose(self) -> ComposeResult:
        """The title above the entries."""
        yield Static(id="menu-title", markup=False)
        yield OptionList(markup=False)

    def show(self, title: str, entries: Sequence[Entry]) -> None:
        """Offer the entries."""
        self._entries = entries
        self.query_one("#menu-title", Static).update(title)
        options = self.query_one(OptionList)
        options.clear_options()
        options.add_options([text for text, _ in entries])
        options.highlighted = 0
        self.open(options)

    def action_step(self, way: str) -> None:
        """The mark up or down."""
        options = self.query_one(OptionList)
        (options.action_cursor_down if way == "down" else options.action_cursor_up)()

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Do it."""
        event.stop()
        # A second Enter may have been on its way already.
        if not self.is_open:
            return
        self.action_close()
        self._entries[event.option_index][1]()

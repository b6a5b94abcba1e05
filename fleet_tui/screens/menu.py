"""A row's menu: its possible actions."""

from collections.abc import Sequence
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import BindingType
from textual.content import Content
from textual.events import Key
from textual.widgets import OptionList, Static

from fleet_tui.controllers.typed import Entry
from fleet_tui.screens.overlay import Dialog
from fleet_tui.text.language import tr


class Menu(Dialog):
    """A short list; Enter runs the marked entry, its number or the key at its end any entry."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("escape,q", "close", "Close"),
        ("j", "step('down')", "Down"),
        ("k", "step('up')", "Up"),
        *((str(n), f"choose({n})", f"Entry {n}") for n in range(1, 10)),
    ]

    def compose(self) -> ComposeResult:
        """Compose the title above the entries."""
        self.border_title = Content(tr("Actions"))
        yield Static(id="menu-title", markup=False)
        yield OptionList(markup=False)

    def show(self, title: str, entries: Sequence[Entry], marked: int = 0) -> None:
        """Show the entries, with a mark on one of them."""
        self._entries = entries
        self.query_one("#menu-title", Static).update(tr(title))
        options = self.query_one(OptionList)
        options.clear_options()
        options.add_options([f"{n}  {tr(text)}" for n, (text, _) in enumerate(entries, 1)])
        options.highlighted = marked
        self.open(options)

    def action_step(self, way: str) -> None:
        """Move the mark up or down."""
        options = self.query_one(OptionList)
        (options.action_cursor_down if way == "down" else options.action_cursor_up)()

    def action_choose(self, number: int) -> None:
        """Run an entry by its number."""
        # A second key may already have been in the queue.
        if self.is_open and number <= len(self._entries):
            self.action_close()
            self._entries[number - 1][1]()

    def on_key(self, event: Key) -> None:
        """Run the entry with this key at its end, in brackets; the keys of menus themselves come first."""
        if event.key in self._bindings.key_to_bindings or not event.character:
            return
        texts = [text for text, _ in self._entries]
        for number in (n for n, text in enumerate(texts, 1) if text.endswith(f"({event.character})")):
            event.stop()
            self.action_choose(number)

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Run it."""
        event.stop()
        self.action_choose(event.option_index + 1)

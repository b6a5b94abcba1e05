"""A row's menu: its possible actions; or a list to choose from, which filters as one types."""

from collections.abc import Sequence
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.content import Content
from textual.events import Key
from textual.widgets import Input, OptionList, Static

from fleet_tui.controllers.typed import Entry
from fleet_tui.rules.language.ranking import rank
from fleet_tui.screens.overlay import Dialog
from fleet_tui.text.language import tr
from fleet_tui.widgets.field import Field
from fleet_tui.widgets.matches import Matches

MOST_NUMBERED = 9
"""Entries up to which each has a number for a key. A longer list filters: its letters and digits are text."""


class Menu(Dialog):
    """Enter runs the marked entry; of a short list its number or the key at its end any entry."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("escape,q", "close", "Close"),
        ("j", "step(1)", "Down"),
        ("k", "step(-1)", "Up"),
        *((str(n), f"choose({n})", f"Entry {n}") for n in range(1, MOST_NUMBERED + 1)),
    ]

    def __init__(self, *, id: str) -> None:
        super().__init__(id=id)
        self._all: Sequence[Entry] = ()
        self._entries: Sequence[Entry] = ()
        self._list = Matches(id="menu-list")
        self._typed = Field(
            {
                "enter": lambda: self._run(self._list.marked),
                "escape": self.action_close,
                "up": lambda: self._list.step(-1),
                "down": lambda: self._list.step(1),
            },
            id="menu-typed",
            placeholder=tr("type to search"),
        )

    def compose(self) -> ComposeResult:
        """Compose the title above the field and the entries."""
        self.border_title = Content(tr("Actions"))
        yield Static(id="menu-title", markup=False)
        yield self._typed
        yield self._list

    def show(self, title: str, entries: Sequence[Entry], marked: int = 0) -> None:
        """Show the entries, with a mark on one of them."""
        self._all = entries
        self.query_one("#menu-title", Static).update(tr(title))
        filters = len(entries) > MOST_NUMBERED
        self._typed.display = filters
        self._list.can_focus = not filters
        with self._typed.prevent(Input.Changed):
            self._typed.value = ""
        self._fill()
        self._list.highlighted = marked
        self.open(self._typed if filters else self._list)

    def _fill(self) -> None:
        typed = self._typed.value.strip()
        self._entries = [entry for entry in self._all if not typed or rank(typed, entry[0]) is not None]
        numbered = len(self._all) <= MOST_NUMBERED
        texts = [tr(text) for text, _ in self._entries]
        self._list.show([f"{n}  {text}" for n, text in enumerate(texts, 1)] if numbered else texts)

    @on(Input.Changed, "#menu-typed")
    def _filter(self, event: Input.Changed) -> None:
        event.stop()
        if self.is_open:
            self._fill()

    def action_step(self, rows: int) -> None:
        """Move the mark up or down."""
        self._list.step(rows)

    def action_choose(self, number: int) -> None:
        """Run an entry by its number."""
        self._run(number - 1)

    def _run(self, index: int) -> None:
        # A second key may already have been in the queue.
        if self.is_open and index < len(self._entries):
            entry = self._entries[index]
            self.action_close()
            entry[1]()

    def on_key(self, event: Key) -> None:
        """Run the entry with this key at its end, in brackets; the keys of menus themselves come first."""
        if self._typed.display or event.key in self._bindings.key_to_bindings or not event.character:
            return
        texts = [text for text, _ in self._entries]
        for index in (n for n, text in enumerate(texts) if text.endswith(f"({event.character})")):
            event.stop()
            self._run(index)

    @on(OptionList.OptionSelected, "#menu-list")
    def _selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self._run(event.option_index)

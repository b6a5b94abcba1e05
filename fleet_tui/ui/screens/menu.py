"""A row's menu: its possible actions, each with keys; or a list of things, which filters as one types."""

from collections.abc import Sequence
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.content import Content
from textual.events import Key
from textual.widgets import Input, OptionList, Static

from fleet_tui.commands.language.ranking import rank
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.ui.controllers.typed import Entry
from fleet_tui.ui.screens.overlay import Dialog
from fleet_tui.ui.widgets.field import Field
from fleet_tui.ui.widgets.matches import Matches

NUMBERED = 9
"""Actions with a number for a key."""


class Menu(Dialog):
    """Enter runs the marked entry; of actions its number or the key at its end any entry."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("escape,q", "close", "Close"),
        ("j", "step(1)", "Down"),
        ("k", "step(-1)", "Up"),
        *((str(n), f"choose({n})", Message("Entry {n}", n=n)) for n in range(1, NUMBERED + 1)),
    ]

    def __init__(self, *, id: str) -> None:
        super().__init__(id=id)
        self._all: Sequence[Entry] = ()
        self._list = Matches[Entry](id="menu-list")
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
        yield Static(id="menu-title", markup=False)
        yield self._typed
        yield self._list

    def show(
        self, title: Message, entries: Sequence[Entry], marked: int = 0, *, searched: bool = False
    ) -> None:
        """Show the entries, with a mark on one of them; a `searched` list has a field and no keys."""
        self._all = entries
        self.query_one("#menu-title", Static).update(translate(title))
        self.border_title = Content(tr("Choose") if searched else tr("Actions"))
        self._typed.display = searched
        self._list.can_focus = not searched
        with self._typed.prevent(Input.Changed):
            self._typed.value = ""
        self._fill(marked)
        self.open(self._typed if searched else self._list)

    def _fill(self, marked: int = 0) -> None:
        typed = self._typed.value.strip()
        entries = [entry for entry in self._all if not typed or rank(typed, entry[0]) is not None]
        texts = [translate(text) for text, _ in entries]
        if not self._typed.display:
            texts = [f"{n}  {text}" if n <= NUMBERED else f"   {text}" for n, text in enumerate(texts, 1)]
        self._list.show(entries, texts, marked)

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
        self._run(self._list.at(number - 1))

    def _run(self, entry: Entry | None) -> None:
        if self.is_open and entry is not None:
            self.action_close()
            entry[1]()

    def on_key(self, event: Key) -> None:
        """Run the entry with this key at its end, in brackets; the keys of menus themselves come first."""
        if self._typed.display or event.key in self._bindings.key_to_bindings or not event.character:
            return
        for entry in self._list.items:
            if entry[0].endswith(f"({event.character})"):
                event.stop()
                self._run(entry)

    @on(OptionList.OptionSelected, "#menu-list")
    def _selected(self, event: OptionList.OptionSelected) -> None:
        event.stop()
        self._run(self._list.at(event.option_index))

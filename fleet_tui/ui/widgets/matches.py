"""Matches of a field, listed below it: the field keeps the focus, one match is marked."""

from collections.abc import Sequence
from itertools import zip_longest
from typing import Generic, TypeVar

from textual import events
from textual.content import Content
from textual.message import Message
from textual.widgets import OptionList

from fleet_tui.text.sanitize import cell_width, fit_words

Item = TypeVar("Item")


class Matches(OptionList, Generic[Item], can_focus=False):
    """Lists items by their texts. Enter takes the `marked` one, which a new list keeps or marks no more."""

    def __init__(self, *, id: str) -> None:
        super().__init__(id=id, markup=False)
        self.items: Sequence[Item] = ()
        self._texts: list[tuple[str, str]] = []

    def show(
        self, items: Sequence[Item], texts: Sequence[str], mark: int | None = 0, keys: Sequence[str] = ()
    ) -> None:
        """List these, one of them marked unless none may be taken yet; at the right the key of each."""
        self.items = items
        self._texts = list(zip_longest(texts, keys, fillvalue=""))
        self.clear_options()
        self.add_options([self._prompt(*line) for line in self._texts])
        self.highlighted = mark if self.option_count else None

    def renew(self, items: Sequence[Item], texts: Sequence[str]) -> bool:
        """List these, the same item marked. Returns False, and marks none, if it is gone."""
        marked = self.marked
        self.show(items, texts, mark=items.index(marked) if marked is not None and marked in items else None)
        return marked is None or self.marked is not None

    @property
    def marked(self) -> Item | None:
        return self.at(self.highlighted) if self.highlighted is not None else None

    def at(self, index: int) -> Item | None:
        """Return the item of a line, None beyond the last one."""
        return self.items[index] if index < len(self.items) else None

    class DoubleClicked(Message):
        """A row was clicked twice: the first click has chosen it."""

    def on_click(self, event: events.Click) -> None:
        """Choose by the first click; the second one sends, whatever is below it by now."""
        if event.chain > 1:
            event.stop()
            event.prevent_default()
            if event.chain == 2:
                self.post_message(self.DoubleClicked())

    def on_resize(self) -> None:
        """Put the keys at the new right end."""
        for n, line in enumerate(self._texts):
            if line[1]:
                self.replace_option_prompt_at_index(n, self._prompt(*line))

    def _prompt(self, text: str, key: str) -> str | Content:
        # The scroll bar may come and go, with a gap before it.
        width = self.size.width - self.styles.scrollbar_size_vertical - 1
        left = width - cell_width(key) - 1
        if not key or left < 1:
            return text
        # On a second line there would be no place for the key.
        shown = fit_words(text, left)
        return Content.assemble(shown, " " * (left + 1 - cell_width(shown)), (key, "$text-accent"))

    def step(self, rows: int) -> None:
        """Mark another one."""
        (self.action_cursor_down if rows > 0 else self.action_cursor_up)()

"""A text field whose keys act at once."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Protocol

from textual import events
from textual.geometry import Size
from textual.reactive import Reactive
from textual.widgets import Input

from fleet_tui.links.transports.loop import end_turn, give_turn
from fleet_tui.text.sanitize import sanitize

Keys = Mapping[str, Callable[[], object]]


class Paged(Protocol):
    """Rows or lines, of which `page` are in view."""

    @property
    def page(self) -> int: ...

    def move(self, step: int) -> None:
        """Move by rows, at most to the first or last one."""


def row_keys(rows: Paged) -> Mapping[str, Callable[[], None]]:
    """Return the keys with which a field that has the focus moves in rows."""
    return {
        "up": partial(rows.move, -1),
        "down": partial(rows.move, 1),
        "pageup": lambda: rows.move(-rows.page),
        "pagedown": lambda: rows.move(rows.page),
    }


class Field(Input):
    """Runs the callback `on` for a key; all others edit its text."""

    # A letter moves no other widget; Textual would lay out and paint the whole screen for each.
    virtual_size = Reactive(Size(0, 0), layout=False)

    def __init__(self, on: Keys, *, id: str, placeholder: str = "") -> None:
        super().__init__(id=id, placeholder=placeholder, compact=True, select_on_focus=True)
        self._on = on

    def on_paste(self, event: events.Paste) -> None:
        """Insert pasted text, sanitized: it may come from a robot."""
        event.text = "\n".join(map(sanitize, event.text.splitlines()))

    def on_key(self, event: events.Key) -> None:
        """Run the callback of a key, or let Textual insert it."""
        if (action := self._on.get(event.key)) is None:
            give_turn()
            return
        end_turn()  # a command may follow, which the loop sends
        event.stop()
        event.prevent_default()
        action()

"""Asks once before something is lost. Only `y` does it."""

from collections.abc import Callable, Iterable
from typing import ClassVar

from textual import on
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Horizontal
from textual.widgets import Button, Static

from fleet_tui.screens.overlay import MouseButton, Overlay


class Confirm(Overlay, can_focus=True):
    """A question with what will be lost; the default is No."""

    BINDINGS: ClassVar[list[BindingType]] = [
        ("y", "confirm", "Do it"),
        ("n,escape,enter", "close", "Don't"),
    ]

    def compose(self) -> ComposeResult:
        """The question above its two answers."""
        yield Static(id="question", markup=False)
        with Horizontal():
            yield MouseButton("y  yes", id="yes", compact=True)
            yield MouseButton("n  no", id="no", compact=True)

    def ask(self, lines: Iterable[str], then: Callable[[], None]) -> None:
        """Ask, and call `then` only after a yes."""
        self._then = then
        self.query_one("#question", Static).update("\n".join(lines))
        self.open(self)

    @on(Button.Pressed, "#yes")
    def action_confirm(self) -> None:
        """Yes."""
        if not self.is_open:
            return
        # Closing restyles the screen; the command does not wait for that.
        self._then()
        self.action_close()

    @on(Button.Pressed, "#no")
    def refuse(self) -> None:
        """No."""
        self.action_close()

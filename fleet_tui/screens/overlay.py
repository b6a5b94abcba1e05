"""Overlays over the map: the status line stays in view, keys stay inside.

It is part of the main screen, mounted from the start, so that a key typed right after the one
that opened it already finds it.
"""

from textual.containers import Vertical
from textual.widget import Widget
from textual.widgets import Button


class MouseButton(Button, can_focus=False):
    """For the mouse alone: the keys stay where they are, and Enter never presses it."""


class Overlay(Vertical):
    """Hidden until opened. Only keys that work everywhere reach through it."""

    _before: Widget | None = None

    @property
    def is_modal(self) -> bool:
        """Textual looks no further than here for the binding of a key."""
        return True

    @property
    def is_open(self) -> bool:
        """Tell whether it is in view."""
        return self.display

    def on_mount(self) -> None:
        """Out of view until opened. Not by a CSS class: that would restyle all within at each turn."""
        self.display = False

    def open(self, first: Widget) -> None:
        """Come into view with the focus on `first`."""
        others = [other for other in self.screen.query(Overlay) if other.is_open and other is not self]
        if others:
            self._before = others[0]._before
        elif not self.is_open:
            self._before = self.screen.focused
        for other in others:
            other.display = False
        self.display = True
        # Not Widget.focus(), which waits for a refresh: a key may be next in line.
        self.screen.set_focus(first)

    def action_close(self) -> None:
        """Go, and give the focus back."""
        self.display = False
        if self._before is not None and self._before.is_attached:
            self.screen.set_focus(self._before)

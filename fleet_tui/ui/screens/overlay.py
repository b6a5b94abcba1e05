"""Overlays over the map: the status line remains visible, keys stay inside.

It is part of the main screen, mounted from the start, so that the key after the one that opened it already
reaches it.
"""

from textual import events
from textual.containers import Vertical
from textual.widget import Widget
from textual.widgets import Button


class OnceButton(Button):
    """Ignores the second click of a double click: it may have been meant for what was there before."""

    def on_click(self, event: events.Click) -> None:
        """Let only the first click press it."""
        if event.chain > 1:
            event.stop()
            event.prevent_default()


class MouseButton(OnceButton, can_focus=False):
    """For the mouse only: it never takes the focus or Enter."""


class Overlay(Vertical):
    """Hidden until opened. Only keys that work everywhere pass through it."""

    _before: Widget | None = None
    is_below = False
    """It waits below a dialog."""

    @property
    def is_modal(self) -> bool:
        """Stop Textual's search for a key binding here."""
        return True

    @property
    def is_open(self) -> bool:
        return self.display

    @property
    def beneath(self) -> Widget | None:
        """Return what had the focus before any overlay was opened."""
        return self._before

    def on_mount(self) -> None:
        """Hide until opened. Not by a CSS class: that would restyle all its children at each change."""
        self.display = False

    def open(self, first: Widget) -> None:
        """Show it with the focus on `first`."""
        others = [other for other in self.screen.query(Overlay) if other.is_open and other is not self]
        if others:
            self._before = others[0].beneath
        elif not self.is_open:
            self._before = self.screen.focused
        for other in others:
            other.display = False
        self.display = True
        # Not Widget.focus(), which waits for a refresh: the next key may already be in the queue.
        self.screen.set_focus(first)

    def action_close(self) -> None:
        """Close, and restore the focus."""
        self.display = self.is_below = False
        if self._before is not None and self._before.is_attached:
            self.screen.set_focus(self._before)


class ReturningOverlay(Overlay):
    """Comes back when a dialog that was opened over it is closed, unless the answer has closed it."""


class Dialog(Overlay):
    """A menu or a question, over the console or over another overlay."""

    _below: ReturningOverlay | None = None

    @property
    def beneath(self) -> Widget | None:
        if self._below is not None and self._below.is_below:
            return self._below.beneath
        return self._before

    def open(self, first: Widget) -> None:
        """Show it with the focus on `first`."""
        below = next((other for other in self.screen.query(ReturningOverlay) if other.is_open), None)
        focused = self.screen.focused
        super().open(first)
        self._below = below
        if below is not None:
            self._before = focused
            below.is_below = True

    def action_close(self) -> None:
        """Close, and restore what was below, with its focus; what the answer closed has given it back."""
        below = self._below
        if below is not None and not below.is_below:
            self.display = False
            return
        if below is not None:
            below.display = True
        super().action_close()

"""One widget in a small app."""

from typing import Any

from textual.app import App, ComposeResult
from textual.widget import Widget

from fleet_tui.ui.terminal.lean_app import LeanApp


class WidgetApp(LeanApp):
    """Shows widgets, one below the other."""

    def __init__(self, *widgets: Widget) -> None:
        super().__init__()
        self._widgets = widgets

    def compose(self) -> ComposeResult:
        yield from self._widgets


def text(widget: Widget) -> list[str]:
    """The rows of a widget."""
    return [widget.render_line(y).text for y in range(widget.size.height)]


def screen_rows(app: App[Any]) -> list[str]:
    """The rows of the whole screen as a person reads it."""
    return [strip.text for strip in app.screen._compositor.render_strips()]

"""One line of text that is always visible."""

from collections.abc import Sequence

from textual import events

from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Button, Run, cut, width_of
from fleet_tui.ui.widgets.messages import ButtonPressed
from fleet_tui.ui.widgets.runs_view import RunsView


class LineView(RunsView):
    """Shows runs at the left and others at the right. If both don't fit, the left stays whole, with as
    many of the last runs at the right as fit, or with `keep_right` the right. A click on one of its buttons
    is reported."""

    DEFAULT_CSS = "LineView { height: 1; }"

    def __init__(self, *, id: str, keep_right: bool = False) -> None:
        super().__init__(id=id)
        self._keep_right = keep_right
        self._buttons: Sequence[Button] = ()

    def show(self, left: Sequence[Run], right: Sequence[Run] = (), buttons: Sequence[Button] = ()) -> None:
        """Show these runs; `buttons` are in the left ones."""
        width = self.size.width
        if width < 1:
            return
        self._buttons = buttons
        if self._keep_right:
            left = cut(left, max(0, width - width_of(right) - 1))
        while right and width_of(left) + width_of(right) >= width:
            right = right[1:]
        gap = width - width_of(left) - width_of(right)
        left = [*left, (" " * gap, StyleRole.TEXT), *right]
        self.paint_rows([cut(left, width)])

    def on_click(self, event: events.Click) -> None:
        """Press the button at the click, if any."""
        event.stop()
        for button in self._buttons:
            if button.start <= event.x < button.end:
                self.post_message(ButtonPressed(self.id or "", button.name, None))

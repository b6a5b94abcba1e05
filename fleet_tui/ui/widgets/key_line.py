"""The footer: the keys available now, each a button."""

from collections.abc import Mapping

from fleet_tui.keys import Pane
from fleet_tui.ui.view.lines.hints import footer, hints
from fleet_tui.ui.widgets.line_view import LineView


class KeyLine(LineView):
    """Shows the keys of `view/lines/hints.py`, laid out anew only when they change."""

    def __init__(self, keys: Mapping[str, tuple[str, ...]], *, id: str) -> None:
        super().__init__(id=id)
        self._keys = keys
        self._offered: object = None

    def offer(
        self,
        pane: Pane,
        can_command: bool,
        hidden: set[str],
        focused: str,
        alarmed: str,
        about_robot: bool = False,
    ) -> None:
        """Show the keys for these, as `hints` takes them."""
        offered = pane, can_command, hidden, focused, alarmed, about_robot, self.size.width
        if offered != self._offered:
            self._offered = offered
            runs, buttons = footer(
                *hints(self._keys, pane, can_command, hidden, focused, alarmed, about_robot),
                self._keys,
                self.size.width,
            )
            self.show(runs, buttons=buttons)

"""Turns the simple interface on and off, above the map or in its place."""

from collections.abc import Callable

from textual.widget import Widget

from fleet_tui.screens.simple import Simple
from fleet_tui.widgets.panes import Panes


class SimpleSwitch:
    """Creates the simple interface on first use."""

    def __init__(
        self, panes: Panes, map_view: Widget, make: Callable[[], Simple], may_order: Callable[[], bool]
    ) -> None:
        self._panes, self._map, self._make, self._may_order = panes, map_view, make, may_order
        self._simple: Simple | None = None

    async def turn(self) -> None:
        """Show or hide the simple interface."""
        panes = self._panes
        if not panes.has_class("-simple") and not self._may_order():
            return
        if self._simple is None:
            simple = self._make()
            await panes.floor.mount(simple, before=0)
            self._simple = simple  # not before: ticks during the mounting would query missing widgets
        panes.toggle_class("-simple")
        panes.share_out()
        if panes.has_class("-simple"):
            self._simple.start()
        else:
            panes.screen.set_focus(self._map)

    def show(self) -> None:
        """Show the newest state."""
        if self._simple is not None and self._simple.children:  # no screen while the console ends
            self._simple.show()

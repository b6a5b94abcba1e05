"""Turns the simple interface on and off, above the map, beside it or in its place."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from textual.widget import Widget

from fleet_tui.screens.simple import Simple
from fleet_tui.widgets.panes import Panes

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen
    from fleet_tui.screens.rest import Rest


class SimpleSwitch:
    """Creates the simple interface on first use."""

    def __init__(
        self,
        panes: Panes,
        map_view: Widget,
        make: Callable[[Callable[[], None]], Simple],
        may_order: Callable[[], bool],
    ) -> None:
        self._panes = panes
        self._map = map_view
        self._make = make
        self._may_order = may_order
        self._simple: Simple | None = None
        self._parts = 0

    async def turn(self) -> None:
        """Show or hide the simple interface."""
        panes = self._panes
        if not panes.has_class("-simple") and not self._may_order():
            return
        if self._simple is None:
            simple = self._make(self._leave)
            await panes.floor.mount(simple, before=0)
            self._simple = simple  # not before: ticks during the mounting would query missing widgets
            self._parts = len(simple.children)
        if panes.has_class("-simple"):
            self._leave()
        else:
            panes.add_class("-simple")
            panes.share_out()
            self._simple.start()

    def _leave(self) -> None:
        self._panes.remove_class("-simple")
        self._panes.share_out()
        self._panes.screen.set_focus(self._map)

    def show(self) -> None:
        """Show the newest state."""
        # While the console ends, its widgets go one after the other.
        if self._simple is not None and len(self._simple.children) == self._parts:
            self._simple.show()


def simple_switch(screen: "MainScreen", rest: "Rest") -> SimpleSwitch:
    def make(close: Callable[[], None]) -> Simple:
        state, navigation = lambda: screen.store.state, screen.navigation
        return Simple(state, lambda: navigation.robot, navigation.select, screen.dispatch.give, close)

    return SimpleSwitch(screen.panes, rest.map, make, rest.orders.may_order)

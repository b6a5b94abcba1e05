"""The small maps of other floors on the screen; a click shows one of them on the map."""

from typing import ClassVar

from textual import events
from textual.widget import Widget

from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.selection import Selection
from fleet_tui.ui.view.small_maps import SmallMaps, other_floors
from fleet_tui.ui.widgets.cells_view import CellsView
from fleet_tui.ui.widgets.messages import FloorPicked
from fleet_tui.ui.widgets.pace import Pace


class SmallMapsView(CellsView):
    """Shows the other floors once a second, and at once after a change by the operator."""

    DEFAULT_CSS: ClassVar[str] = "SmallMapsView { width: 1fr; height: 1fr; }"

    def __init__(self, id: str) -> None:
        super().__init__(id=id)
        self._maps = SmallMaps()
        self._pace = Pace(1.0)

    def show(self, state: FleetState, selection: Selection, options: MapOptions) -> None:
        """Show the newest state where there is space. Cheap between the seconds: call it at every tick."""
        place = self.parent
        if not (isinstance(place, Widget) and place.display):
            return
        if self.size.area and self._pace.is_due((self.size, selection, options)):
            self._maps.show(other_floors(state, selection), options)
            cells = self._maps.cells(*self.size)
            if cells is not None:
                self.paint(cells)

    def on_click(self, event: events.Click) -> None:
        """Report the floor at the click."""
        event.stop()
        if floor := self._maps.floor_at(event.x, event.y, *self.size):
            self.post_message(FloorPicked(floor))

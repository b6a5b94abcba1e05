"""The selected robot and floor, chosen by key, by mouse and by name."""

from collections.abc import Callable
from typing import Protocol

from msgspec.structs import replace

from fleet_tui.model.attention import Attention, SeenArea
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.sites import of_site
from fleet_tui.state.store import Store
from fleet_tui.ui.view.selection import Selection, first_selection


class MapCamera(Protocol):
    """The part of the map that other objects move and ask."""

    def reveal(self) -> None:
        """Centre on the selected robot if it is out of view."""

    def stop_following(self) -> None:
        """Stop following the selected robot."""

    def centre(self, at: tuple[float, float] | None = None) -> None:
        """Centre on a place in metres of the shown floor, or on the selected robot."""

    def seen(self) -> SeenArea | None: ...


class Navigation:
    """Owns the selection. `selected` is called with each selected robot."""

    def __init__(
        self,
        store: Store,
        selected: Callable[[str], None],
        camera: Callable[[], MapCamera],
        refresh: Callable[[], None],
    ) -> None:
        self._store = store
        self._selected = selected
        self._camera = camera
        self._refresh = refresh
        self.selection = first_selection(store.state)
        store.attention = Attention(self.robot, self.floor)

    @property
    def robot(self) -> str:
        """The name of the selected robot."""
        return self.selection.robot

    @property
    def floor(self) -> str:
        """The name of the shown floor."""
        return self.selection.floor

    @property
    def here(self) -> FleetState:
        """The part of the state that is about the selected robot's site."""
        return of_site(self._store.state, self.robot)

    def settle(self, state: FleetState, follow: bool) -> Selection:
        """Let the floor follow the robot, and the messages what is looked at."""
        self.selection = self.selection.settled(state, follow)
        self._store.attention = Attention(self.robot, self.floor, self._camera().seen())
        return self.selection

    def select(self, robot: str) -> None:
        """Select a robot; the fleet's cursor is on the selected one."""
        self.selection = self.selection.on_robot(robot)
        if self.floor not in self.here.floors:  # of another site
            self.selection = replace(self.selection, floor=next(iter(self.here.floors)))
        self._selected(robot)
        self._refresh()
        self._camera().reveal()

    def step_robot(self, step: int) -> None:
        """Select the next (1) or previous (-1) robot of the site."""
        self.select(self.selection.step_robot(self.here, step).robot)

    def step_floor(self, step: int) -> None:
        """Show the next (1) or previous (-1) floor of the site."""
        self.find_floor(self.selection.step_floor(self.here, step).floor)

    def find_robot(self, robot: str) -> None:
        """Select a robot and bring the map to it."""
        self.select(robot)
        self.settle(self._store.state, follow=True)
        self._refresh()
        self._camera().centre()

    def find_floor(self, floor: str) -> None:
        """Show a floor; a view that follows would leave another one at once."""
        if floor != self.floor:
            self._camera().stop_following()
        self.selection = replace(self.selection, floor=floor, chosen=True)
        self._refresh()

    def find_vertex(self, floor: str, x: float, y: float) -> None:
        """Bring the map to a place of a floor."""
        self.find_floor(floor)
        self._camera().stop_following()
        self._camera().centre((x, y))

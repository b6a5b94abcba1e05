"""A store that keeps its state at each tick."""

from fleet_tui.model.events import Event, TimePassed
from fleet_tui.model.fleet import FleetState
from tests.support.watched_store import WatchedStore


class Ticking(WatchedStore):
    """Keeps the state after every tick, by its time."""

    def __init__(self, state: FleetState) -> None:
        super().__init__(state)
        self.ticks: dict[float, FleetState] = {}

    def tell(self, event: Event) -> None:
        super().tell(event)
        if isinstance(event, TimePassed):
            self.ticks[event.at] = self.state

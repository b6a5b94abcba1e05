"""The table in the middle of the house: the newest state, for everybody to read."""

from fleet_tui.model.apply import apply
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState


class Store:
    """Holds the newest state. Only the writer's thread calls `tell`; any thread reads `state`,
    which is one reference, swapped whole."""

    def __init__(self, state: FleetState) -> None:
        self.state = state

    def tell(self, event: Event) -> None:
        """Take one fact into the picture."""
        self.state = apply(self.state, event)

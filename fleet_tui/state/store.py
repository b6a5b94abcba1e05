"""The store: the newest state, for every reader."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from fleet_tui.model.attention import Attention
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.state import reducer
from fleet_tui.state.streams import Streams

Watcher = Callable[[FleetState, FleetState], None]


class Store:
    """Holds the newest state. Only the writer's thread calls `apply`; any thread reads `state`, which is one
    reference, swapped whole. A watcher is called with the state before and after an event that changed a
    command, an alarm or the desk, before anything else happens. `streams` and `attention` are beside the
    state."""

    def __init__(self, state: FleetState) -> None:
        self.state = state
        self.watchers: list[Watcher] = []
        self._is_together = False
        self.streams = Streams()
        self.attention = Attention()
        """What the operator looks at: links request its messages first, and more often."""

    def apply(self, event: Event) -> None:
        before, self.state = self.state, reducer.apply(self.state, event)
        if not self._is_together:
            self._tell(before)

    @contextmanager
    def together(self) -> Iterator[None]:
        """Call the watchers once for all events that are applied in this block, after the last."""
        before, self._is_together = self.state, True
        try:
            yield
        finally:
            self._is_together = False
            self._tell(before)

    def _tell(self, before: FleetState) -> None:
        after = self.state
        same = before.commands is after.commands and before.alarms is after.alarms
        if not same or before.desk is not after.desk:
            for watcher in self.watchers:
                watcher(before, after)

    def put(self, state: FleetState) -> None:
        """Replace the state with that of another moment, as a replay does. No watcher is called."""
        self.state = state

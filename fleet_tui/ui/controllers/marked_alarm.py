"""The alarm under the cursor of the pane of alarms."""

import math
import time

from fleet_tui.model.fleet import FleetState
from fleet_tui.ui.view.tables.alarms import unacknowledged
from fleet_tui.ui.widgets.rows_pane import RowsPane


class MarkedAlarm:
    """It is of those that wait for an acknowledgement, unless the pane has the focus."""

    def __init__(self, pane: RowsPane) -> None:
        self._pane = pane
        self.gone_at = -math.inf
        """When it went by itself last, or gave way to a worse one (monotonic)."""

    def look(self, state: FleetState) -> None:
        """Follow the alarms of the newest state."""
        fresh, listing = unacknowledged(state), self._pane.listing
        marked = listing.cursor
        if marked is not None and all(alarm.key != marked for alarm in state.alarms):
            self.gone_at = time.monotonic()
        # What nobody chose gives way to a worse one.
        is_own = marked == listing.proposed and marked in fresh
        if fresh and (is_own or marked not in fresh) and not self._pane.has_focus:
            if is_own and marked != fresh[0]:
                self.gone_at = time.monotonic()
            listing.cursor = listing.proposed = fresh[0]

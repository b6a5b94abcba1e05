"""The pane of the robots' last activities."""

from collections.abc import Hashable, Sequence

from fleet_tui.model.fleet import FleetState
from fleet_tui.view.history.lately import RecentActivity, activity_table
from fleet_tui.widgets.pace import Pace
from fleet_tui.widgets.rows_pane import RowsPane


class ActivityPane:
    """Records what the robots do also while its rows are not shown. `is_ascii`: the terminal has no other
    signs."""

    def __init__(self, is_ascii: bool) -> None:
        self.rows = RowsPane(id="activity")
        self.rows.can_focus = False
        self._recent, self._pace, self._is_ascii = RecentActivity(), Pace(1.0), is_ascii

    def look(self, state: FleetState, robots: Sequence[Hashable]) -> None:
        """Record the newest state, and show as many of the robots as there are lines."""
        self._recent.note(state)
        lines, width = self.rows.size.height, self.rows.row_width
        if lines and self._pace.is_due((lines, width, robots)):
            self.rows.show(activity_table(self._recent, robots, lines, width, self._is_ascii))

"""The place below the map: the last events, and beside them activities or small maps."""

from collections.abc import Hashable, Sequence

from textual.containers import Container
from textual.geometry import Size

from fleet_tui.model.fleet import FleetState
from fleet_tui.view.history.lately import RecentActivity, activity_table
from fleet_tui.view.layout import LEAST_SHARED
from fleet_tui.widgets.pace import Pace
from fleet_tui.widgets.rows_pane import RowsPane


class ActivityPane:
    """Records what the robots do also while its rows are not shown. `is_ascii`: the terminal has no other
    signs."""

    def __init__(self, is_ascii: bool) -> None:
        self.rows = RowsPane(id="activity")
        self.rows.can_focus = False
        self._recent = RecentActivity()
        self._pace = Pace(1.0)
        self._is_ascii = is_ascii

    def look(self, state: FleetState, robots: Sequence[Hashable]) -> None:
        """Record the newest state, and show as many of the robots as there are lines."""
        self._recent.note(state)
        lines, width = self.rows.size.height, self.rows.row_width
        if lines and self._pace.is_due((lines, width, robots)):
            self.rows.show(activity_table(self._recent, robots, lines, width, self._is_ascii))


class BelowMap(Container):
    """Has the lines that the floor leaves. `is_ascii`: the terminal has no other signs."""

    def __init__(self, is_ascii: bool) -> None:
        self.recent = RowsPane(id="recent")
        self.recent.can_focus = False
        self.activity = ActivityPane(is_ascii)
        self.maps = Container(id="maps-below")
        super().__init__(self.recent, self.activity.rows, self.maps, id="below")
        self._lines = 0

    @property
    def rows_size(self) -> Size:
        """Return the cells and lines of its rows, without those of the maps."""
        return self.recent.region.size if self.maps.display else self.region.size

    def take(self, lines: int) -> bool:
        """Take so many lines, 0 for none, and tell whether it had others."""
        if lines == self._lines:
            return False
        self._lines = lines
        self.styles.height = lines
        self.display = lines > 0
        return True

    def divide(self, has_maps: bool, cells: int) -> None:
        """Show beside the last events small maps, or activities if there are enough cells."""
        self.maps.display = has_maps
        self.activity.rows.display = not has_maps and cells >= LEAST_SHARED

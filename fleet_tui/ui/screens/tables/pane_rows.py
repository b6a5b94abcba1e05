"""The newest rows of fleet, alarms and queue."""

from fleet_tui.keys.key import key_name
from fleet_tui.model.fleet import CROWD
from fleet_tui.model.problem import Right
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.view.tables.alarms import alarm_table
from fleet_tui.ui.view.tables.fleet import fleet_table
from fleet_tui.ui.view.tables.queue import queue_table
from fleet_tui.ui.view.tables.table import Table
from fleet_tui.ui.widgets.pace import Pace
from fleet_tui.ui.widgets.panes import Panes
from fleet_tui.ui.widgets.rows_pane import RowsPane


class PaneRows:
    """Nobody reads values that change ten times a second, and all of a large fleet take a while to sort: the
    fleet's rows are made five times a second, of a crowd twice; the map of a crowd is made five times."""

    def __init__(self, console: Console, panes: Panes) -> None:
        self._console = console
        self._panes = panes
        self._fleet_pace = Pace(0.2)
        self._crowd_pace = Pace(0.5)
        self._floor_pace = Pace(0.2)
        self._fleet: Table | None = None
        self._has_floor = False
        self.shows_all_orders = False

    @property
    def _is_crowd(self) -> bool:
        return len(self._console.store.state.robots) >= CROWD

    def is_floor_due(self, has_mode: bool, size: object) -> bool:
        """Tell whether to show the newest floor in a map of this size: of a crowd not at every tick, unless
        the map has a mode, as when a robot is driven."""
        if not self._is_crowd or has_mode:
            return True
        self._has_floor = self._floor_pace.is_due((self._console.navigation.selection, size))
        return self._has_floor

    def tables(self) -> list[Table]:
        """Return fleet, alarms and queue. The fleet is the same table again until it is due, or another
        robot, size, arrangement or alarm asks for it; a crowd is not made in one tick with its map."""
        panes, pane = self._panes, self._panes.fleet
        arranged = pane.arrangement.typed, pane.arrangement.column, pane.arrangement.groups.by
        pace = self._crowd_pace if self._is_crowd else self._fleet_pace
        asked = self._console.navigation.robot, pane.size, arranged, self._console.store.state.alarms
        has_floor, self._has_floor = self._has_floor, False
        if (asked != pace.key or not has_floor) and pace.is_due(asked):
            self._fleet = None  # until it is made: after a fault it is due again
        fleet = self._fleet or self.of(pane)
        return [fleet, self.of(panes.alarms), self.of(panes.queue)]

    def of(self, pane: RowsPane) -> Table:
        """Return the newest rows of one of these panes, as they are arranged."""
        navigation, settings = self._console.navigation, self._console.settings
        arranged = pane.row_width, pane.arrangement
        if pane is self._panes.fleet:
            self._fleet = fleet_table(navigation.here, navigation.robot, *arranged)
            return self._fleet
        if pane is self._panes.alarms:
            key = "".join(map(key_name, settings.keys["next_trouble"][:1]))
            return alarm_table(navigation.here, settings.clock, *arranged, pane.listing.cursor, key)
        may = self._console.dispatch.permissions.right >= Right.DISPATCH
        return queue_table(
            navigation.here, navigation.robot, self.shows_all_orders, *arranged, may, settings.clock
        )

    def show(self, pane: RowsPane, sought: str = "") -> None:
        """Show the newest rows of a pane, the cursor on the best one sought, else on the selected robot."""
        if pane is self._panes.fleet and not pane.arrangement.typed:
            pane.listing.cursor = self._console.navigation.robot
        pane.show(self.of(pane), sought)

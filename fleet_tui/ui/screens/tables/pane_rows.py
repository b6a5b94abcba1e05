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
    """Nobody reads values that change ten times a second, and all of a large fleet take a while to sort: rows
    are made five times a second, those of a crowd twice; the map of a crowd is made five times. What they
    are about, as another order, or another alarm, is shown at once."""

    def __init__(self, console: Console, panes: Panes) -> None:
        self._console = console
        self._panes = panes
        self._paces = {pane: Pace(0.2) for pane in panes.tables}
        self._crowd_pace = Pace(0.5)
        self._floor_pace = Pace(0.2)
        self._made: dict[RowsPane, Table] = {}
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
        """Return fleet, alarms and queue, each the same table again until it is due. A crowd is not made in
        one tick with its map."""
        has_floor, self._has_floor = self._has_floor, False
        for pane, pace in self._paces.items():
            if pane is self._panes.fleet and self._is_crowd:
                pace = self._crowd_pace
            about = self._about(pane)
            is_in_turn = pane is not self._panes.fleet or about != pace.key or not has_floor
            if is_in_turn and pace.is_due(about):
                self._made.pop(pane, None)  # until it is made: after a fault it is due again
        return [self._made.get(pane) or self.of(pane) for pane in self._paces]

    def _about(self, pane: RowsPane) -> object:
        """Return what the rows of a pane are made for: at a change of it they are made at once."""
        state, robot = self._console.store.state, self._console.navigation.robot
        arranged = pane.arrangement.typed, pane.arrangement.column, pane.arrangement.groups.by
        shown: object = state.alarms
        if pane is self._panes.alarms:
            shown = state.alarms, pane.listing.cursor
        elif pane is self._panes.queue:
            robots = state.robots.values() if self.shows_all_orders else [state.robots[robot]]
            shown = [one.orders for one in robots], state.commands, self.shows_all_orders
        return robot, pane.size, arranged, shown

    def of(self, pane: RowsPane) -> Table:
        """Return the newest rows of one of these panes, as they are arranged."""
        navigation, settings = self._console.navigation, self._console.settings
        arranged = pane.row_width, pane.arrangement
        if pane is self._panes.fleet:
            table = fleet_table(navigation.here, navigation.robot, *arranged)
        elif pane is self._panes.alarms:
            key = "".join(map(key_name, settings.keys["next_trouble"][:1]))
            table = alarm_table(navigation.here, settings.clock, *arranged, pane.listing.cursor, key)
        else:
            may = self._console.dispatch.permissions.right >= Right.DISPATCH
            shows_all = self.shows_all_orders
            table = queue_table(navigation.here, navigation.robot, shows_all, *arranged, may, settings.clock)
        self._made[pane] = table
        return table

    def show(self, pane: RowsPane, sought: str = "") -> None:
        """Show the newest rows of a pane, the cursor on the best one sought, else on the selected robot."""
        if pane is self._panes.fleet and not pane.arrangement.typed:
            pane.listing.cursor = self._console.navigation.robot
        pane.show(self.of(pane), sought)

"""The newest rows of fleet, alarms and queue."""

from typing import TYPE_CHECKING

from fleet_tui.keys.key import key_name
from fleet_tui.model.fleet import CROWD
from fleet_tui.model.problem import Right
from fleet_tui.view.tables.alarms import alarm_table
from fleet_tui.view.tables.fleet import fleet_table
from fleet_tui.view.tables.queue import queue_table
from fleet_tui.view.tables.table import Table
from fleet_tui.widgets.pace import Pace
from fleet_tui.widgets.rows_pane import RowsPane

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen


class NewestRows:
    """Nobody reads values that change ten times a second, and all of a large fleet take a while to sort: the
    fleet's rows are made five times a second, of a crowd twice; the map of a crowd is made five times."""

    def __init__(self, screen: "MainScreen") -> None:
        self._screen = screen
        self._fleet_pace = Pace(0.2)
        self._crowd_pace = Pace(0.5)
        self._floor_pace = Pace(0.2)
        self._fleet: Table | None = None
        self._has_floor = False

    def is_floor_due(self) -> bool:
        """Tell whether to show the newest floor: of a crowd not at every tick, unless the map has a mode, as
        when a robot is driven."""
        screen = self._screen
        if len(screen.store.state.robots) < CROWD or screen.rest.map_pane.is_mode:
            return True
        self._has_floor = self._floor_pace.is_due((screen.navigation.selection, screen.rest.map.size))
        return self._has_floor

    def tables(self) -> list[Table]:
        """Return fleet, alarms and queue. The fleet is the same table again until it is due, or another
        robot, size, arrangement or alarm asks for it; a crowd is not made in one tick with its map."""
        screen, pane = self._screen, self._screen.fleet
        arranged = pane.arrangement.typed, pane.arrangement.column, pane.arrangement.groups.by
        pace = self._fleet_pace if len(screen.store.state.robots) < CROWD else self._crowd_pace
        asked = screen.navigation.robot, pane.size, arranged, screen.store.state.alarms
        has_floor, self._has_floor = self._has_floor, False
        if (asked != pace.key or not has_floor) and pace.is_due(asked):
            self._fleet = None  # until it is made: after a fault it is due again
        fleet = self._fleet or self.of(pane)
        return [fleet, self.of(screen.alarms), self.of(screen.queue)]

    def of(self, pane: RowsPane) -> Table:
        """Return the newest rows of one of these panes, as they are arranged."""
        screen, arranged = self._screen, (pane.row_width, pane.arrangement)
        state, robot = screen.navigation.here, screen.navigation.robot
        if pane is screen.fleet:
            self._fleet = fleet_table(state, robot, *arranged)
            return self._fleet
        if pane is screen.alarms:
            key = "".join(map(key_name, screen.settings.keys["next_trouble"][:1]))
            return alarm_table(state, screen.settings.clock, *arranged, pane.listing.cursor, key)
        may = screen.dispatch.permissions.right >= Right.DISPATCH
        return queue_table(state, robot, screen.shows_all_orders, *arranged, may, screen.settings.clock)

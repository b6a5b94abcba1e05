"""The main screen: map, fleet, alarms, queue, and what opens over the map."""

from collections.abc import Callable, Mapping

from rich.style import Style
from textual.app import ComposeResult
from textual.containers import Container

from fleet_tui.model import events
from fleet_tui.model.commands import Command
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.screens.navigation import Navigation
from fleet_tui.state.store import Store
from fleet_tui.view.lines.commands import message_line
from fleet_tui.view.lines.hints import hidden_keys, hints
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.selection import first_selection
from fleet_tui.view.tables.fleet import fleet_table
from fleet_tui.view.tables.queue import queue_table
from fleet_tui.widgets.bindings import bindings
from fleet_tui.widgets.line_view import LineView
from fleet_tui.widgets.panes import Panes
from fleet_tui.widgets.rows_pane import RowsPane


class MainScreen(Navigation):
    """Shows the newest state at every tick, and turns keys into wishes."""

    BINDINGS = [*bindings("console"), *bindings("recording")]  # noqa: RUF012  # as Textual declares it
    BLANK = True  # nothing is to be seen of the screen itself
    AUTO_FOCUS = "#map"
    HORIZONTAL_BREAKPOINTS = [(0, "-tiny"), (60, "-narrow"), (120, "-wide")]  # noqa: RUF012  # as Textual declares it
    VERTICAL_BREAKPOINTS = [(0, "-flat"), (16, "-tall")]  # noqa: RUF012  # as Textual declares it

    def __init__(
        self,
        store: Store,
        submit: Callable[[Command], None],
        tell: Callable[[events.Event], None],
        show_map: Callable[[str, str], bool],
        keys: dict[str, tuple[str, ...]],
        clock: Callable[[float], str],
    ) -> None:
        super().__init__()
        self.store, self.submit, self.tell = store, submit, tell
        self.selection = first_selection(store.state)
        self.status, self.message = LineView(id="status"), LineView(id="message")
        self.hints = LineView(id="hints", keep_right=True)
        self.furnished = False
        self.fleet = RowsPane(id="fleet", rows=len(store.state.robots))
        self.alarms, self.queue = RowsPane(id="alarms"), RowsPane(id="queue")
        self.read_only, self.armed = False, True
        self.themes: Mapping[str, Callable[[], None]] = {}
        self.announce: Callable[[FleetState], None] = lambda _state: None
        self.open_journal: Callable[[], None] = lambda: None
        self._show_map, self.keys, self.clock = show_map, keys, clock
        self._all_orders = False
        self.terminal = ""
        self.filled: Callable[[], None] = lambda: None
        self._mapped: tuple[str, str] | None = None

    def compose(self) -> ComposeResult:
        """The panes in the order of Tab; the map and what opens over them come after the first paint."""
        # Textual would find out after the first layout, and style and lay out all of it again.
        for cells, steps in zip(
            self.app.size, (self.HORIZONTAL_BREAKPOINTS, self.VERTICAL_BREAKPOINTS), strict=True
        ):
            self.add_class([name for least, name in steps if cells >= least][-1])
        yield self.status
        yield Panes(Container(id="map"), self.fleet, self.alarms, self.queue, id="panes")
        yield self.message
        yield self.hints

    async def furnish(self, drawing: Drawing) -> None:
        """Get what is not on the first picture: importing it takes as long as painting that."""
        from fleet_tui.screens.furniture import furnish

        await furnish(self, drawing)
        self.furnished = True

    def set_inks(self, styles: Mapping[StyleRole, Style]) -> None:
        """Change every colour."""
        for view in (self.status, self.fleet, self.alarms, self.queue, self.message, self.hints):
            view.set_inks(styles)
        if self.furnished:
            for more in (self.map, self.audit_log.rows, self.diagnostics):
                more.set_inks(styles)
        if self.time_line is not None:
            self.time_line.set_inks(styles)

    def on_resize(self) -> None:
        """Fill the panes at their new size."""
        self.tick()
        self.filled()

    def tick(self) -> None:
        """Show the newest state."""
        self.release_held()
        state = self.state
        if self.furnished:
            self._show_floor(state)
        self.fleet.show(fleet_table(state, self.selection.robot, self.fleet.room))
        self.show_alarms(state)
        self.queue.show(queue_table(state, self.selection.robot, self._all_orders, self.queue.room))
        self.show_status(state)
        self.message.show(message_line(state, self.said, self._said_at, self.message.size.width))
        pane = "anywhere" if self.in_overlay else self._focused_pane()
        hidden = hidden_keys(state, self.selection.robot)
        self.hints.show(*hints(self.keys, pane, not self.read_only, hidden))
        self.announce(state)
        if self.simple is not None and self.simple.children:  # none while the console ends
            self.simple.show()

    def _show_floor(self, state: FleetState) -> None:
        from fleet_tui.view.map.floor_scene import chart_robot, floor_scene

        self.selection = self.selection.settled(state, self.map.viewport.follow)
        self._ask_for_map(chart_robot(state, self.selection))
        self.map.show(floor_scene(state, self.selection))

    def _focused_pane(self) -> str:
        if self.player is not None:
            return "recording"
        return "map" if not self.furnished or self.focused is self.map else self.pane_of_keys

    def _ask_for_map(self, owner: Robot | None) -> None:
        """The live map of what is shown, unless a file gives it."""
        has_file = self.state.floors[self.selection.floor].grid is not None
        wanted = (owner.name, "" if has_file else self.selection.floor) if owner else None
        if wanted is not None and wanted != self._mapped and self._show_map(*wanted):
            self._mapped = wanted

    def action_all_orders(self) -> None:
        """The selected robot's orders, or all robots'."""
        self._all_orders = not self._all_orders
        self.tick()

    def action_help(self) -> None:
        """Every key there is."""
        hidden = hidden_keys(self.state, self.selection.robot)
        kind = self.state.robots[self.selection.robot].kind
        self.key_help.show(self._focused_pane(), self.terminal, kind, hidden)

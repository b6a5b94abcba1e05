"""Moving about: which robot and floor are looked at, and what the panes ask for."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import TYPE_CHECKING

from msgspec.structs import replace
from textual import on
from textual.screen import Screen

from fleet_tui.keys import KEYS
from fleet_tui.screens.alarm_actions import AlarmActions
from fleet_tui.screens.audit_actions import AuditActions
from fleet_tui.screens.diagnostics_actions import DiagnosticsActions
from fleet_tui.screens.incident_actions import IncidentActions
from fleet_tui.screens.overlay import Overlay
from fleet_tui.screens.playback_actions import PlaybackActions
from fleet_tui.screens.save_actions import SaveActions
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.lines.hints import hidden_keys
from fleet_tui.widgets import messages
from fleet_tui.widgets.rows_pane import RowsPane

if TYPE_CHECKING:
    from fleet_tui.screens.help import Help
    from fleet_tui.screens.palette import Palette
    from fleet_tui.screens.simple import Simple
    from fleet_tui.screens.typed import Entry
    from fleet_tui.widgets.map_view import MapView

NOT_WISHED = {"palette", "back", "next_pane", "previous_pane", "help_anywhere", "pause_all_anywhere"}


class Navigation(
    PlaybackActions,
    AlarmActions,
    AuditActions,
    DiagnosticsActions,
    IncidentActions,
    SaveActions,
    Screen[None],
):
    """The selection, by key, by mouse and by name."""

    map: "MapView"
    fleet: RowsPane
    simple: "Simple | None" = None
    key_help: "Help"
    palette: "Palette"
    themes: Mapping[str, Callable[[], None]]

    def select(self, robot: str) -> None:
        """Select a robot; the fleet's cursor is on the selected one."""
        self.selection, self.fleet.cursor = self.selection.on_robot(robot), robot
        self.tick()

    def find_robot(self, robot: str) -> None:
        """Select a robot and bring the map to it."""
        self.select(robot)
        self.selection = self.selection.settled(self.state, follow=True)
        self.tick()
        self.map.action_centre()

    def find_floor(self, floor: str) -> None:
        """Show a floor."""
        self.selection = replace(self.selection, floor=floor, chosen=True)
        self.tick()

    def find_vertex(self, floor: str, x: float, y: float) -> None:
        """Bring the map to a place of a floor."""
        self.find_floor(floor)
        self.map.centre_on(x, y)

    def action_step_robot(self, step: int) -> None:
        """The next or previous robot."""
        self.select(self.selection.step_robot(self.state, step).robot)

    def action_robot(self, number: int) -> None:
        """A robot by its number."""
        names = list(self.state.robots)
        if number <= len(names):
            self.select(names[number - 1])

    def action_step_floor(self, step: int) -> None:
        """The next or previous floor."""
        self.find_floor(self.selection.step_floor(self.state, step).floor)

    async def action_simple(self) -> None:
        """The simple interface in the map's place, or the map again. It is made when it is first wanted."""
        from fleet_tui.screens.simple import Simple

        panes = self.query_one("#panes")
        if not panes.has_class("-simple") and not self.may_order():
            return
        if self.simple is None:
            simple = Simple(lambda: self.state, lambda: self.selection.robot, self.select, self.give)
            await panes.mount(simple, before=self.map)
            self.simple = simple  # not before: ticks that come meanwhile would look for what it is made of
        if panes.toggle_class("-simple").has_class("-simple"):
            self.simple.start()
        else:
            self.set_focus(self.map)

    def action_back(self) -> None:
        """One level back: the map's cursor goes, then the focus to the map."""
        if self.map.look.cursor is not None:
            self.map.action_cursor()
        if self.map.display:
            self.set_focus(self.map)

    def action_on_map(self, action: str, *args: int) -> None:
        """Something that the map does, whatever pane has the focus."""
        getattr(self.map, f"action_{action}")(*args)

    def action_palette(self) -> None:
        """Everything that can be done, by name."""
        self.palette.show()

    def wishes(self) -> "Iterator[Entry]":
        """Everything the palette offers."""
        hidden = NOT_WISHED | hidden_keys(self.state, self.selection.robot)
        for key in KEYS:
            if key.pane in (*self.panes, "anywhere") and key.id not in hidden:
                yield key.text, partial(self.call_later, self.run_action, key.action)
        for name in self.state.robots:
            yield f"Go to robot {name}", partial(self.find_robot, name)
        for floor in self.state.floors:
            yield f"Go to floor {floor}", partial(self.find_floor, floor)
        for floor, chart in self.state.robots[self.selection.robot].charts.items():
            for id_, label in chart.labels.items():
                vertex = chart.graph.vertices.get(id_) if chart.graph else None
                if vertex is not None:
                    yield (
                        f"Go to vertex {sanitize(label)}",
                        partial(self.find_vertex, floor, vertex.x, vertex.y),
                    )
        for name, use in self.themes.items():
            yield f"Theme: {sanitize(name)}", use

    @property
    def in_overlay(self) -> bool:
        """Whether the focus is in what is open over the panes: most keys stay in there."""
        focused = self.focused
        return focused is not None and any(isinstance(one, Overlay) for one in focused.ancestors_with_self)

    def on_descendant_focus(self) -> None:
        """What is open goes, undone, when the mouse gives the focus to something outside it."""
        for overlay in self.query(Overlay):
            if overlay.is_open and (self.focused is None or overlay not in self.focused.ancestors_with_self):
                overlay.display = False

    @on(messages.RobotPicked)
    def robot_picked(self, event: messages.RobotPicked) -> None:
        """A robot on the map."""
        self.select(event.name)

    @on(messages.VertexPicked)
    def vertex_picked(self, event: messages.VertexPicked) -> None:
        """A vertex on the map: an order from it, or with cargo on board to it."""
        self.order_at(event.id, self.selection.floor)

    @on(messages.RowPicked)
    def row_picked(self, event: messages.RowPicked) -> None:
        """The fleet's cursor selects."""
        # The cursor may have moved on since.
        if event.pane == "fleet" and event.key == self.fleet.cursor:
            self.select(str(event.key))

    @on(messages.RowChosen)
    def row_chosen(self, event: messages.RowChosen) -> None:
        """The menu of a row."""
        match event.pane, event.key:
            case "fleet", str(robot):
                self.robot_menu(robot)
            case "queue", (str(robot), str(order_id), _):
                self.queue_menu(robot, order_id)
            case "alarms", (str(source), str(kind)):
                self.alarm_menu(source, kind)

    @on(messages.ButtonPressed)
    def button_pressed(self, event: messages.ButtonPressed) -> None:
        """A button of the queue."""
        match event.name, event.key:
            case "cancel", (str(robot), str(order_id), _):
                self.ask_cancel(robot, order_id)
            case "clear", _:
                self.action_clear()

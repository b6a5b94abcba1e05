"""The main screen: map, fleet, alarms, queue, and the overlays over the map."""

from collections.abc import Mapping
from functools import partial
from inspect import isawaitable
from typing import TYPE_CHECKING

from msgspec.structs import replace
from rich.style import Style
from textual import on
from textual.app import ComposeResult
from textual.geometry import Size
from textual.screen import Screen
from textual.widgets import Input

from fleet_tui.keys import BY_ID, Pane
from fleet_tui.model.fleet import FleetState
from fleet_tui.state.store import Store
from fleet_tui.text.language import Message, counted
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.backend import Backend
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.dispatch import Ask, Dispatch
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.controllers.marked_alarm import MarkedAlarm
from fleet_tui.ui.controllers.navigation import Navigation
from fleet_tui.ui.controllers.notices import Notices
from fleet_tui.ui.controllers.session import OpenSession
from fleet_tui.ui.controllers.settings import ConsoleSettings
from fleet_tui.ui.screens.overlay import Overlay
from fleet_tui.ui.screens.robot.overlay import RobotOverlay
from fleet_tui.ui.screens.tables.pane_rows import PaneRows
from fleet_tui.ui.view.lines.commands import message_line
from fleet_tui.ui.view.lines.hints import hidden_keys, idle_hints, other_alarmed, unoffered_keys
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.alarms import alarm_of
from fleet_tui.ui.view.tables.recent import recent_table
from fleet_tui.ui.view.tables.selected_robot import robot_page
from fleet_tui.ui.widgets import messages
from fleet_tui.ui.widgets.background import run_in_background
from fleet_tui.ui.widgets.bindings import bindings
from fleet_tui.ui.widgets.key_line import KeyLine
from fleet_tui.ui.widgets.line_view import LineView
from fleet_tui.ui.widgets.panes import Panes
from fleet_tui.ui.widgets.runs_view import RunsView

if TYPE_CHECKING:
    from fleet_tui.console.features import Features

MOST_NAMED = 5
"""Robots that a notice names; of more it has the number."""


class MainScreen(Screen[None]):
    """Shows the newest state at every tick, and forwards keys and mouse to the controllers."""

    BINDINGS = [*bindings(Pane.CONSOLE), *bindings(Pane.RECORDING)]  # noqa: RUF012  # as Textual declares it
    BLANK = True  # the screen itself is covered completely
    AUTO_FOCUS = "#map"
    HORIZONTAL_BREAKPOINTS = [(0, "-tiny"), (60, "-narrow"), (120, "-wide")]  # noqa: RUF012  # as Textual declares it
    VERTICAL_BREAKPOINTS = [(0, "-flat"), (16, "-low"), (24, "-tall")]  # noqa: RUF012  # as Textual declares it

    features: "Features"

    def __init__(
        self,
        store: Store,
        backend: Backend,
        settings: ConsoleSettings,
        files: ConsoleFiles,
        open_session: OpenSession,
    ) -> None:
        super().__init__()
        self.store = store
        self.backend = backend
        self.settings = settings
        self.files = files
        self.is_complete = False
        self.status = LineView(id="status")
        self.message = LineView(id="message")
        self.hints = KeyLine(settings.keys, id="hints")
        self.panes = Panes(settings.drawing is Drawing.ASCII)
        self.fleet = self.panes.fleet
        self.alarms = self.panes.alarms
        self.queue = self.panes.queue
        self.views: list[RunsView] = [self.status, *self.panes.views, self.message, self.hints]
        self._sizes = list[Size]()
        self._robots = tuple(store.state.robots)
        self.notices = Notices(store, self.tick, settings.message)
        self.navigation = Navigation(store, self._mark_robot, lambda: self.features.map_controls, self.tick)
        ask: Ask = lambda *asked: self.features.confirm.ask(*asked)  # noqa: E731  # mounted later
        self.dispatch = Dispatch(store, backend, settings.permissions, self.notices, ask)
        self.console_parts = Console(
            store=store,
            backend=backend,
            dispatch=self.dispatch,
            notices=self.notices,
            navigation=self.navigation,
            files=files,
            settings=settings,
            ask=ask,
            open_menu=lambda *shown, **options: self.features.menu.show(*shown, **options),
            begin=lambda line: self.features.palette.show(line),
            in_background=partial(run_in_background, self),
            say_from_thread=lambda text: self.app.call_from_thread(self.notices.say, text),
        )
        self.rows = PaneRows(self.console_parts, self.panes)
        self.marked_alarm = MarkedAlarm(self.alarms)
        self.session = open_session(self.console_parts, self._forget_trails)
        self.unoffered = unoffered_keys(self.session.offers, settings.permissions.right)

    def compose(self) -> ComposeResult:
        """Compose the panes in the order of Tab; the map and the overlays are mounted after the first
        paint."""
        # Textual would detect it after the first layout, and repeat style and layout.
        for cells, steps in zip(
            self.app.size, (self.HORIZONTAL_BREAKPOINTS, self.VERTICAL_BREAKPOINTS), strict=True
        ):
            self.add_class([name for least, name in steps if cells >= least][-1])
        yield self.status
        yield self.panes
        yield self.message
        yield self.hints

    async def mount_features(self) -> None:
        """Mount the widgets missing in the first picture: their import takes as long as painting that."""
        from fleet_tui.console.features import Features

        self.features = Features(
            self, self.console_parts, self.session, self.panes, self.rows, self.marked_alarm
        )
        await self.features.mount()
        self.is_complete = True

    def set_role_styles(self, styles: Mapping[StyleRole, Style]) -> None:
        """Change every colour."""
        for view in [*self.views, *(self.features.styled if self.is_complete else [])]:
            view.set_role_styles(styles)

    def on_mount(self) -> None:
        """Share out the lines before the first layout."""
        self.tick()

    def on_resize(self) -> None:
        """Fill the panes at their new sizes."""
        sizes = [self.size, *(view.size for view in self.views)]
        if sizes != self._sizes:  # Textual sends the first size three times
            self._sizes = sizes
            self.tick()
        self.settings.resized()

    def tick(self) -> None:
        """Show the newest state."""
        self.dispatch.release_startup()
        self._note_added()
        whole, state, robot = self.store.state, self.navigation.here, self.navigation.robot
        if self.is_complete:
            if self.features.tables.filter_line.goes_first:
                return
            if self.rows.is_floor_due(self.features.map_pane.is_mode, self.features.map.size):
                self._show_floor(state)
            self.features.show()
        self.marked_alarm.look(state)
        clock, covered = self.settings.clock, self.features.covered if self.is_complete else 0
        page, recent = partial(robot_page, state, clock=clock), partial(recent_table, state, clock)
        self.panes.show(state, self.rows.tables(), robot, page, recent, covered)
        self.status.show(*self.session.headline(whole, robot, self.status.size.width))
        said, width = self.notices, self.message.size.width
        self.message.show(message_line(whole, said.text, said.at, width, said.key_at, said.is_hint))
        self._show_hints(state, robot)
        self.settings.announce(whole)

    def _note_added(self) -> None:
        robots = tuple(self.store.state.robots)
        if added := robots[len(self._robots) :]:
            self._robots = robots
            names = ", ".join(added) if len(added) <= MOST_NAMED else str(len(added))
            self.notices.note(
                sanitize(Message("added, as they appeared on the broker: {names}", names=names))
            )

    def tell_dropped(self, count: int, stood_still: bool) -> None:
        """Say how many keys were dropped because they were typed for another place."""
        keys = counted("{count} key dropped", "{count} keys dropped", count)
        why = (
            Message("typed while nothing could be shown") if stood_still else Message("typed on after Enter")
        )
        self.notices.say(Message("{keys}, {why}: Esc ends this, F12 pauses all", keys=keys, why=why))

    def _show_hints(self, state: FleetState, robot: str) -> None:
        types = self._in_overlay() or isinstance(self.focused, Input)
        pane = Pane.ANYWHERE if types else self.focused_pane()
        idle = idle_hints(state, robot) | (self.features.set_up.snap.idle_keys if self.is_complete else set())
        about = self.focused.KEY if isinstance(self.focused, RobotOverlay) else ""
        hidden = hidden_keys(state, robot) | idle | self.unoffered | {about}
        focused = (self.focused and self.focused.id) or ""
        alarmed = other_alarmed(self.alarms.listing.cursor, robot)
        may_command = not self.dispatch.permissions.read_only
        self.hints.offer(pane, may_command, hidden, focused, alarmed, bool(about))

    def _mark_robot(self, robot: str) -> None:
        """Put the cursors of fleet and alarms on a robot; they are drawn with the next rows."""
        self.fleet.listing.cursor = robot
        if (key := alarm_of(self.store.state, robot)) is not None:
            # An acknowledgement after a choice means that robot.
            self.alarms.listing.choose(key)

    def _show_floor(self, state: FleetState) -> None:
        from fleet_tui.ui.screens.ordering.route_line import show_route
        from fleet_tui.ui.view.map.floor_scene import floor_scene

        selection = self.navigation.settle(state, self.features.map.picture.viewport.follow)
        drafted = show_route(self.features.order_form, state)
        if drafted is not None and drafted[0].marked is not None:
            selection = replace(selection, floor=drafted[0].marked.floor)
        self.features.live_map.show(state, selection, others=self.panes.has_small_maps)
        scene = self.features.streams.on(floor_scene(state, selection, drafted))
        self.features.show_scene(self.features.set_up.mapping.on(scene))

    def _forget_trails(self) -> bool:
        if self.is_complete:
            self.features.map.picture.clear_trails()
        return self.is_complete

    def focused_pane(self) -> Pane:
        """Return the pane whose keys help and footer list first."""
        if not self.is_complete:
            return self.session.pane or Pane.MAP
        return self.features.focused_pane()

    async def action_key(self, id_: str) -> None:
        self.notices.key_pressed()
        done = self.features.actions[id_]()
        if isawaitable(done):
            await done

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool | None:
        """Disable keys without a use in this session, and in a text field those that are letters there."""
        if action != "key":
            return super().check_action(action, parameters)
        key = BY_ID[str(parameters[0])]
        if not self.session.offers(key) or (self.is_complete and self.features.blocks(key)):
            return False
        return not (key.in_dialogs and isinstance(self.focused, Input))

    def _in_overlay(self) -> bool:
        """Tell whether the focus is in an overlay: most keys stay in there."""
        focused = self.focused
        return focused is not None and any(isinstance(one, Overlay) for one in focused.ancestors_with_self)

    def on_descendant_focus(self) -> None:
        """Close the overlay, without its effect, when a click outside it takes the focus."""
        for overlay in self.query(Overlay):
            if overlay.is_open and (self.focused is None or overlay not in self.focused.ancestors_with_self):
                overlay.display = False

    @on(messages.RobotPicked)
    @on(messages.VertexPicked)
    @on(messages.FloorPicked)
    @on(messages.PlacePicked)
    @on(messages.RowPicked)
    @on(messages.RowChosen)
    @on(messages.ButtonPressed)
    @on(messages.TimePicked)
    def picked(self, event: messages.Picked) -> None:
        """Forward a click or selection of the operator."""
        self.features.picked(event)

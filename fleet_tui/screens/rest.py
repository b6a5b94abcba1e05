"""Parts of the main screen after its first paint: the map, the overlays, and their controllers."""

from functools import partial
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from fleet_tui.controllers.alarms import AlarmResponses
from fleet_tui.controllers.editing.checks import DraftChecks
from fleet_tui.controllers.editing.drawing import GraphDrawing
from fleet_tui.controllers.editing.edge_values import EdgeValues
from fleet_tui.controllers.editing.editor import GraphEditor
from fleet_tui.controllers.editing.files import DraftFiles
from fleet_tui.controllers.editing.old_files import OldFiles
from fleet_tui.controllers.editing.route_files import RouteFiles
from fleet_tui.controllers.editing.sending import DraftSending
from fleet_tui.controllers.editing.values import VertexValues
from fleet_tui.controllers.history.note import NoteCommand
from fleet_tui.controllers.map import MapControls
from fleet_tui.controllers.offers import Offers
from fleet_tui.controllers.ordering.orders import OrderRequests
from fleet_tui.controllers.parts import SetUpParts
from fleet_tui.controllers.robots import RobotRequests
from fleet_tui.controllers.save import SaveCommand
from fleet_tui.controllers.set_up.camera import CameraControls, PictureTerminal
from fleet_tui.controllers.set_up.live_map import LiveMap
from fleet_tui.controllers.set_up.mapping import MappingControls
from fleet_tui.controllers.set_up.poses import PoseRequests
from fleet_tui.controllers.set_up.snap import PoseSnap
from fleet_tui.controllers.set_up.streams import ShownStreams
from fleet_tui.controllers.typed import Typed
from fleet_tui.keys import Key, Pane
from fleet_tui.keys.drive import PASSES
from fleet_tui.keys.key import key_name
from fleet_tui.rules.causes import wants_causes
from fleet_tui.screens.audit import AuditLog
from fleet_tui.screens.camera_switch import CameraSwitch
from fleet_tui.screens.confirm import Confirm
from fleet_tui.screens.desk.opening import desk_and_facilities, join_desk
from fleet_tui.screens.diagnosing.overlay import Diagnostics
from fleet_tui.screens.diagnosing.pages import Pages
from fleet_tui.screens.driving import drive_controls, release_key
from fleet_tui.screens.help import Help
from fleet_tui.screens.history.overlay import HistoryOverlay, history_overlay
from fleet_tui.screens.key_actions import key_actions
from fleet_tui.screens.menu import Menu
from fleet_tui.screens.ordering.opening import order_form
from fleet_tui.screens.palette import Palette
from fleet_tui.screens.programs import Programs, programs_overlay
from fleet_tui.screens.robot.page import RobotPage, robot_page_overlay
from fleet_tui.screens.routines import Routines, routines_overlay
from fleet_tui.screens.simple import simple_switch
from fleet_tui.screens.tables.tools import TableTools
from fleet_tui.screens.why import Why
from fleet_tui.terminal.lean_app import LeanApp
from fleet_tui.view.map.drawing import Drawing
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.map.scene import Scene
from fleet_tui.widgets.background import run_in_background
from fleet_tui.widgets.bindings import action_of
from fleet_tui.widgets.camera_view import CameraView
from fleet_tui.widgets.dialog_place import lines_below
from fleet_tui.widgets.map_view import MapView
from fleet_tui.widgets.runs_view import RunsView
from fleet_tui.widgets.small_maps_view import SmallMapsView

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen


CURSORS = frozenset({"map_cursor", "next_vertex", "previous_vertex", "pose", "goal", "drive"})
"""Keys that move the map's own cursor, or begin another mode: a mode has its own, and is left first."""


class Rest:
    """Widgets and controllers with their dependencies, and the action of every key."""

    styled: list[RunsView | Diagnostics | HistoryOverlay | Programs | Routines | RobotPage]
    robots: RobotRequests
    alarms: AlarmResponses
    _covers = False
    _has_few_colours = False

    def __init__(self, screen: "MainScreen") -> None:
        self._screen = screen
        self._navigation = screen.navigation
        self._session = screen.session
        store, settings, dispatch = screen.store, screen.settings, screen.dispatch
        navigation, notices, backend = screen.navigation, screen.notices, screen.backend
        self.map = MapView(id="map")
        self.small_maps = SmallMapsView("other-floors"), SmallMapsView("other-floors-below")
        self.map.picture.options = MapOptions(drawing=settings.drawing)
        to_next, menu = settings.keys["next_vertex"], lambda: self.robots.menu(navigation.robot)
        self.live_map = LiveMap(screen.backend.show_map)
        self.key_help = Help()
        self.map_controls = MapControls(self.map, notices.say, to_next, menu)
        self.confirm = Confirm(id="confirm")
        self.menu = Menu(id="menu")
        self.tables = TableTools(screen, self.confirm.ask)
        self.order_form, self.anyone = order_form(screen, self.confirm.ask, self.tables.marked.give_order)
        self.streams = ShownStreams(store, backend, navigation, notices, self.map.picture)
        self.why = Why(lambda: (store.state, navigation.robot), settings.keys, self.streams, backend)
        self.audit_log = AuditLog(screen.files)
        self.robot_page = robot_page_overlay(screen, self)
        self._add_tools(screen)
        self._answer_menus(screen)
        self.save = SaveCommand(
            screen.files, self.confirm.ask, lambda line: self.palette.show(line), notices.say
        )
        offers = Offers(
            store, dispatch, navigation, screen.session, self.save, settings, partial(_run, screen)
        )
        self.palette = Palette(offers.entries, lambda line: self._typed_set_up(line) or offers.typed(line))
        self._set_up_with(SetUpParts(store, dispatch, navigation, notices, self.menu.show, self.palette.show))
        self.simple = simple_switch(screen, self)
        self._add_camera(screen)
        self.actions = key_actions(screen, self)

    def _add_tools(self, screen: "MainScreen") -> None:
        store, settings, asks = screen.store, screen.settings, (self.confirm.ask, self.menu.show)
        self.programs = programs_overlay(screen, *asks)
        self.routines = routines_overlay(screen, *asks, partial(run_in_background, screen))
        pages = Pages(lambda: store.state, screen.backend, settings.clock)
        self.diagnostics = Diagnostics(pages, settings.keys)
        self.history = history_overlay(screen, self)
        self.note = NoteCommand(screen.files, screen.notices.say)
        self.styled = [self.map, self.audit_log.rows, self.diagnostics, *self.key_help.views]
        self.styled += [self.programs, self.routines, *self.small_maps, self.robot_page, self.history]

    def _add_camera(self, screen: "MainScreen") -> None:
        view = CameraView()
        app = screen.app
        assert isinstance(app, LeanApp)
        terminal = PictureTerminal(
            lambda: app.output.budget.sent.bytes,
            screen.settings.picture_limit,
            lambda: self._has_few_colours or self.map.picture.options.drawing is Drawing.ASCII,
        )
        selected, in_background = lambda: self._navigation.robot, partial(run_in_background, screen)
        self.camera = CameraControls(screen.store, screen.backend, selected, view, in_background, terminal)
        self.camera_switch = CameraSwitch(screen.panes, self.map, view, self.camera, screen.notices.say)
        self.styled.append(view)

    def _answer_menus(self, screen: "MainScreen") -> None:
        parts = screen.store, screen.dispatch, screen.notices, screen.navigation
        self.orders = OrderRequests(
            *parts,
            queue=screen.queue,
            open_form=self.order_form.start,
            open_menu=self.menu.show,
            clock=screen.settings.clock,
            marked=self.tables.marked,
        )
        self.robots = RobotRequests(
            *parts,
            orders=self.orders,
            open_menu=self.menu.show,
            why=self.why.show,
            alarm_menu=lambda *alarm: self.alarms.menu(*alarm),
            marked=self.tables.marked,
            keys=screen.settings.keys,
        )
        self.alarms = AlarmResponses(
            screen.store,
            screen.backend,
            screen.notices,
            screen.navigation,
            pane=screen.alarms,
            open_menu=self.menu.show,
            why=self.why.show,
            robot_menu=self.robots.menu,
            charge=self.orders.charge,
            keys=screen.settings.keys,
            clock=screen.settings.clock,
            cleared_at=lambda: screen.alarm_cleared_at,
        )

    def _set_up_with(self, parts: SetUpParts) -> None:
        keys = self._screen.settings.keys
        ask, comparison = self.confirm.ask, self.streams.comparison
        streams, controls, picture = self._screen.backend.streams, self.map_controls, self.map.picture
        in_background = partial(run_in_background, self._screen)
        self.poses = PoseRequests(*parts[:4], ask, controls, picture, comparison)
        self.snap = PoseSnap(parts, streams, controls, picture, in_background)
        self.editor = GraphEditor(parts, controls, picture, self._screen.files.draft)
        self.checks = DraftChecks(parts, self.editor, in_background)
        files, old_files = self._screen.files, OldFiles()
        self.draft_files = DraftFiles(parts, self.editor, self.checks, files, ask, old_files)
        route_files = RouteFiles(parts, self.editor, files, self._screen.backend.post, old_files)
        doubt = self._screen.settings.doubt
        self.sending = DraftSending(parts, self.editor, self.checks, files, route_files, doubt)
        say_from_thread = partial(self._screen.app.call_from_thread, self._screen.notices.say)
        self.mapping = MappingControls(parts, picture, files, ask, in_background, say_from_thread)
        self.values = VertexValues(parts, self.editor)
        self.edge_values = EdgeValues(parts, self.editor)
        self.drawing = GraphDrawing(parts, self.editor, self.values, self.edge_values)
        self.drives = drive_controls(self._screen, self, parts)
        self.desk, self.facilities = desk_and_facilities(self._screen, parts)
        self.release_key = partial(release_key, self.drives, keys)

    def _typed_set_up(self, line: str) -> Typed | None:
        """Parse a typed line that is about the desk, the draft or the map, None for any other."""
        takers = (self.anyone, self.note, self.desk, self.facilities, self.values, self.edge_values)
        found = (one.typed(line) for one in (*takers, self.draft_files, self.mapping))
        return next(filter(None, found), None)

    async def mount(self, screen: "MainScreen") -> None:
        """Mount all widgets, the focus on the map. The audit log starts before there is a link."""
        panes, below_map = screen.panes, (self.why, self.order_form, self.menu)
        opens = (*below_map, self.confirm, self.key_help, self.palette)
        with screen.app.batch_update():
            await screen.query_one("#map").remove()
            await panes.floor.mount(self.camera_switch.view, self.map, before=0)
            if len(screen.store.state.floors) > 1:
                await panes.mount_small_maps(*self.small_maps)
            tools = (self.audit_log, self.diagnostics, self.history, self.programs, self.routines)
            await screen.mount(*opens, *tools, *self.tables.widgets, self.robot_page)
            panes.place_dialogs(*below_map)
            if (time_line := screen.session.time_line()) is not None:
                self.styled.append(time_line)
                await screen.mount(time_line, before="#hints")
        has_few_colours = not screen.app.is_headless and screen.app.console.color_system == "standard"
        self._has_few_colours = screen.app.ansi_color or has_few_colours
        self.map.picture.hatch(self._has_few_colours)
        self.map.picture.hint = "".join(key_name(key) for key in screen.settings.keys["help"][:1])
        screen.set_focus(self.map)
        screen.files.open()
        join_desk(screen)

    def show_scene(self, scene: Scene) -> None:
        """Show a scene on the map, at the same scale until no panel covers a part of it any more."""
        self.drives.look(scene)
        covers = self.why.is_open or self.menu.is_open or self.order_form.is_open
        self.map.picture.viewport.holds = covers or self._covers
        self._covers = covers
        self._screen.panes.show_map(self.map, scene)
        state, options = self._navigation.here, self.map.picture.options
        for small_maps in self.small_maps:
            small_maps.show(state, replace(self._navigation.selection, floor=scene.floor), options)

    def show(self) -> None:
        """Show the newest state in the place of the map."""
        are_read = any(one.is_open for one in (self.diagnostics, self.why, self.robot_page))
        selected = self._navigation.selection.robot
        are_read = are_read or wants_causes(self._screen.store.state, selected)
        self._screen.backend.subscribe_logs(are_read)
        self.simple.show()
        self.order_form.look()
        self.camera.look()
        self.tables.outcomes.look()
        self.robot_page.collect()

    @property
    def covered(self) -> int:
        """Return the lines at the bottom that an overlay about the map covers."""
        return max(map(lines_below, (self.order_form, self.why, self.menu)))

    @property
    def map_pane(self) -> Pane:
        """Return the pane of the keys that work on the map now."""
        if self.editor.is_open:
            return Pane.EDIT
        if self.drives.mode is not None:
            return Pane.DRIVE
        return Pane.PLACE if self.poses.mode is not None else Pane.MAP

    def blocks(self, key: Key[Any]) -> bool:
        """Tell whether a key does nothing now: keys of modes work in theirs alone, and in a drive all others
        stop the robot."""
        mode = self.map_pane
        if mode.is_mode and key.id in CURSORS:
            return True
        in_mode = mode.is_mode and self._screen.focused is self.map
        if key.pane.is_mode:
            return not (in_mode and key.pane is mode)
        return in_mode and mode is Pane.DRIVE and key.id not in PASSES


def _run(screen: "MainScreen", key: Key[Any]) -> None:
    """Run the action of a key, after the current one."""
    screen.call_later(screen.run_action, action_of(key))

"""All of the main screen that is missing in its first picture: the map, the overlays, the controllers behind
them, and the action of every key, click and typed line."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import assert_never

from msgspec.structs import replace
from textual.screen import Screen

from fleet_tui.features.audit.feature import audit_feature
from fleet_tui.features.desk.commands import DeskCommands
from fleet_tui.features.desk.feature import desk_feature
from fleet_tui.features.desk.notes import join_desk
from fleet_tui.features.drive.feature import HandDriving
from fleet_tui.features.graphs.feature import GraphEditing
from fleet_tui.features.history.feature import history_feature
from fleet_tui.features.programs.feature import programs_feature
from fleet_tui.features.recording.feature import recording_feature
from fleet_tui.features.routines.feature import routines_feature
from fleet_tui.features.set_up.camera import CameraControls, PictureTerminal
from fleet_tui.features.set_up.camera_switch import CameraSwitch
from fleet_tui.features.set_up.feature import SetUp
from fleet_tui.features.set_up.live_map import LiveMap
from fleet_tui.keys import KEYS, Key, Pane
from fleet_tui.keys.drive import PASSES
from fleet_tui.keys.key import key_name
from fleet_tui.model.alarm import Key as AlarmKey
from fleet_tui.model.robot_numbers import numbered
from fleet_tui.situation.alarms.trouble import alarms_of_none, in_turn, next_in_trouble
from fleet_tui.situation.battery.charging import has_low_battery
from fleet_tui.situation.causes import wants_causes
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.alarms import AlarmResponses
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.controllers.marked_alarm import MarkedAlarm
from fleet_tui.ui.controllers.offers import Offers
from fleet_tui.ui.controllers.ordering.any_robot import AnyoneOrders
from fleet_tui.ui.controllers.ordering.orders import OrderRequests
from fleet_tui.ui.controllers.ordering.past_orders import PastOrders
from fleet_tui.ui.controllers.robots import RobotRequests
from fleet_tui.ui.controllers.save import SaveCommand
from fleet_tui.ui.controllers.session import ConsoleSession
from fleet_tui.ui.controllers.streams import ShownStreams
from fleet_tui.ui.controllers.tables.facilities import FacilityList
from fleet_tui.ui.controllers.typed import Typed
from fleet_tui.ui.screens.confirm import Confirm
from fleet_tui.ui.screens.diagnosing.overlay import Diagnostics
from fleet_tui.ui.screens.diagnosing.pages import Pages
from fleet_tui.ui.screens.help import Help
from fleet_tui.ui.screens.menu import Menu
from fleet_tui.ui.screens.ordering.form import OrderForm
from fleet_tui.ui.screens.palette import Palette
from fleet_tui.ui.screens.robot.page import PageSource, RobotPage
from fleet_tui.ui.screens.simple import SimpleSwitch
from fleet_tui.ui.screens.tables.paged_overlay import TableOverlay
from fleet_tui.ui.screens.tables.pane_rows import PaneRows
from fleet_tui.ui.screens.tables.tools import TableTools
from fleet_tui.ui.screens.why import Why
from fleet_tui.ui.terminal.lean_app import LeanApp
from fleet_tui.ui.view.help.pages import help_pages
from fleet_tui.ui.view.lines.hints import hidden_keys, unoffered_keys
from fleet_tui.ui.view.map.drawing import Drawing
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.tables.groups import GroupHead
from fleet_tui.ui.widgets import messages
from fleet_tui.ui.widgets.bindings import action_of, textual_key
from fleet_tui.ui.widgets.camera_view import CameraView
from fleet_tui.ui.widgets.dialog_place import lines_below
from fleet_tui.ui.widgets.map_view import MapView
from fleet_tui.ui.widgets.panes import Panes
from fleet_tui.ui.widgets.rows_pane import RowsPane
from fleet_tui.ui.widgets.runs_view import RunsView
from fleet_tui.ui.widgets.small_maps_view import SmallMapsView

CURSORS = frozenset({"map_cursor", "next_vertex", "previous_vertex", "pose", "goal", "drive"})
"""Keys that move the map's own cursor, or begin another mode: a mode has its own, and is left first."""


class Features:
    """Widgets and controllers with their dependencies."""

    styled: list[RunsView | TableOverlay | RobotPage]
    _covers = False
    _has_few_colours = False

    def __init__(
        self,
        screen: Screen[None],
        console: Console,
        session: ConsoleSession,
        panes: Panes,
        rows: PaneRows,
        marked_alarm: MarkedAlarm,
    ) -> None:
        self._screen = screen
        self._console = console
        self._session = session
        self._panes = panes
        self._rows = rows
        self._navigation = console.navigation
        settings, navigation = console.settings, console.navigation
        self.confirm = Confirm(id="confirm")
        self.menu = Menu(id="menu")
        self.key_help = Help()
        self._add_map()
        self.tables = TableTools(console, panes, rows)
        past, give = PastOrders(console), self.tables.marked.give_order
        state, self.anyone = lambda: console.store.state, AnyoneOrders(console)
        self.order_form = OrderForm(state, give, self.anyone.give, past, console.dispatch.objections)
        looked_at = lambda: (console.store.state, navigation.robot)  # noqa: E731  # a name for values that change
        self.why = Why(looked_at, settings.keys, self.streams, console.backend)
        self.orders = OrderRequests(
            console, queue=panes.queue, open_form=self.order_form.start, marked=self.tables.marked
        )
        self.robots = RobotRequests(
            console,
            orders=self.orders,
            why=self.why.show,
            alarm_menu=lambda *alarm: self.alarms.menu(*alarm),
            marked=self.tables.marked,
        )
        self.alarms = AlarmResponses(
            console,
            pane=panes.alarms,
            why=self.why.show,
            robot_menu=self.robots.menu,
            charge=self.orders.charge,
            cleared_at=lambda: marked_alarm.gone_at,
        )
        page = PageSource(
            looked_at,
            lambda: console.files.audit,
            settings.clock,
            lambda: self.map.picture.options.drawing,
            console.backend,
        )
        self.robot_page = RobotPage(page, self.robots.menu, lambda: panes.space_beside_map)
        self.diagnostics = Diagnostics(Pages(state, console.backend, settings.clock), settings.keys)
        self.save = SaveCommand(console)
        offers = Offers(console, session, self.save, self._run)
        self.palette = Palette(offers.entries, lambda line: self._typed(line) or offers.typed(line))
        self.editing = GraphEditing(console, self.map_controls, self.map.picture)
        self.set_up = SetUp(console, self.map_controls, self.map.picture, self.streams.comparison)
        self.driving = HandDriving(console, self.map_controls, self.map, self._app.tell_releases)
        self.desk = DeskCommands(console)
        self.facilities = FacilityList(console)
        self.simple = SimpleSwitch(console, panes, self.map, self.orders.may_order)
        history = history_feature(console, lambda: self.map.picture.options, self._loss)
        self._pages_of_history = history.overlays
        self._features = (
            audit_feature(console),
            history,
            programs_feature(console),
            recording_feature(console, screen),
            routines_feature(console),
            desk_feature(self.desk),
            self.editing.feature,
            self.set_up.feature,
            self.driving.feature,
        )
        overlays = (overlay for feature in self._features for overlay in feature.overlays)
        self.tools: tuple[TableOverlay, ...] = (self.diagnostics, *overlays)
        self.styled = [self.map, *self.tools, *self.key_help.views, *self.small_maps]
        self.styled += [self.robot_page, self.camera_switch.view]
        self.actions = self._key_actions()

    def _add_map(self) -> None:
        console, notices = self._console, self._console.notices
        self.map = MapView(id="map")
        self.small_maps = SmallMapsView("other-floors"), SmallMapsView("other-floors-below")
        self.map.picture.options = MapOptions(drawing=console.settings.drawing)
        self.live_map = LiveMap(console.backend.show_map)
        self.map_controls = MapControls(
            self.map,
            notices.say,
            console.settings.keys["next_vertex"],
            lambda: self.robots.menu(self._navigation.robot),
        )
        self.streams = ShownStreams(
            console.store, console.backend, self._navigation, notices, self.map.picture
        )
        app, view = self._app, CameraView()
        terminal = PictureTerminal(
            lambda: app.output.budget.sent.bytes,
            console.settings.picture_limit,
            lambda: self._has_few_colours or self.map.picture.options.drawing is Drawing.ASCII,
        )
        self.camera = CameraControls(console, view, terminal)
        self.camera_switch = CameraSwitch(self._panes, self.map, view, self.camera, notices.say)

    @property
    def _app(self) -> LeanApp:
        app = self._screen.app
        assert isinstance(app, LeanApp)
        return app

    def _loss(self) -> Message:
        """Return the reason why this console can't be left alone, empty if it can."""
        return next(filter(None, (feature.loss() for feature in self._features)), EMPTY)

    def _run(self, key: Key) -> None:
        """Run the action of a key, after the current one."""
        self._screen.call_later(self._screen.run_action, action_of(key))

    def _typed(self, line: str) -> Typed | None:
        """Parse a typed line that is of a feature, or about any robot or a facility; None for any other."""
        parsers = (self.anyone.typed, self.facilities.typed)
        own = (parse for feature in self._features for parse in feature.typed)
        return next(filter(None, (parse(line) for parse in (*parsers, *own))), None)

    async def mount(self) -> None:
        """Mount all widgets, the focus on the map. The audit log starts before there is a link."""
        screen, console, panes = self._screen, self._console, self._panes
        below_map = self.why, self.order_form, self.menu
        opens = (*below_map, self.confirm, self.key_help, self.palette)
        with screen.app.batch_update():
            await screen.query_one("#map").remove()
            await panes.floor.mount(self.camera_switch.view, self.map, before=0)
            if len(console.store.state.floors) > 1:
                await panes.mount_small_maps(*self.small_maps)
            await screen.mount(*opens, *self.tools, *self.tables.widgets, self.robot_page)
            panes.place_dialogs(*below_map)
            if (time_line := self._session.time_line()) is not None:
                self.styled.append(time_line)
                await screen.mount(time_line, before="#hints")
        has_few_colours = not screen.app.is_headless and screen.app.console.color_system == "standard"
        self._has_few_colours = screen.app.ansi_color or has_few_colours
        self.map.picture.hatch(self._has_few_colours)
        self.map.picture.hint = "".join(key_name(key) for key in console.settings.keys["help"][:1])
        screen.set_focus(self.map)
        console.files.open()
        join_desk(console, screen.call_later)

    def show_scene(self, scene: Scene) -> None:
        """Show a scene on the map, at the same scale until no panel covers a part of it any more."""
        self.driving.controls.look(scene)
        covers = self.why.is_open or self.menu.is_open or self.order_form.is_open
        self.map.picture.viewport.holds = covers or self._covers
        self._covers = covers
        self._panes.show_map(self.map, scene)
        state, options = self._navigation.here, self.map.picture.options
        for small_maps in self.small_maps:
            small_maps.show(state, replace(self._navigation.selection, floor=scene.floor), options)

    def show(self) -> None:
        """Show the newest state in the place of the map."""
        are_read = any(one.is_open for one in (self.diagnostics, self.why, self.robot_page))
        selected = self._navigation.selection.robot
        are_read = are_read or wants_causes(self._console.store.state, selected)
        self._console.backend.subscribe_logs(are_read)
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
        if self.editing.editor.is_open:
            return Pane.EDIT
        if self.driving.controls.mode is not None:
            return Pane.DRIVE
        return Pane.PLACE if self.set_up.poses.mode is not None else Pane.MAP

    def blocks(self, key: Key) -> bool:
        """Tell whether a key does nothing now: keys of modes work in theirs alone, and in a drive all others
        stop the robot."""
        mode = self.map_pane
        if mode.is_mode and key.id in CURSORS:
            return True
        in_mode = mode.is_mode and self._screen.focused is self.map
        if key.pane.is_mode:
            return not (in_mode and key.pane is mode)
        return in_mode and mode is Pane.DRIVE and key.id not in PASSES

    def focused_pane(self) -> Pane:
        """Return the pane whose keys help and footer list first."""
        if self._session.pane or self._screen.focused is self.map:
            return self._session.pane or self.map_pane
        if self.diagnostics.is_open:
            return Pane.DIAGNOSTICS
        if any(pages.is_open for pages in self._pages_of_history):
            return Pane.HISTORY
        return Pane.ROWS if isinstance(self._screen.focused, RowsPane) else Pane.CONSOLE

    def _key_actions(self) -> dict[str, Callable[[], object]]:
        """Return the action of each key that works on the screen, by its id."""
        return {
            **self._app_actions(),
            **self._command_actions(),
            **self._view_actions(),
            **self._map_actions(),
            **self.tables.actions,
            **{id_: action for feature in self._features for id_, action in feature.actions.items()},
            **self._session.actions,
        }

    def _app_actions(self) -> dict[str, Callable[[], object]]:
        app = self._app
        return {
            "suspend": self.driving.ended_before(Message("suspended"), app.action_suspend_process),
            "repaint": app.action_repaint,
            "say_quit": self._say_quit,
            "back": self._back,
            "next_pane": app.action_focus_next,
            "previous_pane": app.action_focus_previous,
            "save": self.save.start,
        }

    def _command_actions(self) -> dict[str, Callable[[], object]]:
        orders, robots, alarms = self.orders, self.robots, self.alarms
        pause_all = self.driving.ended_before(Message("pause all"), robots.pause_all)
        return {
            "order": self._order,
            "cancel": orders.cancel,
            "clear": orders.clear,
            "charge": orders.charge_now,
            "pause": robots.pause,
            "resume": robots.resume,
            "pause_all": pause_all,
            "pause_all_anywhere": pause_all,
            "resume_all": robots.resume_all,
            "arm": self._console.dispatch.arm,
            "acknowledge": alarms.acknowledge,
            "acknowledge_all": alarms.acknowledge_all,
            "alarm_menu": alarms.marked_menu,
        }

    def _view_actions(self) -> dict[str, Callable[[], object]]:
        navigation = self._navigation
        steps = {
            "next_robot": partial(navigation.step_robot, 1),
            "previous_robot": partial(navigation.step_robot, -1),
            "next_floor": partial(navigation.step_floor, 1),
            "previous_floor": partial(navigation.step_floor, -1),
        }
        return {
            **steps,
            **{f"{id_}_plain": step for id_, step in steps.items()},
            **{f"robot_{n}": partial(self._choose_robot, n) for n in range(1, 10)},
            "help": self._show_help,
            "help_anywhere": self._show_help,
            "palette": self.palette.show,
            "simple": self.simple.turn,
            "why": self._why,
            "robot_page": self.robot_page.show,
            "all_orders": self._all_orders,
            "enlarge": self._panes.enlarge,
            "diagnostics": self._diagnose,
            "facilities": self.facilities.menu,
            "go_to_time": partial(self.palette.show, "@"),
            "next_trouble": self._next_trouble,
        }

    def _map_actions(self) -> dict[str, Callable[[], object]]:
        controls = self.map_controls
        return {
            "zoom_in": controls.zoom_in,
            "zoom_out": controls.zoom_out,
            "fit": controls.fit,
            "zoom_about": controls.zoom_about,
            "follow": controls.follow,
            "centre": controls.centre,
            "edges": controls.edges,
            "labels": controls.labels,
            "trails": controls.trails,
            "drawing": controls.drawing,
            "map_cursor": controls.cursor,
            "next_vertex": partial(controls.next_vertex, 1),
            "previous_vertex": partial(controls.next_vertex, -1),
            "pan_left": partial(controls.pan, -1, 0),
            "pan_right": partial(controls.pan, 1, 0),
            "pan_up": partial(controls.pan, 0, -1),
            "pan_down": partial(controls.pan, 0, 1),
            "pick": controls.pick,
            "laser": self.streams.laser,
            "path": self.streams.path,
            "camera": self.camera_switch.turn,
        }

    def _say_quit(self) -> None:
        """Name the key that quits: Ctrl-C and Ctrl-Q are pressed by those who look for it."""
        quit_key = "".join(key_name(key) for key in self._console.settings.keys["quit"][:1])
        self._console.notices.say(
            Message("{quit_key} quits; press Esc first to close what is open", quit_key=quit_key)
            if quit_key
            else Message("no key quits: type quit after :")
        )

    def _back(self) -> None:
        """Go one level back: clear a filter or marks, give an enlarged pane its own place again, close the
        camera, end the map's mode, focus the map. A draft is left on the map alone."""
        if self.tables.back():
            return
        if self._panes.is_enlarged:
            self._panes.enlarge()
            return
        if self.camera.is_open:
            self.camera_switch.turn()
            return
        if not self.editing.editor.is_open:
            self.map_controls.leave_mode()
        if self.map.display:
            self._screen.set_focus(self.map)

    def _diagnose(self) -> None:
        cause = self.why.cause or self.why.first_reason(in_need=True)
        self.diagnostics.show(self._navigation.robot, cause)

    def _order(self) -> None:
        """Open the order form, from the reasons of a robot with a low battery for its way to a charger."""
        state, name = self._console.store.state, self._navigation.robot
        if self.why.cause is not None and has_low_battery(state, state.robots[name]):
            self.orders.charge(name)
        else:
            self.orders.start()

    def _show_help(self) -> None:
        state, robot = self._console.store.state, self._navigation.robot
        look = self.map.picture.options
        kind, terminal = state.robots[robot].kind, self._console.settings.terminal
        hidden = hidden_keys(state, robot) | self._idle_keys()
        pane = self.focused_pane()
        self.key_help.show(help_pages(self._console.settings.keys, pane, kind, hidden, look, terminal))

    def _why(self) -> None:
        """Explain the alarm of the focused pane, the closed edge under the map's cursor, else the robot."""
        cursor = self.map.picture.mode.cursor if self._screen.focused is self.map else None
        if self._panes.alarms.has_focus:
            self.alarms.explain()
        elif cursor is None or not self.desk.explain_edge(cursor):
            self.why.show()

    def _idle_keys(self) -> set[str]:
        """Return the ids of keys without a use in this session."""
        read_only = self._console.dispatch.permissions.read_only
        return unoffered_keys(self._session.offers, self._console.settings.permissions.right) | {
            key.id for key in KEYS if read_only and key.commands
        }

    def _all_orders(self) -> None:
        """Show the selected robot's orders, or all robots'."""
        self._rows.shows_all_orders = not self._rows.shows_all_orders
        self._rows.show(self._panes.queue)

    def _choose_robot(self, number: int) -> None:
        if (robot := numbered(self._console.store.state, number)) is None:
            self._console.notices.hint(
                Message("no robot has the number {number}: the fleet's column # shows them", number=number)
            )
        else:
            self._navigation.select(robot.name)

    def _next_trouble(self) -> None:
        """Go to the next robot, after the last one to the alarms of lifts, doors and links."""
        state, pane, robot = self._console.store.state, self._panes.alarms, self._navigation.robot
        marked, lone, names = pane.listing.cursor, alarms_of_none(state), in_turn(state)
        is_at_alarm = pane.has_focus and marked in lone
        if is_at_alarm:
            after = [key == marked for key in lone].index(True) + 1
            following, found = lone[after:], "".join(names[:1])
        else:
            found = next_in_trouble(state, robot, marked)
            following = lone if not names or (robot, found) == (names[-1], names[0]) else []
        if following or not found:
            self._mark_alarm([*following, *lone][:1])
            return
        if is_at_alarm:
            self._screen.set_focus(self._panes.fleet)
        self._navigation.find_robot(found)

    def _mark_alarm(self, keys: Sequence[AlarmKey]) -> None:
        """Mark the first of these alarms, if any, and say it."""
        for one in self._console.store.state.alarms:
            if one.key in keys:
                self._panes.alarms.listing.choose(one.key)
                self._screen.set_focus(self._panes.alarms)
                self._console.notices.say(
                    sanitize(Message("{source} {text}", source=one.condition.source, text=one.text))
                )
        if not keys:
            self._console.notices.hint(Message("no robot has an alarm or needs attention"))

    def picked(self, event: messages.Picked) -> None:
        """Run the action for a click or selection on the map, a row or its button, or the time line."""
        navigation = self._navigation
        match event:
            case messages.RobotPicked():
                navigation.select(event.name)
            case messages.VertexPicked():
                self.orders.start_at(event.id, navigation.floor)
            case messages.FloorPicked():
                navigation.find_floor(event.name)
            case messages.PlacePicked():
                # A pose or goal is where the mouse was; only a draft does something with it.
                self.editing.drawing.clicked(event.dragged)
            case messages.RowPicked():
                # The fleet's cursor selects. It may have moved since.
                is_there = event.pane == "fleet" and event.key == self._panes.fleet.listing.cursor
                if is_there and not isinstance(event.key, GroupHead):
                    navigation.select(str(event.key))
            case messages.RowChosen():
                self._open_menu(event)
            case messages.ButtonPressed():
                self._press_button(event)
            case messages.TimePicked():
                self._session.pick_time(event.x, event.width)
            case _:
                assert_never(event)

    def _open_menu(self, event: messages.RowChosen) -> None:
        match event.pane, event.key:
            case "fleet", GroupHead() as head:
                self.tables.fold(head)
            case "fleet", str(robot):
                self.robots.menu(robot)
            case "queue", (str(robot), str(order_id), _):
                self.orders.menu(robot, order_id)
            case "alarms", (str(source), str(kind)):
                self.alarms.menu(source, kind)

    def _press_button(self, event: messages.ButtonPressed) -> None:
        match event.pane, event.name, event.key:
            case "hints", id_, _:
                self._press_hint(id_)
            case _, "cancel", (str(robot), str(order_id), _):
                self.orders.ask_cancel(robot, order_id)
            case _, "clear", _:
                self.orders.clear()

    def _press_hint(self, id_: str) -> None:
        """Press the key of a hint: with the same checks, and with the same effect in an overlay."""
        key = textual_key(self._console.settings.keys[id_][0])
        # Not from here: Textual ends the way of an event at its sender.
        self._screen.app.call_later(self._screen.app.simulate_key, key)

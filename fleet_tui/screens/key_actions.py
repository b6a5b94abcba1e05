"""Actions of keys on this screen: a row in `keys/` picks one of them."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from textual.worker import get_current_worker

from fleet_tui.actions import (
    Actions,
    AlarmActions,
    AppActions,
    CommandActions,
    EditActions,
    FileActions,
    PlaceActions,
    ViewActions,
)
from fleet_tui.controllers.incident import Cancelled, IncidentPacking
from fleet_tui.controllers.recording import RecordingSwitch
from fleet_tui.keys import KEYS
from fleet_tui.keys.key import key_name
from fleet_tui.model.alarm import Key
from fleet_tui.rules.alarms.trouble import alarms_of_none, in_turn, next_in_trouble
from fleet_tui.rules.battery.charging import has_low_battery
from fleet_tui.rules.marks import numbered
from fleet_tui.screens.driving import after_a_drive, drive_actions
from fleet_tui.terminal.lean_app import LeanApp
from fleet_tui.text.language import Message
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.help.pages import help_pages
from fleet_tui.view.lines.hints import hidden_keys

if TYPE_CHECKING:
    from fleet_tui.screens.main import MainScreen
    from fleet_tui.screens.rest import Rest


def key_actions(screen: "MainScreen", rest: "Rest") -> Actions:
    """Return the actions of keys on a screen with all its controllers."""
    return Actions(
        app=_app_actions(screen, rest),
        commands=CommandActions(
            order=partial(_order, screen, rest),
            cancel=rest.orders.cancel,
            clear=rest.orders.clear,
            charge=rest.orders.charge_now,
            pause=rest.robots.pause,
            resume=rest.robots.resume,
            pause_all=after_a_drive(rest, Message("pause all"), rest.robots.pause_all),
            resume_all=rest.robots.resume_all,
            arm=screen.dispatch.arm,
        ),
        view=_view_actions(screen, rest),
        rows=rest.tables.actions,
        files=_file_actions(screen, rest),
        alarms=AlarmActions(rest.alarms.acknowledge, rest.alarms.acknowledge_all, rest.alarms.marked_menu),
        map=rest.map_controls,
        place=_place_actions(rest),
        edit=_edit_actions(rest),
        drive=drive_actions(rest),
        play=screen.session.play,
    )


def _app_actions(screen: "MainScreen", rest: "Rest") -> AppActions:
    app = screen.app
    assert isinstance(app, LeanApp)
    return AppActions(
        suspend=after_a_drive(rest, Message("suspended"), app.action_suspend_process),
        repaint=app.action_repaint,
        quit=rest.routines.quit,
        say_quit=partial(_say_quit, screen),
        back=partial(_back, screen, rest),
        next_pane=app.action_focus_next,
        previous_pane=app.action_focus_previous,
    )


def _say_quit(screen: "MainScreen") -> None:
    """Name the key that quits: Ctrl-C and Ctrl-Q are pressed by those who look for it."""
    quit_key = "".join(key_name(key) for key in screen.settings.keys["quit"][:1])
    screen.notices.say(
        Message("{quit_key} quits; press Esc first to close what is open", quit_key=quit_key)
        if quit_key
        else Message("no key quits: type quit after :")
    )


def _back(screen: "MainScreen", rest: "Rest") -> None:
    """Go one level back: clear a filter or marks, give an enlarged pane its own place again, close the
    camera, end the map's mode, focus the map. A draft is left on the map alone."""
    if rest.tables.back():
        return
    if screen.panes.is_enlarged:
        screen.panes.enlarge()
        return
    if rest.camera.is_open:
        rest.camera_switch.turn()
        return
    if not rest.editor.is_open:
        rest.map_controls.leave_mode()
    if rest.map.display:
        rest.map.screen.set_focus(rest.map)


def _view_actions(screen: "MainScreen", rest: "Rest") -> ViewActions:
    navigation = screen.navigation
    return ViewActions(
        help=partial(_show_help, screen, rest),
        palette=rest.palette.show,
        simple=rest.simple.turn,
        why=partial(_why, screen, rest),
        robot_page=rest.robot_page.show,
        all_orders=partial(_all_orders, screen),
        enlarge=screen.panes.enlarge,
        diagnostics=lambda: rest.diagnostics.show(
            navigation.robot, rest.why.cause or rest.why.first_reason(in_need=True)
        ),
        audit=rest.audit_log.show,
        history=rest.history.show,
        programs=rest.programs.show,
        routines=rest.routines.show,
        desk=rest.desk.menu,
        facilities=rest.facilities.menu,
        go_to_time=partial(rest.palette.show, "@"),
        step_robot=navigation.step_robot,
        choose_robot=partial(_choose_robot, screen),
        step_floor=navigation.step_floor,
        next_trouble=partial(_next_trouble, screen),
    )


def _order(screen: "MainScreen", rest: "Rest") -> None:
    """Open the order form, from the reasons of a robot with a low battery for its way to a charger."""
    state, name = screen.store.state, screen.navigation.robot
    if rest.why.cause is not None and has_low_battery(state, state.robots[name]):
        rest.orders.charge(name)
    else:
        rest.orders.start()


def _show_help(screen: "MainScreen", rest: "Rest") -> None:
    state, robot = screen.store.state, screen.navigation.robot
    look = rest.map.picture.options
    kind, terminal = state.robots[robot].kind, screen.settings.terminal
    hidden = hidden_keys(state, robot) | _idle_keys(screen)
    pane = screen.focused_pane()
    rest.key_help.show(help_pages(screen.settings.keys, pane, kind, hidden, look, terminal))


def _why(screen: "MainScreen", rest: "Rest") -> None:
    """Explain the alarm of the focused pane, the closed edge under the map's cursor, else the robot."""
    cursor = rest.map.picture.mode.cursor if screen.focused is rest.map else None
    if screen.alarms.has_focus:
        rest.alarms.explain()
    elif cursor is None or not rest.desk.explain_edge(cursor):
        rest.why.show()


def _idle_keys(screen: "MainScreen") -> set[str]:
    """Return the ids of keys without a use in this session."""
    read_only = screen.dispatch.permissions.read_only
    return screen.unoffered | {key.id for key in KEYS if read_only and key.commands}


def _all_orders(screen: "MainScreen") -> None:
    """Show the selected robot's orders, or all robots'."""
    screen.shows_all_orders = not screen.shows_all_orders
    screen.tick()


def _choose_robot(screen: "MainScreen", number: int) -> None:
    if (robot := numbered(screen.store.state, number)) is None:
        screen.notices.hint(
            Message("no robot has the number {number}: the fleet's column # shows them", number=number)
        )
    else:
        screen.navigation.select(robot.name)


def _next_trouble(screen: "MainScreen") -> None:
    """Go to the next robot, after the last one to the alarms that are no robot's: of lifts, doors, links."""
    state, pane, robot = screen.store.state, screen.alarms, screen.navigation.robot
    marked, lone, names = pane.listing.cursor, alarms_of_none(state), in_turn(state)
    is_at_alarm = pane.has_focus and marked in lone
    if is_at_alarm:
        after = [key == marked for key in lone].index(True) + 1
        following, found = lone[after:], "".join(names[:1])
    else:
        found = next_in_trouble(state, robot, marked)
        following = lone if not names or (robot, found) == (names[-1], names[0]) else []
    if following or not found:
        _mark_alarm(screen, [*following, *lone][:1])
        return
    if is_at_alarm:
        screen.set_focus(screen.fleet)
    screen.navigation.find_robot(found)


def _mark_alarm(screen: "MainScreen", keys: Sequence[Key]) -> None:
    """Mark the first of these alarms, if any, and say it."""
    for one in screen.store.state.alarms:
        if one.key in keys:
            screen.alarms.listing.choose(one.key)
            screen.set_focus(screen.alarms)
            screen.notices.say(
                sanitize(Message("{source} {text}", source=one.condition.source, text=one.text))
            )
    if not keys:
        screen.notices.hint(Message("no robot has an alarm or needs attention"))


def _place_actions(rest: "Rest") -> PlaceActions:
    return PlaceActions(
        laser=rest.streams.laser,
        path=rest.streams.path,
        camera=rest.camera_switch.turn,
        mapping=rest.mapping.menu,
        pose=rest.poses.pose,
        goal=rest.poses.goal,
        turn=rest.poses.turn,
        snap=rest.snap.snap,
        send=rest.poses.send,
        leave=rest.poses.leave,
    )


def _edit_actions(rest: "Rest") -> EditActions:
    editor, drawing, values = rest.editor, rest.drawing, rest.values
    return EditActions(
        start=editor.start,
        leave=editor.leave,
        select=drawing.select,
        add_at_cursor=drawing.add_at_cursor,
        add_at_robot=drawing.add_at_robot,
        connect=drawing.connect,
        remove=drawing.remove,
        hold=drawing.hold,
        turn=drawing.turn,
        choose_type=values.choose_type,
        name=values.name,
        undo=editor.undo,
        redo=editor.redo,
        lint=rest.checks.show_findings,
        compare=rest.checks.compare,
        write=rest.draft_files.write,
        send=rest.sending.start,
    )


def _file_actions(screen: "MainScreen", rest: "Rest") -> FileActions:
    app, files, say = screen.app, screen.files, screen.notices.say
    say_from_thread = partial(app.call_from_thread, say)
    recording = RecordingSwitch(files, say, say_from_thread, partial(screen.run_worker, thread=True))
    shot = partial(app.export_screenshot, title="fleet-tui")
    incident = IncidentPacking(files, say, say_from_thread, shot, partial(_in_thread, screen))
    return FileActions(record=recording.turn, bundle=incident.pack, save=rest.save.start)


def _in_thread(screen: "MainScreen", work: Callable[[Cancelled], None]) -> None:
    def run() -> None:
        worker = get_current_worker()
        work(lambda: worker.is_cancelled)

    screen.run_worker(run, thread=True, exit_on_error=False)

"""Every action of the console's keys, as types: the type checker names one that is missing."""

from collections.abc import Callable

from msgspec import Struct

from fleet_tui.actions.panes import MapActions, PlayerActions

Act = Callable[[], object]
Step = Callable[[int], object]

Play = Callable[[Callable[[PlayerActions], object]], object]
"""Runs an action of a player, and shows the text that it returns."""


class AppActions(Struct, frozen=True):
    """Actions of the program and of the focus."""

    suspend: Act
    repaint: Act
    quit: Act
    say_quit: Act
    back: Act
    next_pane: Act
    previous_pane: Act


class CommandActions(Struct, frozen=True):
    """Actions that create commands, or permit them."""

    order: Act
    cancel: Act
    clear: Act
    charge: Act
    pause: Act
    resume: Act
    pause_all: Act
    resume_all: Act
    arm: Act


class ViewActions(Struct, frozen=True):
    """Actions that change the view."""

    help: Act
    palette: Act
    simple: Act
    why: Act
    robot_page: Act
    all_orders: Act
    enlarge: Act
    diagnostics: Act
    audit: Act
    history: Act
    programs: Act
    routines: Act
    desk: Act
    facilities: Act
    go_to_time: Act
    step_robot: Step
    choose_robot: Step
    step_floor: Step
    next_trouble: Act


class TableActions(Struct, frozen=True):
    """Actions on the focused table, else on the fleet."""

    filter: Act
    sort: Act
    group: Act
    mark: Act
    copy: Act


class AlarmActions(Struct, frozen=True):
    acknowledge: Act
    acknowledge_all: Act
    alarm_menu: Act


class FileActions(Struct, frozen=True):
    record: Act
    bundle: Act
    save: Act


class PlaceActions(Struct, frozen=True):
    """Actions of the choice of a place with a heading, and what helps with it."""

    laser: Act
    path: Act
    camera: Act
    mapping: Act
    pose: Act
    goal: Act
    turn: Step
    """By degrees, counter-clockwise."""
    snap: Act
    send: Act
    leave: Act


class DriveActions(Struct, frozen=True):
    """Actions of driving by hand."""

    start: Act
    press: Callable[[str], object]
    """With one of the directions of `rules.driving.hold`, whichever key has it."""
    change_speed: Step
    leave: Act


class EditActions(Struct, frozen=True):
    """Actions of the graph editor: on the draft, and on what is selected in it."""

    start: Act
    leave: Act
    select: Act
    add_at_cursor: Act
    add_at_robot: Act
    connect: Act
    remove: Act
    hold: Act
    turn: Act
    choose_type: Act
    name: Act
    undo: Act
    redo: Act
    lint: Act
    compare: Act
    write: Act
    send: Act


class Actions(Struct, frozen=True):
    """All actions: bound methods of the controllers, the overlays and the app."""

    app: AppActions
    commands: CommandActions
    view: ViewActions
    rows: TableActions
    alarms: AlarmActions
    files: FileActions
    map: MapActions
    place: PlaceActions
    edit: EditActions
    drive: DriveActions
    play: Play

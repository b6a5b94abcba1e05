"""The pages of help: tasks, keys, the legend, typed commands."""

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from fleet_tui.keys import KEYS, Pane, outdone
from fleet_tui.model.alarm import AlarmStage
from fleet_tui.model.geometry import Line, MapFrame, Pose
from fleet_tui.model.graph import Role
from fleet_tui.model.history.facts import Activity
from fleet_tui.model.kind import GOAL, LOCALISE, MAP_SAVE, MAPPING, POSE, SETTLE, Kind
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, Classes, build_grid
from fleet_tui.model.replay import MarkKind
from fleet_tui.text.language import N_, Message, tr, translate, verbatim
from fleet_tui.ui.view.bars import BARS
from fleet_tui.ui.view.help.section import HelpRow, HelpSection, key_row, translated
from fleet_tui.ui.view.help.synonyms import SYNONYMS
from fleet_tui.ui.view.lines.time import MARKS
from fleet_tui.ui.view.map.camera import DOTS_X, DOTS_Y, Camera
from fleet_tui.ui.view.map.glyphs import robot_glyph
from fleet_tui.ui.view.map.layer_stack import backdrop, picture
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.map.placing.crowds import LEAST
from fleet_tui.ui.view.map.robots import FEW
from fleet_tui.ui.view.map.scene import Mission, Scene, SceneRobot, SceneVertex
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.alarms import SIGNS
from fleet_tui.ui.view.tables.doing import word
from fleet_tui.ui.view.tables.fleet import CARGO
from fleet_tui.ui.view.tables.listing import CURSOR
from fleet_tui.ui.view.tables.missions import FOREIGN
from fleet_tui.ui.view.tables.table import Button, Run, width_of

Pages = Mapping[str, Sequence[HelpSection]]
"""The sections of each page, by its name."""

SECTIONS = (
    Pane.RECORDING,
    Pane.CONSOLE,
    Pane.MAP,
    Pane.PLACE,
    Pane.EDIT,
    Pane.DRIVE,
    Pane.ROWS,
    Pane.DIAGNOSTICS,
    Pane.HISTORY,
    Pane.ANYWHERE,
)

TYPED = {
    "order": (
        ("robot_0 Base > Store", Message("an order")),
        ("robot_0 A > B > C", Message("an order with legs")),
        ("robot_0 > B", Message("{alone} to B")),
        ("anyone Base > Store", Message("nearest idle robot")),
        ('order robot_0 Base "Dock 7"', Message("labels with spaces")),
    ),
    "cancel": (("cancel 12, cancel robot_0 12", Message("one order")),),
    "clear": (("clear robot_0", Message("all its orders")),),
    "pause": (("pause robot_0, pause all", Message("immediately")),),
    "resume": (("resume robot_0, resume all", Message("immediately")),),
    GOAL: (
        ("goto robot_0 Base", Message("to a place")),
        ("goto robot_0 3.5 2 90", Message("to a point: m, degrees")),
    ),
    POSE: (("set-pose robot_0 3.5 2 90", Message("its pose: m, degrees")),),
    LOCALISE: (("localise robot_0", Message("search the whole map")),),
    SETTLE: (("settle robot_0", Message("refine its pose, standing")),),
    MAPPING: (("mapping robot_0 on", Message("mapping on, or off")),),
    MAP_SAVE: (("store-map robot_0 hall", Message("a map on its own disk")),),
}
"""Examples of typed commands and their meaning, by the verb that a kind must accept."""

ALWAYS = (
    ("robot_1, Base, floor_1", Message("go there")),
    ("save config.toml", Message("write the configuration")),
    ("save-map hall.yaml", Message("write the shown map")),
    ("claim robot_3", Message("others are asked before they command it")),
    ("close Hall Dock", Message("close an edge for all of the desk; open")),
    ("note lift B is slow", Message("a note for the next shift")),
    ("theme, record, arm, ...", Message("any action, by a word")),
)
"""Examples of typed lines that need no robot."""

NOTES = (
    Message("Robots go by name or number, places by label or id; id=7 is always the id."),
    Message("Order form: typing filters the labels, Enter takes the marked one; > after a label adds a leg."),
    Message("The same order within 1 s is not sent twice."),
    Message("Confirmations: y confirms; n, Esc or Enter cancels."),
    Message(
        "Mouse: wheel zooms at the pointer, drag pans, click selects, also the keys in the last line. "
        "To select text with the terminal, hold Shift."
    ),
    Message("Pause is not a safety device: near people, use the robot's own stop."),
)


CELLS = 10
"""Width of a sign drawn by the map."""
_WIDTH = CELLS * DOTS_X
_HEIGHT = DOTS_Y
_FRAME = MapFrame(1.0, _WIDTH, _HEIGHT)
_CAMERA = Camera(_WIDTH / 2, _HEIGHT / 2, 1.0, CELLS, 1, (_WIDTH, _HEIGHT))
_AT = (1.0, 2.0)  # in the first cell
_WAY: tuple[Line, ...] = ((1.0, 2.0, _WIDTH - 1.0, 2.0),)
_ROBOT = SceneRobot("robot_4", 4, Pose(*_AT))
_BESIDE = SceneRobot("robot_5", 5, Pose(5.0, 2.0))
_ELSEWHERE = SceneRobot("robot_5", 5, Pose(-1.0, -1.0))


Step = tuple[tuple[str, ...], Message]
"""The ids of the keys of a step, and their effect."""

ROBOTS = tuple(f"robot_{number}" for number in range(1, 10))
"""The ids of the keys that select a robot by its number."""
ROBOT_STEPS = ("next_robot_plain", "previous_robot_plain", "next_robot", "previous_robot")
FLOOR_STEPS = ("next_floor_plain", "previous_floor_plain", "next_floor", "previous_floor")
ORDERING = Message("Send an order")
TASKS: dict[Message, tuple[Step, ...]] = {
    ORDERING: (
        (("order",), Message("Order form: From, Enter, To, Enter")),
        (("map_cursor", "pick"), Message("Map cursor; Enter orders from there")),
        (("goal",), Message("Send the robot to any point")),
        (("simple",), Message("Simple interface: large buttons")),
        (("palette",), Message("Typed: robot_0 Base > Store")),
    ),
    Message("Stop a robot"): (
        (("pause",), Message("Pause the selected robot")),
        (("resume", "resume_all"), Message("Resume it; resume all (asks)")),
        (("pause_all", "pause_all_anywhere"), Message("Pause all robots (no safety device)")),
        (("cancel",), Message("Cancel order at the queue cursor")),
        (("clear",), Message("Clear all orders of the robot")),
    ),
    Message("Choose a robot or a floor"): (
        ((*ROBOT_STEPS, *ROBOTS), Message("Next, previous robot; by number")),
        (("next_trouble",), Message("Next robot with an alarm")),
        (FLOOR_STEPS, Message("Next, previous floor")),
        (("palette",), Message("A robot, place or floor by name")),
    ),
    Message("See what is wrong"): (
        (("why",), Message("Why the robot is not moving")),
        (("robot_page",), Message("The robot's page: values, ages")),
        (("acknowledge", "acknowledge_all"), Message("Acknowledge this alarm; all alarms")),
        (("all_orders",), Message("Orders of this robot, or of all")),
        (("diagnostics",), Message("Diagnostics: links, topics, logs")),
        (("bundle",), Message("Pack an incident for a ticket")),
    ),
    Message("Look back in time"): (
        (("audit", "history"), Message("Audit log; history of the robots")),
        (("palette",), Message("Type record, for fleet-tui replay")),
    ),
    Message("Look around on the map"): (
        (("zoom_in", "zoom_out", "fit"), Message("Zoom in, out, fit (mouse wheel)")),
        (("pan_left", "pan_right", "pan_up", "pan_down"), Message("Pan (mouse drag)")),
        (("follow", "centre"), Message("Follow, or centre on the robot")),
        (("edges", "labels", "trails"), Message("Show edges, labels, trails")),
        (("laser", "path"), Message("Show laser scan, planned path")),
        (("next_vertex", "previous_vertex"), Message("Next, previous labelled vertex")),
    ),
    Message("Set up a site"): (
        (("edit",), Message("Draw the route graph")),
        (("pose",), Message("Set the robot's pose")),
        (("mapping",), Message("Mapping: on, off, save the map")),
        (("drive",), Message("Drive the robot by hand")),
        (("camera",), Message("Look through the robot's camera")),
        (("programs",), Message("Programs of the robot servers")),
        (("routines",), Message("Routines: instructions from a file")),
    ),
    Message("Get around"): (
        (("next_pane",), Message("Next pane")),
        (("enlarge",), Message("Enlarge the pane; once more: back")),
        (("menu",), Message("Menu of a row in a table")),
        (("filter_rows",), Message("Filter the table by what you type")),
        (("mark_row",), Message("Mark rows: a command goes to all")),
        (("palette",), Message("Any action, by typing")),
        (("back",), Message("One level back")),
        (("quit",), Message("Quit")),
    ),
}


NEW_ALARM = Message("alarm that waits for an acknowledgement; robot with an alarm")
SUPPRESSED = Message("alarms covered by another one: that of their group or link")
STATES = {
    Activity.DRIVING: Message("its pose changes"),
    Activity.WAITING: Message("stopped with an order, and for how long: amber from 30 s on"),
    Activity.LOADING: Message("at a stop of its order"),
    Activity.BLOCKED: Message(
        "in contact with an obstacle, stopped by its navigation, by an emergency stop or a grave error,"
        " or stuck with an order: the row says which"
    ),
    Activity.PAUSED: Message("by this console, or from elsewhere, which is marked"),
    Activity.IDLE: Message("stopped, without a known order"),
    Activity.CHARGING: Message("idle at a charger, not full"),
    Activity.OFFLINE: Message("nothing received for too long, with the age of its last message"),
}


def help_pages(
    keys: Mapping[str, tuple[str, ...]],
    pane: Pane,
    kind: Kind,
    hidden: Collection[str],
    look: MapOptions,
    terminal: str,
) -> Pages:
    """Return the pages for robots of a kind and the focused pane, without the `hidden` keys. The legend is
    drawn as the map with `look`; `terminal` describes the terminal."""
    own = [] if pane in (Pane.MAP, Pane.ROWS, Pane.CONSOLE) else [_section(pane, keys, hidden)]
    ordered = sorted(SECTIONS, key=lambda section: section is not pane)
    every = [_section(section, keys, hidden) for section in ordered]
    pages = {
        N_("Tasks"): [*own, *tasks(keys, hidden)],
        N_("Keys"): [section for section in every if section.rows],
        N_("Legend"): legend(look),
        N_("Commands"): [_typed(kind), HelpSection(Message("Notes"), _texts((*NOTES, verbatim(terminal))))],
    }
    return {name: list(map(translated, sections)) for name, sections in pages.items()}


def _section(pane: Pane, keys: Mapping[str, tuple[str, ...]], hidden: Collection[str]) -> HelpSection:
    """Return every key of a pane; those that select a robot by number are one row."""
    rows = []
    away = {*hidden, *ROBOTS[1:], *outdone(keys, hidden)}
    for key in KEYS:
        if key.section is not pane or key.id in away:
            continue
        if key.id == ROBOTS[0]:
            rows.append(
                key_row(ROBOTS, Message("Select a robot by its number in the configuration"), keys, 9)
            )
        else:
            ids = [key.id, *filter(None, [key.instead_of])]
            rows.append(key_row(ids, key.text, keys, 9, SYNONYMS.get(key.id, "")))
    return HelpSection(Message(pane.value), tuple(rows))


def _typed(kind: Kind) -> HelpSection:
    alone = Message("cargo on board") if kind.brings_cargo else Message("directly")
    accepted = [example for verb, examples in TYPED.items() if kind.can(verb) for example in examples]
    rows = [
        HelpRow(((example, StyleRole.KEY),), Message(text.id, alone=alone) if "{alone}" in text else text)
        for example, text in (*accepted, *ALWAYS)
    ]
    return HelpSection(Message("Typed commands: Tab completes, Enter sends"), tuple(rows))


def _texts(texts: Sequence[Message]) -> tuple[HelpRow, ...]:
    return tuple(HelpRow((), text) for text in texts if text)


def tabs(pages: Pages, shown: str) -> tuple[list[Run], list[Button]]:
    """Return the names of the pages, the open one in brackets, and their cells."""
    runs: list[Run] = []
    buttons = []
    for name in pages:
        start = width_of(runs)
        is_shown = name == shown
        text = f"[{tr(name)}]" if is_shown else f" {tr(name)} "
        runs.append((text, StyleRole.TITLE_FOCUSED if is_shown else StyleRole.DIM))
        buttons.append(Button(start, width_of(runs), name))
    return runs, buttons


def _ground(kind: int) -> Classes:
    """Return free ground, in the middle of another kind."""
    classes = np.full((_HEIGHT, _WIDTH), FREE, np.uint8)
    classes[1:3] = kind
    return classes


_FLOOR = Scene("", _FRAME, build_grid(_FRAME, _ground(FREE)))
_MAPS = (
    (
        replace(_FLOOR, grid=build_grid(_FRAME, _ground(OCCUPIED))),
        Message("a wall or another obstacle of the map"),
    ),
    (_FLOOR, Message("free floor")),
    (
        replace(_FLOOR, grid=build_grid(_FRAME, np.full_like(_ground(FREE), UNKNOWN))),
        Message("unknown ground"),
    ),
)


def _robots(*robots: SceneRobot) -> Scene:
    return replace(_FLOOR, robots=robots)


_ROBOTS = (
    (_robots(_ROBOT), Message("a robot: its heading and number")),
    (_robots(_ROBOT, _BESIDE, *[_ELSEWHERE] * FEW), Message("too close to another robot: only its number")),
    (_robots(*[_ROBOT] * LEAST), Message("a crowd of robots: how many")),
    (_robots(_ROBOT._replace(selected=True)), Message("the selected robot")),
    (_robots(_ROBOT._replace(cargo=True)), Message("with cargo on board")),
    (
        _robots(_ROBOT._replace(waits=True)),
        Message(
            "! at an obstacle for over 10 s, or waiting with an order for over 30 s: amber, no alarm yet"
        ),
    ),
    (_robots(_ROBOT._replace(alarmed=True)), Message("! with an alarm, red until it is acknowledged")),
    (_robots(_ROBOT._replace(paused=True)), Message("paused")),
    (
        _robots(_ROBOT._replace(jumped=True)),
        Message("its pose has just jumped, or is inside a wall or off the map"),
    ),
    (
        _robots(_ROBOT._replace(estimated=True)),
        Message("estimated: it reports no position, only its last node"),
    ),
    (_robots(_ROBOT._replace(other_map=True)), Message("its own map differs from the one shown")),
    (_robots(_ROBOT._replace(online=False, age=95.0)), Message("offline, with the age of its last message")),
    (
        _robots(_ROBOT._replace(pose=Pose(9.0, 2.0), size=(7.0, 3.0))),
        Message("zoomed in: its outline to scale"),
    ),
)


def _vertex(label: str = "", role: Role = Role.PLAIN, target: bool = False) -> Scene:
    vertices = (SceneVertex("7", *_AT, role, label),)
    return replace(_FLOOR, vertices=vertices, target_vertices=("7",) if target else ())


_PLACES = (
    (_vertex("Base"), Message("a vertex with its label")),
    (_vertex("Base", target=True), Message("start or end of the selected robot's order")),
    (_vertex(), Message("a vertex without a label")),
    (_vertex("Dock", Role.DOCKING), Message("a docking station")),
    (_vertex("Lift", Role.ELEVATOR), Message("an elevator")),
)


def _trail(age: float) -> Scene:
    return replace(_FLOOR, trail=np.array([(x, 2.0, age) for x in range(1, _WIDTH, 2)], np.float64))


_LINES = (
    (replace(_FLOOR, mission=Mission(current=_WAY)), Message("the route of the selected robot's order")),
    (replace(_FLOOR, mission=Mission(following=_WAY)), Message("the route of its next orders")),
    (replace(_FLOOR, edges=_WAY), Message("an edge of the route graph")),
    (replace(_FLOOR, edges=_WAY, one_way=_WAY), Message("a one-way edge")),
    (
        replace(_FLOOR, blocked=_WAY),
        Message("an edge that may be blocked: a robot with an alarm is held up on it"),
    ),
    (replace(_FLOOR, closed=_WAY), Message("a closed edge")),
    (_trail(5.0), Message("trail of the last half minute")),
    (_trail(45.0), Message("trail, up to a minute old")),
)


def _tables() -> tuple[HelpRow, ...]:
    alarm, text = StyleRole.ALARM, StyleRole.TEXT
    signs = {stage: translate(sign) for stage, sign in SIGNS.items()}
    marks = {
        CURSOR: (StyleRole.ACCENT, Message("cursor of the table")),
        "●": (StyleRole.GOOD, Message("online; in the status line: the link is up")),
        "○": (alarm, Message("offline, or no link")),
        CARGO: (text, Message("cargo on board")),
        signs[AlarmStage.UNACKNOWLEDGED]: (alarm, NEW_ALARM),
        signs[AlarmStage.ACKNOWLEDGED]: (
            text,
            Message("acknowledged alarm that still holds; robot with such an alarm"),
        ),
        signs[AlarmStage.RETURNED]: (StyleRole.DIM, Message("alarm that is over, not acknowledged")),
        signs[AlarmStage.SHELVED]: (
            StyleRole.DIM,
            Message("alarm put aside for a while; robot with such an alarm"),
        ),
        f"▲ {tr('high')}": (StyleRole.ROBOT_ALARM, Message("priority of an alarm: high, medium (med), low")),
        tr("suppressed"): (StyleRole.DIM, SUPPRESSED),
        translate(FOREIGN): (
            text,
            Message("an order that another client gave: another console, the shell, RViz"),
        ),
        tr("lost"): (alarm, Message("an order that the robot no longer lists, and whose end was not seen")),
        MARKS[MarkKind.COMMAND][0]: (StyleRole.ACCENT, Message("recording: a command")),
        MARKS[MarkKind.GAP][0]: (StyleRole.WARN, Message("recording: a gap")),
        MARKS[MarkKind.ALARM][0]: (alarm, Message("recording: an alarm")),
    }
    return tuple(_row(((mark, role),), meaning) for mark, (role, meaning) in marks.items())


def _states(look: MapOptions) -> tuple[HelpRow, ...]:
    """Return what a robot does: its sign in the Activity pane, and its word everywhere."""
    rows = []
    for does, meaning in STATES.items():
        glyph, letter, role = BARS[does]
        mark = ((f"{letter if look.plain else glyph} ", role), (tr(does.value), StyleRole.TEXT))
        rows.append(_row(mark, meaning))
    unknown = Message("its pose or its orders are missing or old: its row says which")
    return (*rows, _row(((word(None), StyleRole.TEXT),), unknown))


def _headings(look: MapOptions) -> HelpRow:
    poses = (Pose(0.0, 0.0, quarter * math.pi / 2) for quarter in range(4))
    glyphs = (robot_glyph(_ROBOT._replace(pose=pose), 0.0, look.plain) for pose in poses)
    return _row(((" ".join(glyphs), StyleRole.ROBOT),), Message("headings: right, up, left, down"))


def _row(mark: tuple[Run, ...], text: Message) -> HelpRow:
    """Return a row that its signs find; the ground below them is none."""
    signs = {sign for part, role in mark for sign in part if role not in (StyleRole.FLOOR, StyleRole.CURSOR)}
    return HelpRow(mark, text, tuple(sign for sign in signs if not sign.isalnum() and not sign.isspace()))


def _drawn(scene: Scene, text: Message, look: MapOptions) -> HelpRow:
    """Return a row with a small picture of the map."""
    cells = picture(backdrop(scene, _CAMERA, look), scene, _CAMERA, look)
    return _row(tuple((part, StyleRole(role)) for part, role in cells.runs(0)), text)


@lru_cache(maxsize=1)
def legend(look: MapOptions) -> tuple[HelpSection, ...]:
    """Return the legend in the drawing mode of the map."""
    drawing = replace(look, edges=True, labels=True, trails=True, cursor=None, pointed=None)
    sections = {N_("robots"): _ROBOTS, N_("places"): _PLACES, N_("lines"): _LINES, N_("ground"): _MAPS}
    cursor = _drawn(_FLOOR, Message("the map cursor"), replace(drawing, cursor=_AT))
    drawn = {
        name: tuple(_drawn(scene, text, drawing) for scene, text in rows) for name, rows in sections.items()
    }
    drawn["robots"] += (_headings(look),)
    drawn["ground"] += (cursor,)
    return (
        *(
            HelpSection(
                Message("Legend: {kind}, {drawing}", kind=Message(kind), drawing=Message(look.drawing.value)),
                rows,
            )
            for kind, rows in drawn.items()
        ),
        HelpSection(Message("Legend: what a robot does"), _states(look)),
        HelpSection(Message("Legend: tables and status line"), _tables()),
    )


def tasks(keys: Mapping[str, tuple[str, ...]], hidden: Collection[str]) -> list[HelpSection]:
    """Return the tasks with their keys as configured, the first of each id, without the `hidden` ones. Where
    no order can be sent, no way to do so is offered."""
    sections = []
    away = {*hidden, *outdone(keys, hidden)}
    for title, steps in TASKS.items():
        if title == ORDERING and "order" in hidden:
            continue
        offered = [([id_ for id_ in ids if id_ not in away], text) for ids, text in steps]
        rows = tuple(key_row(ids, text, keys, 1) for ids, text in offered if ids)
        if rows:
            sections.append(HelpSection(title, rows))
    return sections

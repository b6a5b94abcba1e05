"""Keys of the console: they work from every pane."""

from fleet_tui.actions import Actions
from fleet_tui.keys.key import LISTS, Key, Pane
from fleet_tui.text.language import Message

PLAIN: tuple[Key[Actions], ...] = (
    Key(
        "next_robot_plain",
        (".",),
        Message("Next robot"),
        hint=Message("robot"),
        only_live=True,
        helps="stays",
        instead_of="next_robot",
    ),
    Key(
        "previous_robot_plain",
        (",",),
        Message("Previous robot"),
        only_live=True,
        helps="stays",
        instead_of="previous_robot",
    ),
    Key(
        "next_floor_plain",
        (">",),
        Message("Next floor"),
        hint=Message("floor"),
        only_live=True,
        instead_of="next_floor",
    ),
    Key(
        "previous_floor_plain",
        ("<",),
        Message("Previous floor"),
        only_live=True,
        instead_of="previous_floor",
    ),
)


TOOLS: tuple[Key[Actions], ...] = (
    Key(
        "diagnostics",
        ("d",),
        Message("Open diagnostics: links, topics, raw messages, logs"),
        helps="leaves",
    ),
    Key("record", (), Message("Record: start or stop a recording")),
    Key(
        "audit",
        ("L",),
        Message("Open the audit log: all commands and alarms with their outcome"),
    ),
    Key(
        "history",
        ("H",),
        Message("History of the shift: events, robots, batteries, alarms, places"),
        only_live=True,
    ),
    Key(
        "programs",
        ("J",),
        Message("Programs of the robot servers: state, start, stop, restart, log"),
        only_live=True,
    ),
    Key(
        "routines",
        ("B",),
        Message("Routines: list, start, pause, resume, stop, progress"),
        only_live=True,
    ),
    Key(
        "desk", (), Message("Desk: consoles, claims, closed edges"), only_live=True
    ),
    Key(
        "facilities",
        ("K",),
        Message("Facilities: lifts, doors, dispensers, closed lanes"),
    ),
    Key(
        "bundle",
        ("b",),
        Message("Write an incident bundle: recording, log and doctor report"),
    ),
    Key(
        "save",
        (),
        Message("Save: write the configuration of this console to a file"),
    ),
)


def _robot(number: int) -> Key[Actions]:
    return Key(
        f"robot_{number}",
        (str(number),),
        Message("Select the robot with number {number}", number=number),
        helps="stays",
    )


CONSOLE: tuple[Key[Actions], ...] = (
    Key(
        "help",
        ("?",),
        Message("Show help: tasks, keys, legend, searchable"),
        hint=Message("help"),
        always=True,
    ),
    Key(
        "help_anywhere",
        ("f1",),
        Message("Show help, also while typing"),
        pane=Pane.ANYWHERE,
        hint=Message("help"),
        in_palette=False,
    ),
    Key(
        "palette",
        (":", "ctrl+p"),
        Message("Open the command palette: actions, robots, vertices, floors"),
        hint=Message("command"),
        in_palette=False,
        always=True,
    ),
    Key(
        "order",
        ("o",),
        Message("Open the order form for the selected robot"),
        hint=Message("order"),
        needs="order",
        commands=True,
        helps="leaves",
    ),
    Key(
        "pause",
        ("p",),
        Message("Pause the selected robot immediately"),
        hint=Message("pause"),
        needs="pause",
        commands=True,
        helps="stays",
    ),
    Key(
        "resume",
        ("r",),
        Message("Resume the selected robot immediately"),
        hint=Message("resume"),
        needs="resume",
        commands=True,
        helps="stays",
    ),
    Key(
        "pause_all",
        ("P",),
        Message("Pause all robots immediately. Not a safety device"),
        hint=Message("pause all"),
        needs="pause",
        commands=True,
        in_dialogs=True,
        of_any=True,
        helps="stays",
    ),
    Key(
        "pause_all_anywhere",
        ("f12",),
        Message("Pause all robots, also while typing. Not a safety device"),
        pane=Pane.ANYWHERE,
        hint=Message("pause all"),
        needs="pause",
        commands=True,
        of_any=True,
        in_palette=False,
    ),
    Key(
        "resume_all",
        ("R",),
        Message("Resume all paused robots (asks first)"),
        hint=Message("resume all"),
        needs="resume",
        commands=True,
        of_any=True,
        helps="stays",
    ),
    Key(
        "why",
        ("w",),
        Message("Explain why the selected robot is not moving"),
        hint=Message("why"),
        helps="leaves",
    ),
    Key(
        "next_trouble",
        ("!",),
        Message("Go to the next robot in trouble, those with an alarm first"),
        hint=Message("look"),
        helps="stays",
    ),
    Key(
        "acknowledge",
        ("a",),
        Message("Acknowledge the alarm under the cursor"),
        hint=Message("ack"),
        helps="stays",
    ),
    Key(
        "cancel",
        ("x",),
        Message("Cancel the order at the queue cursor (asks first)"),
        hint=Message("cancel"),
        needs="cancel",
        commands=True,
        helps="leaves",
    ),
    Key(
        "clear",
        ("X",),
        Message("Clear all orders of the selected robot (asks first)"),
        hint=Message("clear"),
        needs="clear",
        commands=True,
        helps="leaves",
    ),
    Key(
        "charge",
        ("C",),
        Message("Send the selected robot to the nearest charger (asks first)"),
        hint=Message("charge"),
        needs="order",
        commands=True,
        helps="leaves",
    ),
    Key(
        "robot_page",
        ("i",),
        Message("Open the robot's page: values, battery curve, route, orders, alarms"),
        hint=Message("page"),
        helps="leaves",
    ),
    Key(
        "all_orders",
        ("*",),
        Message("Toggle the queue: selected robot or all robots"),
        hint=Message("all orders"),
        of_any=True,
        needs=LISTS,
    ),
    Key(
        "next_robot",
        ("]",),
        Message("Next robot"),
        hint=Message("robot"),
        helps="stays",
    ),
    Key(
        "previous_robot", ("[",), Message("Previous robot"), helps="stays"
    ),
    *PLAIN,
    *map(_robot, range(1, 10)),
    Key("next_floor", ("}",), Message("Next floor"), hint=Message("floor")),
    Key("previous_floor", ("{",), Message("Previous floor")),
    Key("suspend", ("ctrl+z",), Message("Suspend to the shell; fg returns")),
    Key(
        "repaint", ("ctrl+l",), Message("Redraw the screen"), pane=Pane.ANYWHERE
    ),
    Key("quit", ("q",), Message("Quit"), hint=Message("quit"), always=True),
    Key(
        "say_quit",
        ("ctrl+c", "ctrl+q"),
        Message("Show which key quits; sends no command"),
        pane=Pane.ANYWHERE,
        in_palette=False,
        yields=True,
    ),
    Key("back", ("escape",), Message("Go back one level"), in_palette=False),
    Key(
        "enlarge",
        ("=",),
        Message("Enlarge the focused pane to the whole column, or restore it"),
        hint=Message("enlarge"),
    ),
    Key("next_pane", ("tab",), Message("Next pane"), in_palette=False),
    Key(
        "previous_pane",
        ("shift+tab",),
        Message("Previous pane"),
        in_palette=False,
    ),
    Key(
        "simple",
        ("s",),
        Message("Toggle the simple interface: robot, from, to, send"),
        hint=Message("simple"),
        needs="order",
    ),
    *TOOLS,
    Key(
        "arm",
        (),
        Message("Arm: allow or block commands from this console"),
        only_live=True,
    ),
    Key("acknowledge_all", ("A",), Message("Acknowledge all alarms")),
    Key(
        "alarm_menu",
        (),
        Message("Open the marked alarm's menu: explain, acknowledge, shelve, unshelve"),
    ),
)

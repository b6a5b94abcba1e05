"""Every key of the console in one table: bindings, help, palette and the config check come from it."""

from msgspec import Struct


class Key(Struct, frozen=True):
    """`id` names it in the config; `keys` are the defaults; `action` is Textual's action string;
    `pane` is where it works: "map", "table", "console", "recording" (everywhere while one is played),
    "diagnostics" (that screen alone), or "anywhere", which reaches through text fields, forms and
    modals; `hint` is the footer's word, empty to stay out of the footer; `needs` is what a robot must
    accept for it to be offered."""

    id: str
    keys: tuple[str, ...]
    action: str
    text: str
    pane: str = "console"
    hint: str = ""
    needs: str = ""

    @property
    def section(self) -> str:
        """Where help lists it: the map's keys work from every pane, and are still the map's."""
        return "map" if self.action.startswith("on_map") else self.pane


PAGES = {
    "Link": "is it there, round trip, rates, reconnects, drops",
    "Topics": "rate, age, errors of each; Enter shows its last message",
    "Raw": "the last message of a topic",
    "Log": "what the robots log (/rosout)",
    "Health": "what they report of themselves (/diagnostics)",
    "Console": "what its pictures cost, and its own log",
}
"""The pages of the diagnostics screen, each with what is on it."""

KEYS: tuple[Key, ...] = (
    Key("help", ("?",), "help", "Help: every key, searchable", hint="help"),
    Key("help_anywhere", ("f1",), "help", "Help, also while typing", pane="anywhere", hint="help"),
    Key(
        "palette",
        (":", "ctrl+p"),
        "palette",
        "Command palette: every action, go to robot, vertex, floor",
        hint="command",
    ),
    Key("suspend", ("ctrl+z",), "app.suspend_process", "To the shell; fg comes back"),
    Key("repaint", ("ctrl+l",), "app.repaint", "Redraw the screen", pane="anywhere"),
    Key("quit", ("q",), "app.quit", "Leave"),
    Key("back", ("escape",), "back", "One level back"),
    Key("next_pane", ("tab",), "app.focus_next", "Next pane"),
    Key("previous_pane", ("shift+tab",), "app.focus_previous", "Previous pane"),
    Key("next_robot", ("]",), "step_robot(1)", "Next robot", hint="robot"),
    Key("previous_robot", ("[",), "step_robot(-1)", "Previous robot"),
    *(Key(f"robot_{n}", (str(n),), f"robot({n})", f"Robot number {n} of the config") for n in range(1, 10)),
    Key("next_floor", ("}",), "step_floor(1)", "Next floor", hint="floor"),
    Key("previous_floor", ("{",), "step_floor(-1)", "Previous floor"),
    Key("order", ("o",), "order", "Order form for the selected robot", hint="order", needs="order"),
    Key(
        "simple",
        ("s",),
        "simple",
        "Simple interface on or off: robot, from, to, send",
        hint="simple",
        needs="order",
    ),
    Key("why", ("w",), "why", "Why does the selected robot stand still: reasons and what helps", hint="why"),
    Key(
        "cancel",
        ("x",),
        "cancel",
        "Cancel the order under the queue's cursor (asks once)",
        hint="cancel",
        needs="cancel",
    ),
    Key(
        "clear",
        ("X",),
        "clear",
        "Clear all orders of the selected robot (asks once)",
        hint="clear",
        needs="clear",
    ),
    Key("pause", ("p",), "pause", "Pause the selected robot, at once", hint="pause", needs="pause"),
    Key("resume", ("r",), "resume", "Resume the selected robot, at once", hint="resume", needs="resume"),
    Key(
        "pause_all",
        ("P",),
        "pause_all",
        "Pause every robot, at once. Not a safety device",
        hint="pause all",
        needs="pause",
    ),
    Key(
        "pause_all_anywhere",
        ("f12",),
        "pause_all",
        "Pause every robot, also while typing. Not a safety device",
        pane="anywhere",
        hint="pause all",
        needs="pause",
    ),
    Key(
        "all_orders",
        ("*",),
        "all_orders",
        "Queue: orders of the selected robot, or of all robots",
        hint="all orders",
    ),
    Key("diagnostics", ("d",), "diagnostics", "Diagnostics: links, topics, raw messages, logs, live"),
    Key("record", (), "record", "Record: start or stop a recording"),
    Key("audit", ("L",), "audit", "Audit log: every command and alarm, and how it went on"),
    Key("bundle", ("b",), "bundle", "Incident bundle: recording, log, doctor's report in one archive"),
    Key("save", (), "save", "Save: write the configuration of this console to a file"),
    Key("arm", (), "arm", "Arm: let commands leave this console, or no longer"),
    Key("acknowledge", ("a",), "acknowledge", "Acknowledge the alarm under the cursor", hint="ack"),
    Key("acknowledge_all", ("A",), "acknowledge_all", "Acknowledge all alarms"),
    Key("play", ("space",), "playback('toggle')", "Play or stop", pane="recording", hint="play/stop"),
    Key("skip_back", ("<",), "playback('skip', -10)", "10 s back", pane="recording"),
    Key("skip_on", (">",), "playback('skip', 10)", "10 s on", pane="recording", hint="10 s"),
    Key(
        "previous_mark", ("(",), "playback('to_mark', -1)", "Previous alarm, command or gap", pane="recording"
    ),
    Key("next_mark", (")",), "playback('to_mark', 1)", "Next alarm, command or gap", "recording", "mark"),
    Key("step_back", (",",), "playback('step', -1)", "One tick back: 0.1 s", pane="recording"),
    Key("step_on", (".",), "playback('step', 1)", "One tick on: 0.1 s", pane="recording", hint="step"),
    Key("record_back", (";",), "playback('step_record', -1)", "One record back", pane="recording"),
    Key(
        "record_on", ("'",), "playback('step_record', 1)", "One record on: a message, or a fact", "recording"
    ),
    Key("faster", ("F",), "playback('change_speed', 1)", "Faster: up to x64", "recording", "faster"),
    Key("slower", ("S",), "playback('change_speed', -1)", "Slower: down to x0.25", "recording", "slower"),
    Key("usual_speed", ("backspace",), "playback('change_speed', 0)", "As fast as it was", pane="recording"),
    Key(
        "go_to_time",
        ("@",),
        "go_to_time",
        "Go to a time: 12:04:31, or +1m30s from the beginning",
        "recording",
        "time",
    ),
    Key("to_beginning", ("home",), "playback('to_end', -1)", "To the beginning", pane="recording"),
    Key("to_the_end", ("end",), "playback('to_end', 1)", "To the end", pane="recording"),
    Key("zoom_in", ("+", "="), "on_map('zoom_in')", "Zoom in", hint="zoom"),
    Key("zoom_out", ("-",), "on_map('zoom_out')", "Zoom out"),
    Key("fit", ("0",), "on_map('fit')", "Fit the whole floor", hint="fit"),
    Key(
        "zoom_about", ("z",), "on_map('zoom_about')", "Zoom about the robot, or about the centre of the view"
    ),
    Key("follow", ("f",), "on_map('follow')", "Follow the selected robot on or off", hint="follow"),
    Key("centre", ("c",), "on_map('centre')", "Centre on the selected robot, once", hint="centre"),
    Key("edges", ("e",), "on_map('edges')", "Edges on or off"),
    Key("labels", ("v",), "on_map('labels')", "Labels on or off"),
    Key("trails", ("t",), "on_map('trails')", "Trails on or off: where robots were in the last minute"),
    Key("drawing", ("m",), "on_map('drawing')", "Drawing: braille, half-block, ASCII"),
    Key("map_cursor", ("g",), "on_map('cursor')", "Map cursor on or off: arrows move it"),
    Key("next_vertex", ("n",), "on_map('next_vertex', 1)", "Next labelled vertex under the map cursor"),
    Key("previous_vertex", ("N",), "on_map('next_vertex', -1)", "Previous labelled vertex"),
    Key("pan_left", ("left", "h"), "pan_map(-1, 0)", "Pan left", pane="map"),
    Key("pan_right", ("right", "l"), "pan_map(1, 0)", "Pan right", pane="map"),
    Key("pan_up", ("up", "k"), "pan_map(0, -1)", "Pan up", pane="map"),
    Key("pan_down", ("down", "j"), "pan_map(0, 1)", "Pan down", pane="map"),
    Key(
        "pick",
        ("enter",),
        "pick",
        "Order from the vertex (with cargo: to it), or select the robot, under the cursor",
        pane="map",
    ),
    *(
        Key(f"page_{name.lower()}", (str(n),), f"page({n})", f"Page {n}: {text}", pane="diagnostics")
        for n, (name, text) in enumerate(PAGES.items(), 1)
    ),
    Key("next_page", ("tab",), "step_page(1)", "Next page", pane="diagnostics"),
    Key("previous_page", ("shift+tab",), "step_page(-1)", "Previous page", pane="diagnostics"),
    Key(
        "filter",
        ("/",),
        "filter",
        "Filter the rows by text; Enter or Esc leaves it",
        pane="diagnostics",
    ),
    Key(
        "freeze",
        ("space", "f"),
        "freeze",
        "Freeze the message or the robots' log, or go on",
        pane="diagnostics",
    ),
    Key(
        "copy",
        ("y",),
        "copy",
        "Copy the message, or the row, to the clipboard (OSC 52)",
        pane="diagnostics",
    ),
    Key(
        "level",
        ("v",),
        "level",
        "Robots' log: all levels, or only the worse ones",
        pane="diagnostics",
    ),
    Key("bad", ("b",), "bad", "Raw: the last message, or the last bad one", pane="diagnostics"),
    Key("leave", ("escape", "q"), "leave", "One level back", pane="diagnostics"),
    Key("row_up", ("up", "k"), "move(-1)", "Row up", pane="table"),
    Key("row_down", ("down", "j"), "move(1)", "Row down", pane="table"),
    Key("column_left", ("left", "h"), "slide(-1)", "Scroll left", pane="table"),
    Key("column_right", ("right", "l"), "slide(1)", "Scroll right", pane="table"),
    Key("page_up", ("pageup",), "move(-10)", "Ten rows up", pane="table"),
    Key("page_down", ("pagedown",), "move(10)", "Ten rows down", pane="table"),
    Key("menu", ("enter",), "menu", "Menu of the row", pane="table", hint="menu"),
)

"""Every key of the console in one table: bindings, help, palette and the config check come from it."""

from collections.abc import Iterable, Mapping

from msgspec import Struct

from fleet_tui.errors import did_you_mean


class Key(Struct, frozen=True):
    """`id` names it in the config; `keys` are the defaults; `action` is Textual's action string;
    `pane` is where it works: "map", "table", "console", or "anywhere", which reaches through text
    fields, forms and modals; `hint` is the footer's word, empty to stay out of the footer."""

    id: str
    keys: tuple[str, ...]
    action: str
    text: str
    pane: str = "console"
    hint: str = ""

    @property
    def section(self) -> str:
        """Where help lists it: the map's keys work from every pane, and are still the map's."""
        return "map" if self.action.startswith("on_map") else self.pane


KEYS: tuple[Key, ...] = (
    Key("help", ("?",), "help", "Help: every key, searchable", hint="help"),
    Key("help_anywhere", ("f1",), "help", "Help, also while typing", pane="anywhere"),
    Key(
        "palette",
        (":", "ctrl+p"),
        "palette",
        "Command palette: every action, go to robot, vertex, floor",
        hint="command",
    ),
    Key("suspend", ("ctrl+z",), "app.suspend_process", "To the shell; fg comes back"),
    Key("repaint", ("ctrl+l",), "app.repaint", "Paint the whole screen anew"),
    Key("quit", ("q",), "app.quit", "Leave"),
    Key("back", ("escape",), "back", "One level back"),
    Key("next_pane", ("tab",), "app.focus_next", "Next pane"),
    Key("previous_pane", ("shift+tab",), "app.focus_previous", "Previous pane"),
    Key("next_robot", ("]",), "step_robot(1)", "Next robot", hint="robot"),
    Key("previous_robot", ("[",), "step_robot(-1)", "Previous robot"),
    *(Key(f"robot_{n}", (str(n),), f"robot({n})", f"Robot number {n} of the config") for n in range(1, 10)),
    Key("next_floor", ("}",), "step_floor(1)", "Next floor", hint="floor"),
    Key("previous_floor", ("{",), "step_floor(-1)", "Previous floor"),
    Key("order", ("o",), "order", "Order form for the selected robot", hint="order"),
    Key("simple", ("s",), "simple", "Simple interface on or off: robot, from, to, send", hint="simple"),
    Key("why", ("w",), "why", "Why does the selected robot stand still: reasons and what helps", hint="why"),
    Key("cancel", ("x",), "cancel", "Cancel the order under the queue's cursor (asks once)", hint="cancel"),
    Key("clear", ("X",), "clear", "Clear all orders of the selected robot (asks once)", hint="clear"),
    Key("pause", ("p",), "pause", "Pause the selected robot, at once", hint="pause"),
    Key("resume", ("r",), "resume", "Resume the selected robot, at once", hint="resume"),
    Key(
        "pause_all", ("P",), "pause_all", "Pause every robot, at once. Not a safety device", hint="pause all"
    ),
    Key(
        "pause_all_anywhere",
        ("f12",),
        "pause_all",
        "Pause every robot, also while typing. Not a safety device",
        pane="anywhere",
    ),
    Key(
        "all_orders",
        ("*",),
        "all_orders",
        "Queue: orders of the selected robot, or of all robots",
        hint="all orders",
    ),
    Key("audit", ("L",), "audit", "Audit log: every command and alarm, and how it went on"),
    Key("arm", (), "arm", "Arm: let commands leave this console, or no longer"),
    Key("acknowledge", ("a",), "acknowledge", "Acknowledge the alarm under the cursor", hint="ack"),
    Key("acknowledge_all", ("A",), "acknowledge_all", "Acknowledge all alarms"),
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
    Key("row_up", ("up", "k"), "move(-1)", "Row up", pane="table"),
    Key("row_down", ("down", "j"), "move(1)", "Row down", pane="table"),
    Key("column_left", ("left", "h"), "slide(-1)", "Scroll left", pane="table"),
    Key("column_right", ("right", "l"), "slide(1)", "Scroll right", pane="table"),
    Key("page_up", ("pageup",), "move(-10)", "Ten rows up", pane="table"),
    Key("page_down", ("pagedown",), "move(10)", "Ten rows down", pane="table"),
    Key("menu", ("enter",), "menu", "Menu of the row", pane="table", hint="menu"),
)

_BY_ID = {key.id: key for key in KEYS}

# Textual's names of keys that print nothing.
_NAMED = frozenset(
    [*("enter", "tab", "escape", "space", "backspace", "delete", "insert", "home", "end")]
    + [*("pageup", "pagedown", "up", "down", "left", "right")]
    + [f"f{n}" for n in range(1, 25)]
)
# Ctrl-C never commands a robot; these arrive from a terminal as other keys.
_FORBIDDEN = {
    "ctrl+c": "Ctrl-C is kept free",
    "ctrl+i": "a terminal sends it as tab",
    "ctrl+m": "a terminal sends it as enter",
    "ctrl+[": "a terminal sends it as escape",
}


def _problem_of_key(key: str) -> str | None:
    """Why a key can't be bound, None where it can."""
    if key in _FORBIDDEN:
        return _FORBIDDEN[key]
    *modifiers, last = key.split("+") if len(key) > 1 else [key]
    known = (len(last) == 1 and last.isprintable() and not last.isspace()) or last in _NAMED
    if not known:
        return f"no such key{did_you_mean(last, _NAMED)}"
    if len(last) == 1 and "shift" in modifiers:
        return "write the shifted character itself"
    if len(last) == 1 and last.isupper() and "ctrl" in modifiers:
        return f"a terminal sends it as {key.lower()}"
    wrong = [name for name in modifiers if name not in ("ctrl", "shift", "alt")]
    return f"no such modifier {wrong[0]}, use ctrl, shift or alt" if wrong else None


def _types_nothing(key: str) -> bool:
    """Whether a key means nothing to a text field: a space or an arrow would be taken from it."""
    *modifiers, last = key.split("+")
    return "ctrl" in modifiers or "alt" in modifiers or (len(last) > 1 and last[1:].isdigit())


def _same_place(one: Key, other: Key) -> bool:
    """Whether two keys can be pressed at the same moment."""
    return one.pane == other.pane or not {"console", "anywhere"}.isdisjoint((one.pane, other.pane))


def keymap(changes: Mapping[str, str]) -> tuple[dict[str, tuple[str, ...]], list[str]]:
    """The keys of every id after the config's `changes` (id = "key" or "key,key"), and one line
    for each problem: unknown id, impossible key, two ids on one key."""
    problems = []
    chosen = {key.id: key.keys for key in KEYS}
    for id_, text in changes.items():
        if id_ not in _BY_ID:
            problems.append(f"keys.{id_}: no such key id{did_you_mean(id_, _BY_ID)}")
            continue
        keys = ("," if text == "," else part.strip() for part in ([text] if text == "," else text.split(",")))
        chosen[id_] = tuple(keys)
        for key in chosen[id_]:
            wrong = _problem_of_key(key)
            if _BY_ID[id_].pane == "anywhere" and not _types_nothing(key):
                wrong = "works while typing too, so it must be a function key or a ctrl key"
            if wrong:
                problems.append(f"keys.{id_}: {key!r}: {wrong}")
    problems.extend(_clashes(chosen))
    return chosen, problems


def _clashes(chosen: Mapping[str, Iterable[str]]) -> list[str]:
    taken: dict[str, list[Key]] = {}
    problems = []
    for id_, keys in chosen.items():
        this = _BY_ID[id_]
        for key in keys:
            for other in taken.setdefault(key, []):
                if _same_place(this, other):
                    problems.append(
                        f"keys.{id_}: {key!r} is taken by {other.id}: give one of them another key"
                    )
            taken[key].append(this)
    return problems

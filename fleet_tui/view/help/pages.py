"""The pages of help: tasks, keys, the legend, typed commands."""

from collections.abc import Collection, Mapping, Sequence

from fleet_tui.keys import KEYS, Pane, outdone
from fleet_tui.model.kind import GOAL, LOCALISE, MAP_SAVE, MAPPING, POSE, SETTLE, Kind
from fleet_tui.text.language import tr
from fleet_tui.view.help.legend import legend
from fleet_tui.view.help.section import HelpRow, HelpSection, key_row, translated
from fleet_tui.view.help.synonyms import SYNONYMS
from fleet_tui.view.help.tasks import ROBOTS, tasks
from fleet_tui.view.map.layers import MapOptions
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Button, Run, width_of

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
        ("robot_0 Base > Store", "an order"),
        ("robot_0 A > B > C", "an order with legs"),
        ("robot_0 > B", "{alone} to B"),
        ("anyone Base > Store", "nearest idle robot"),
        ('order robot_0 Base "Dock 7"', "labels with spaces"),
    ),
    "cancel": (("cancel 12, cancel robot_0 12", "one order"),),
    "clear": (("clear robot_0", "all its orders"),),
    "pause": (("pause robot_0, pause all", "immediately"),),
    "resume": (("resume robot_0, resume all", "immediately"),),
    GOAL: (
        ("goto robot_0 Base", "to a place"),
        ("goto robot_0 3.5 2 90", "to a point: m, degrees"),
    ),
    POSE: (("set-pose robot_0 3.5 2 90", "its pose: m, degrees"),),
    LOCALISE: (("localise robot_0", "search the whole map"),),
    SETTLE: (("settle robot_0", "refine its pose, standing"),),
    MAPPING: (("mapping robot_0 on", "mapping on, or off"),),
    MAP_SAVE: (("store-map robot_0 hall", "a map on its own disk"),),
}
"""Examples of typed commands and their meaning, by the verb that a kind must accept."""

ALWAYS = (
    ("robot_1, Base, floor_1", "go there"),
    ("save config.toml", "write the configuration"),
    ("save-map hall.yaml", "write the shown map"),
    ("claim robot_3", "others are asked before they command it"),
    ("close Hall Dock", "close an edge for all of the desk; open"),
    ("note lift B is slow", "a note for the next shift"),
    ("theme, record, arm, ...", "any action, by a word"),
)
"""Examples of typed lines that need no robot."""

NOTES = (
    "Robots go by name or number, places by label or id; id=7 is always the id.",
    "Order form: typing filters the labels, Enter takes the marked one; > after a label adds a leg.",
    "The same order within 1 s is not sent twice.",
    "Confirmations: y confirms; n, Esc or Enter cancels.",
    "Mouse: wheel zooms at the pointer, drag pans, click selects, also the keys in the last line. "
    "To select text with the terminal, hold Shift.",
    "Pause is not a safety device: near people, use the robot's own stop.",
)


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
        "Tasks": [*own, *tasks(keys, hidden)],
        "Keys": [section for section in every if section.rows],
        "Legend": legend(look),
        "Commands": [_typed(kind), HelpSection("Notes", _texts((*NOTES, terminal)))],
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
            rows.append(key_row(ROBOTS, "Select a robot by its number in the configuration", keys, 9))
        else:
            ids = [key.id, *filter(None, [key.instead_of])]
            rows.append(key_row(ids, key.text, keys, 9, SYNONYMS.get(key.id, "")))
    return HelpSection(pane.value, tuple(rows))


def _typed(kind: Kind) -> HelpSection:
    alone = "cargo on board" if kind.brings_cargo else "directly"
    accepted = [example for verb, examples in TYPED.items() if kind.can(verb) for example in examples]
    rows = [
        HelpRow(((example, StyleRole.KEY),), tr(text).format(alone=tr(alone)))
        for example, text in (*accepted, *ALWAYS)
    ]
    return HelpSection("Typed commands: Tab completes, Enter sends", tuple(rows))


def _texts(texts: Sequence[str]) -> tuple[HelpRow, ...]:
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

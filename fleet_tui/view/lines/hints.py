"""The footer: the keys that work where the focus is."""

from collections.abc import Collection, Mapping

from fleet_tui.keys import KEYS, Key
from fleet_tui.model.fleet import FleetState
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Run

ALWAYS = ("palette", "help")
COMMANDS = frozenset({"order", "cancel", "clear", "pause", "resume", "pause_all", "pause_all_anywhere"})
"""Keys that command robots: a console that can't does not offer them."""


OF_ANY = frozenset({"pause_all", "pause_all_anywhere"})
"""Those that are there as soon as one robot of the fleet can do it."""


def hidden_keys(state: FleetState, selected: str) -> set[str]:
    """The ids of keys that the kind of the selected robot, or the whole fleet, has nothing for."""
    robots = list(state.robots.values())
    hidden = set[str]()
    for key in KEYS:
        asked = robots if key.id in OF_ANY else [state.robots[selected]]
        if key.needs and not any(robot.kind.can(key.needs) for robot in asked):
            hidden.add(key.id)
    if not any(robot.kind.lists_orders for robot in robots):
        hidden.add("all_orders")
    return hidden


def _runs(key: Key, keys: Mapping[str, tuple[str, ...]]) -> list[Run]:
    shown = keys[key.id][0]
    return [(f" {shown} ", StyleRole.KEY), (f"{key.hint} ", StyleRole.DIM)]


def hints(
    keys: Mapping[str, tuple[str, ...]],
    pane: str,
    can_command: bool = True,
    hidden: Collection[str] = (),
) -> tuple[list[Run], list[Run]]:
    """Hints for the left, the pane's own first, and for the right what is always there. In an overlay
    only what works "anywhere" reaches the console. `hidden`: ids of keys that nothing here has a use for."""
    away = {*hidden, *(() if can_command else COMMANDS)}
    offered = [key for key in KEYS if key.hint and keys[key.id] and key.id not in away]
    if pane == "anywhere":
        left, right = [key for key in offered if key.pane == pane], []
    else:
        offered.sort(key=lambda key: key.pane != pane)
        left = [key for key in offered if key.pane in (pane, "console") and key.id not in ALWAYS]
        right = [key for key in offered if key.id in ALWAYS]
    return [run for key in left for run in _runs(key, keys)], [
        run for key in right for run in _runs(key, keys)
    ]

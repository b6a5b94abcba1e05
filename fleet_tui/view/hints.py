"""The footer: the keys that work where the focus is."""

from collections.abc import Mapping

from fleet_tui.keys import KEYS, Key
from fleet_tui.view.roles import Ink
from fleet_tui.view.table import Run

ALWAYS = ("palette", "help")
COMMANDS = frozenset({"order", "cancel", "clear", "pause", "resume", "pause_all", "pause_all_anywhere"})
"""Keys that command robots: a console that can't does not offer them."""


def _runs(key: Key, keys: Mapping[str, tuple[str, ...]]) -> list[Run]:
    shown = keys[key.id][0]
    return [(f" {shown} ", Ink.KEY), (f"{key.hint} ", Ink.DIM)]


def hints(
    keys: Mapping[str, tuple[str, ...]], pane: str, can_command: bool = True
) -> tuple[list[Run], list[Run]]:
    """Hints for the left, the pane's own first, and for the right what is always there. In an overlay
    only what works "anywhere" reaches the console."""
    offered = [key for key in KEYS if key.hint and keys[key.id] and (can_command or key.id not in COMMANDS)]
    if pane == "anywhere":
        left, right = [key for key in offered if key.pane == pane], []
    else:
        offered.sort(key=lambda key: key.pane != pane)
        left = [key for key in offered if key.pane in (pane, "console") and key.id not in ALWAYS]
        right = [key for key in offered if key.id in ALWAYS]
    return [run for key in left for run in _runs(key, keys)], [
        run for key in right for run in _runs(key, keys)
    ]

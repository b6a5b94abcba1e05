"""The footer: the keys that work where the focus is."""

from collections.abc import Mapping

from fleet_tui.keys import KEYS, Key
from fleet_tui.view.roles import Ink
from fleet_tui.view.table import Run

ALWAYS = ("palette", "help")


def _runs(key: Key, keys: Mapping[str, tuple[str, ...]]) -> list[Run]:
    shown = keys[key.id][0]
    return [(f" {shown} ", Ink.KEY), (f"{key.hint} ", Ink.DIM)]


def hints(keys: Mapping[str, tuple[str, ...]], pane: str) -> tuple[list[Run], list[Run]]:
    """Hints for the left, the pane's own first, and for the right what is always there. In an overlay
    only what works "anywhere" reaches the console."""
    if pane == "anywhere":
        return [run for key in KEYS if key.pane == pane and keys[key.id] for run in _runs(key, keys)], []
    hinted = sorted((key for key in KEYS if key.hint and keys[key.id]), key=lambda key: key.pane != pane)
    left = [key for key in hinted if key.pane in (pane, "console") and key.id not in ALWAYS]
    right = [key for key in hinted if key.id in ALWAYS]
    return [run for key in left for run in _runs(key, keys)], [
        run for key in right for run in _runs(key, keys)
    ]

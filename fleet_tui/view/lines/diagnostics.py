"""The first and the last line of the diagnostics screen: its pages, and the keys of the one that is shown."""

from collections.abc import Mapping, Sequence

from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Run

_KEYS = {
    1: (),
    2: ("filter", "copy"),
    3: ("freeze", "bad", "copy"),
    4: ("filter", "level", "freeze", "copy"),
    5: ("filter", "copy"),
    6: ("filter", "copy"),
}
"""The keys of each page beside those of all."""
_ENTER = {1: "topics", 2: "its message", 5: "values"}
"""What Enter does."""


def page_runs(names: Sequence[str], shown: int, frozen: str) -> tuple[list[Run], list[Run]]:
    """All pages, the one that is shown in brackets; at the right, that and since when it is frozen."""
    runs: list[Run] = []
    for number, name in enumerate(names, 1):
        is_shown = number == shown
        text = f"[{number} {name}]" if is_shown else f" {number} {name} "
        runs.append((text, StyleRole.TITLE_FOCUSED if is_shown else StyleRole.DIM))
    return runs, [(frozen, StyleRole.WARN)] if frozen else []


def foot_runs(keys: Mapping[str, tuple[str, ...]], page: int, said: str) -> tuple[list[Run], list[Run]]:
    """Return what came of the last key, else the keys at the right."""
    if said:
        return [(sanitize(said), StyleRole.WARN)], []
    hints: list[tuple[str, str]] = []
    if page in _ENTER:
        hints.append((keys["menu"][0], _ENTER[page]))
    hints += [(keys[id_][0], id_) for id_ in _KEYS[page] if keys[id_]]
    hints += [(keys[id_][0], word) for id_, word in (("next_page", "page"), ("leave", "back")) if keys[id_]]
    runs: list[Run] = []
    for key, word in hints:
        runs += [(f" {key} ", StyleRole.KEY), (f"{word} ", StyleRole.DIM)]
    return [], runs

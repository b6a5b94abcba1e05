"""The first and the last line of the diagnostics screen: its pages, and the keys of the open one."""

from collections.abc import Mapping, Sequence

from fleet_tui.keys import PAGES
from fleet_tui.keys.key import key_name
from fleet_tui.text.language import N_, Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run


def page_runs(names: Sequence[str], shown: int, frozen: str) -> tuple[list[Run], list[Run]]:
    """Return all pages, the open one in brackets; at the right, the time since it was frozen."""
    runs: list[Run] = []
    for number, name in enumerate(names, 1):
        is_shown = number == shown
        text = f"[{number} {tr(name)}]" if is_shown else f" {number} {tr(name)} "
        runs.append((text, StyleRole.TITLE_FOCUSED if is_shown else StyleRole.DIM))
    return runs, [(frozen, StyleRole.WARN)] if frozen else []


def foot_runs(keys: Mapping[str, tuple[str, ...]], page: int, said: Message) -> tuple[list[Run], list[Run]]:
    """Return the response to the last key, else the keys, at the right."""
    if said:
        return [(translate(sanitize(said)), StyleRole.WARN)], []
    hints: list[tuple[str, str]] = []
    shown = list(PAGES.values())[page - 1]
    if shown.enter:
        hints.append((keys["menu"][0], shown.enter))
    hints += [(keys[id_][0], id_) for id_ in shown.keys if keys[id_]]
    hints += [
        (keys[id_][0], word) for id_, word in (("next_page", N_("page")), ("leave", N_("back"))) if keys[id_]
    ]
    runs: list[Run] = []
    for key, word in hints:
        runs += [(f" {key_name(key)} ", StyleRole.KEY), (f"{tr(word)} ", StyleRole.DIM)]
    return [], runs

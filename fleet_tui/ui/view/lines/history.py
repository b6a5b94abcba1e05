"""The first and the last line of the history: its pages and its time, and the keys of the open page."""

from collections.abc import Mapping

from fleet_tui.keys import HISTORY_PAGES
from fleet_tui.keys.key import key_name
from fleet_tui.text.language import N_, Message, tr, translate
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run, width_of

ALL_FROM = 74
"""Cells from which all pages are named."""
HINTS = (
    ("history_replay", N_("recording")),
    ("history_filter", N_("filter")),
    ("history_next_page", N_("page")),
    ("history_earlier", N_("earlier")),
    ("history_longer", N_("longer")),
    ("history_leave", N_("back")),
)


def page_runs(page: int, span: str, until: str, width: int) -> tuple[list[Run], list[Run]]:
    """Return the title, all pages, the open one in brackets, in few cells that one alone; at the right the
    time that is shown."""
    title, time = (
        (tr("History "), StyleRole.TITLE),
        [(tr("{span} to {until} ", span=span, until=until), StyleRole.TEXT)],
    )
    runs: list[Run] = [title]
    for number, name in enumerate(HISTORY_PAGES, 1):
        is_shown = number == page
        text = f"[{number} {tr(name)}]" if is_shown else f" {number} {tr(name)} "
        runs.append((text, StyleRole.TITLE_FOCUSED if is_shown else StyleRole.DIM))
    if width >= ALL_FROM and width_of(runs) + width_of(time) < width:
        return runs, time
    name = list(HISTORY_PAGES)[page - 1]
    return [
        title,
        (
            tr("[{page} of {pages} {name}]", page=page, pages=len(HISTORY_PAGES), name=tr(name)),
            StyleRole.TITLE_FOCUSED,
        ),
    ], time


def foot_runs(keys: Mapping[str, tuple[str, ...]], page: str, said: Message) -> tuple[list[Run], list[Run]]:
    """Return the response to the last key, else the keys, at the right."""
    if said:
        return [(translate(sanitize(said)), StyleRole.WARN)], []
    own = [("history_floor", N_("floor"))] if page == "Places" else []
    runs: list[Run] = []
    for id_, word in [*own, *HINTS]:
        if keys[id_]:
            runs += [(f" {key_name(keys[id_][0])} ", StyleRole.KEY), (f"{tr(word)} ", StyleRole.DIM)]
    return [], runs

"""The screens before the console: no configuration, or uncertain findings."""

import textwrap
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from fleet_tui.text.sanitize import fit, sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run, column, cut

Rows = list[tuple[Run, ...]]

_COUNT = 11  # cells
_ROOMY = 18  # rows


class Asked(NamedTuple):
    """The state of a discovery: `words` are its result, its problem or its progress; `more` follows below."""

    address: str
    words: str
    more: tuple[str, ...] = ()
    is_found: bool = False
    is_over: bool = False


class Line(NamedTuple):
    """A choice: its subject, its current value, and the number of the option (0: none of them)."""

    text: str
    chosen: str
    number: int
    of: int


def commands(address: str) -> tuple[tuple[str, str], ...]:
    """Return commands that need no configuration, with their effects."""
    return (
        ("fleet-tui demo", "try it on simulated robots"),
        ("fleet-tui config init", "print an example to edit"),
        (f"fleet-tui doctor --url {address}", "find what is wrong"),
    )


def first_run_rows(places: Sequence[tuple[str, str]], asked: Asked, width: int, height: int) -> Rows:
    """Return the searched paths, the findings at an address, and the possible actions."""
    is_roomy = height >= _ROOMY
    about = "watch and command robots over rosbridge" if is_roomy else "no configuration found"
    rows: Rows = [((" fleet-tui", StyleRole.TITLE_FOCUSED), (f"  {about}", StyleRole.TEXT))]
    if is_roomy:
        rows += [(), ((" No fleet is set up here: no configuration found", StyleRole.TEXT),)]
    rows += _pairs(places, StyleRole.TEXT)
    rows += [(), *_asked(asked, width), ()]
    if is_roomy:
        rows.append(((" d opens a simulated fleet. In a shell:", StyleRole.TEXT),))
    rows += _pairs(commands(asked.address), StyleRole.KEY)
    return _fitted(rows, width, height)


def _pairs(pairs: Sequence[tuple[str, str]], role: StyleRole) -> Iterator[tuple[Run, ...]]:
    wide = column((sanitize(name) for name, _ in pairs), at_most=50)
    for name, text in pairs:
        yield (f"   {fit(sanitize(name), wide)}", role), (f"  {text}", StyleRole.DIM)


def _asked(asked: Asked, width: int) -> Iterator[tuple[Run, ...]]:
    role = StyleRole.GOOD if asked.is_found else StyleRole.WARN if asked.is_over else StyleRole.DIM
    yield (" Robots at ", StyleRole.TEXT), (sanitize(asked.address), StyleRole.ACCENT)
    for n, words in enumerate((asked.words, *asked.more)):
        for line in textwrap.wrap(sanitize(words), max(20, width - 4), break_on_hyphens=False):
            yield ((f"   {line}", role if n == 0 else StyleRole.TEXT),)


def arrival_rows(
    summary: str, lines: Sequence[Line], lacks: Sequence[str], cursor: int, width: int, height: int
) -> Rows:
    """Return the findings, and each choice with its current value."""
    head: Rows = [((f" {sanitize(summary)}", StyleRole.TITLE_FOCUSED),)]
    said = [*(sanitize(lack) for lack in lacks)]
    if lines:
        said.append("Please check. No commands are sent before the console opens.")
    for text in said:
        wrapped = textwrap.wrap(text, max(20, width - 2), break_on_hyphens=False)
        head += [((f" {line}", StyleRole.WARN if text in lacks else StyleRole.TEXT),) for line in wrapped]
    space = max(1, height - len(head) - 1)
    first = max(0, min(cursor - space + 1, len(lines) - space))
    shown = [_choice(line, n == cursor, width) for n, line in enumerate(lines) if first <= n < first + space]
    return _fitted([*head, (), *shown], width, height)


def _choice(line: Line, is_here: bool, width: int) -> tuple[Run, ...]:
    about = max(16, width * 2 // 5)
    count = f"{line.number or 'none'} of {line.of}".rjust(_COUNT)
    text = fit(sanitize(line.text), about)
    chosen = fit(sanitize(line.chosen), max(8, width - about - _COUNT - 8))
    return (
        (" > " if is_here else "   ", StyleRole.ACCENT),
        (text, StyleRole.TITLE_FOCUSED if is_here else StyleRole.TEXT),
        (f" < {chosen} >", StyleRole.ACCENT if is_here else StyleRole.TEXT),
        (count, StyleRole.DIM),
    )


def footer(keys: Sequence[tuple[str, str]]) -> list[Run]:
    return [run for key, text in keys for run in ((f" {key} ", StyleRole.KEY), (f"{text} ", StyleRole.DIM))]


def _fitted(rows: Rows, width: int, height: int) -> Rows:
    """Return exactly as many rows as fit: blank ones are dropped first."""
    while len(rows) > height and () in rows:
        rows.remove(())
    rows = [*rows, *[()] * (height - len(rows))]
    return [cut(row, width) for row in rows[:height]]

"""The screens before the console: nothing is configured, or something of what was found is not certain."""

import textwrap
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from fleet_tui.view.roles import Ink
from fleet_tui.view.table import Run, column, cut
from fleet_tui.view.text import fit, visible

Rows = list[tuple[Run, ...]]

COMMANDS = (
    ("fleet-tui demo", "a simulated fleet"),
    ("fleet-tui config init", "an example to edit"),
    ("fleet-tui doctor --url URL", "what is wrong on the way"),
)

_COUNT = 11  # cells


class Asked(NamedTuple):
    """How the question at an address stands: `words` tell what was found, or why nothing was, or how far it
    is; `more` follows below."""

    address: str
    words: str
    more: tuple[str, ...] = ()
    is_found: bool = False
    is_over: bool = False


class Line(NamedTuple):
    """A choice: what it is about, what holds, and which of how many options that is (0: none of them)."""

    text: str
    chosen: str
    number: int
    of: int


def first_run_rows(places: Sequence[tuple[str, str]], asked: Asked, width: int, height: int) -> Rows:
    """Name where a configuration was looked for, what is at an address, and what else can be done."""
    rows: Rows = [((" fleet-tui", Ink.TITLE_FOCUSED), ("  no configuration found. Looked for", Ink.TEXT))]
    rows += _pairs(places, Ink.TEXT)
    rows += [(), *_asked(asked, width), ()]
    rows += _pairs(COMMANDS, Ink.KEY)
    return _fitted(rows, width, height)


def _pairs(pairs: Sequence[tuple[str, str]], ink: Ink) -> Iterator[tuple[Run, ...]]:
    wide = column((visible(name) for name, _ in pairs), at_most=40)
    for name, text in pairs:
        yield (f"   {fit(visible(name), wide)}", ink), (f"  {text}", Ink.DIM)


def _asked(asked: Asked, width: int) -> Iterator[tuple[Run, ...]]:
    ink = Ink.GOOD if asked.is_found else Ink.WARN if asked.is_over else Ink.DIM
    yield ((f" {visible(asked.address)}", Ink.ACCENT),)
    for n, words in enumerate((asked.words, *asked.more)):
        for line in textwrap.wrap(visible(words), max(20, width - 4), break_on_hyphens=False):
            yield ((f"   {line}", ink if n == 0 else Ink.TEXT),)


def arrival_rows(
    summary: str, lines: Sequence[Line], lacks: Sequence[str], cursor: int, width: int, height: int
) -> Rows:
    """Show what was found, and each thing that could be otherwise with what holds now."""
    head: Rows = [((f" {visible(summary)}", Ink.TITLE_FOCUSED),)]
    said = [*(visible(lack) for lack in lacks)]
    if lines:
        said.append("This is not certain. Nothing is sent before the console opens.")
    for text in said:
        wrapped = textwrap.wrap(text, max(20, width - 2), break_on_hyphens=False)
        head += [((f" {line}", Ink.WARN if text in lacks else Ink.TEXT),) for line in wrapped]
    room = max(1, height - len(head) - 1)
    first = max(0, min(cursor - room + 1, len(lines) - room))
    shown = [_choice(line, n == cursor, width) for n, line in enumerate(lines) if first <= n < first + room]
    return _fitted([*head, (), *shown], width, height)


def _choice(line: Line, is_here: bool, width: int) -> tuple[Run, ...]:
    about = max(16, width * 2 // 5)
    count = f"{line.number or 'none'} of {line.of}".rjust(_COUNT)
    text = fit(visible(line.text), about)
    chosen = fit(visible(line.chosen), max(8, width - about - _COUNT - 8))
    return (
        (" > " if is_here else "   ", Ink.ACCENT),
        (text, Ink.TITLE_FOCUSED if is_here else Ink.TEXT),
        (f" < {chosen} >", Ink.ACCENT if is_here else Ink.TEXT),
        (count, Ink.DIM),
    )


def footer(keys: Sequence[tuple[str, str]]) -> list[Run]:
    """Write the keys of a screen."""
    return [run for key, text in keys for run in ((f" {key} ", Ink.KEY), (f"{text} ", Ink.DIM))]


def _fitted(rows: Rows, width: int, height: int) -> Rows:
    """Exactly as many rows as there is room for: blank ones go first."""
    while len(rows) > height and () in rows:
        rows.remove(())
    rows = [*rows, *[()] * (height - len(rows))]
    return [cut(row, width) for row in rows[:height]]

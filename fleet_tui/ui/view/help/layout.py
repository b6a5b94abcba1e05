"""Sections of help as lines of text, in columns."""

from collections.abc import Sequence
from itertools import combinations, pairwise, zip_longest
from textwrap import TextWrapper

from fleet_tui.ui.view.help.section import HelpRow, HelpSection
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run, cut, width_of

TWO_FROM = 94
THREE_FROM = 170
"""Cells from which there are two columns, those of an overlay on a terminal of 100, and three."""
_BETWEEN = 2
_LONGEST_MARK = 28

Line = Sequence[Run]


def help_lines(sections: Sequence[HelpSection], width: int) -> list[Line]:
    """Return the lines of `width` cells. Columns are about equally high, and no section is divided."""
    columns = min(len(sections), 1 + (width >= TWO_FROM) + (width >= THREE_FROM))
    if columns < 2:
        return [cut(line, width) for block in _blocks(sections, width) for line in block]
    cells = (width - _BETWEEN * (columns - 1)) // columns
    parts = _divided(sections, [len(block) + 1 for block in _blocks(sections, cells)], columns)
    between = (" " * _BETWEEN, StyleRole.TEXT)
    rows = zip_longest(*(_spaced(_blocks(part, cells)) for part in parts), fillvalue=())
    return [cut([run for line in row for run in (*cut(line, cells), between)], width) for row in rows]


def _divided(
    sections: Sequence[HelpSection], heights: Sequence[int], columns: int
) -> list[Sequence[HelpSection]]:
    """Return the sections of each column, in their order, so that the highest is as low as can be."""
    ways = ([0, *ends, len(sections)] for ends in combinations(range(1, len(sections)), columns - 1))
    best = min(ways, key=lambda ends: max(sum(heights[start:end]) for start, end in pairwise(ends)))
    return [sections[start:end] for start, end in pairwise(best)]


def _spaced(blocks: Sequence[Sequence[Line]]) -> list[Line]:
    """Return the lines with an empty one between two blocks."""
    return [line for block in blocks for line in (*block, ())][:-1]


def _blocks(sections: Sequence[HelpSection], width: int) -> list[list[Line]]:
    """Return the lines of each section: the title, then every row with its mark in a column, and the text
    wrapped beside it."""
    widths = [width_of(row.mark) for section in sections for row in section.rows]
    marks = min(max(widths, default=0), _LONGEST_MARK)
    return [
        [
            ((section.title, StyleRole.TITLE_FOCUSED),),
            *(line for row in section.rows for line in _row(row, marks, width)),
        ]
        for section in sections
    ]


def _row(row: HelpRow, marks: int, width: int) -> list[Line]:
    if not row.mark:
        return [((f"  {text}", StyleRole.TEXT),) for text in _wrapped(row.text, width - 2)]
    first, *others = _wrapped(row.text, width - marks - 4) or [""]
    below = " " * (marks + 4)
    mark = (("  ", StyleRole.TEXT), *cut(row.mark, marks), ("  ", StyleRole.TEXT))
    return [(*mark, (first, StyleRole.TEXT)), *(((below + text, StyleRole.TEXT),) for text in others)]


def _wrapped(text: str, width: int) -> list[str]:
    return TextWrapper(max(width, 10), break_on_hyphens=False).wrap(text)

"""Sections of help as lines of text, in one or two columns."""

from collections.abc import Sequence
from itertools import zip_longest
from textwrap import TextWrapper

from fleet_tui.view.help.section import HelpRow, HelpSection
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.table import Run, cut, width_of

TWO_FROM = 94
"""Cells from which there are two columns: those of an overlay on a terminal of 100."""
_BETWEEN = 2
_LONGEST_MARK = 28

Line = Sequence[Run]


def help_lines(sections: Sequence[HelpSection], width: int) -> list[Line]:
    """Return the lines of `width` cells. Two columns are about equally high, and no section is divided."""
    if width < TWO_FROM or len(sections) < 2:
        return [cut(line, width) for block in _blocks(sections, width) for line in block]
    cells = (width - _BETWEEN) // 2
    heights = [len(block) + 1 for block in _blocks(sections, cells)]
    split = min(range(1, len(sections)), key=lambda at: max(sum(heights[:at]), sum(heights[at:])))
    columns = [_spaced(_blocks(part, cells)) for part in (sections[:split], sections[split:])]
    between = (" " * (width - 2 * cells), StyleRole.TEXT)
    pairs = zip_longest(*columns, fillvalue=())
    return [(*cut(one, cells), between, *cut(other, cells)) for one, other in pairs]


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

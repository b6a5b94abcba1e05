"""Tables: a title and rows of runs, with buttons for the mouse."""

from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from typing import overload

from msgspec import Struct

from fleet_tui.text.sanitize import cell_width, fit_words, folded
from fleet_tui.ui.view.roles import StyleRole

Run = tuple[str, StyleRole]
INDENT = 2
LEAST = 10
"""Cells before the rest of a row in the line below, and of such a line, at least."""


class Button(Struct, frozen=True):
    """A button for the mouse in the cells from `start` to before `end` of a row."""

    start: int
    end: int
    name: str


class Row(Struct, frozen=True):
    """One row. `key` identifies it, so that the cursor stays with it when rows move. A long one may go on
    below from its run `start` on, before which so many blanks were left out. One that shows a part of a
    text has the `whole` of it for copies."""

    key: Hashable
    runs: tuple[Run, ...]
    buttons: tuple[Button, ...] = ()
    start: int = 0
    blanks: int = 0
    whole: str = ""


class LateRows(Sequence[Row]):
    """Rows that are made on access: of many a pane shows a few, ten times a second."""

    def __init__(self, keys: Sequence[Hashable], make: Callable[[int], Row]) -> None:
        self.keys = keys
        self._make = make

    def __len__(self) -> int:
        return len(self.keys)

    @overload
    def __getitem__(self, index: int) -> Row: ...
    @overload
    def __getitem__(self, index: slice) -> list[Row]: ...
    def __getitem__(self, index: int | slice) -> Row | list[Row]:
        places = range(len(self.keys))[index]
        return self._make(places) if isinstance(places, int) else [self._make(place) for place in places]


class Table(Struct, frozen=True):
    """A pane at one moment. `head` names the columns; `empty` is shown if there are no rows; `unfiltered` is
    the number of rows without a filter, whose lines it keeps; `has_groups`: some rows are heads of groups.
    `stays`: cells at the start of each row that do not slide away; `is_followed`: a cursor at its end stays
    there when rows come."""

    title: tuple[Run, ...]
    rows: Sequence[Row]
    empty: str = ""
    title_buttons: tuple[Button, ...] = ()
    head: tuple[Run, ...] = ()
    unfiltered: int = 0
    has_groups: bool = False
    stays: int = 0
    is_followed: bool = False

    @property
    def lines(self) -> int:
        """Return the lines that all of it takes, with its title."""
        return 1 + bool(self.head) + max(1, len(self.rows), self.unfiltered)

    @property
    def keys(self) -> Sequence[Hashable]:
        """Return the keys of the rows in order."""
        return self.rows.keys if isinstance(self.rows, LateRows) else [row.key for row in self.rows]


def width_of(runs: Iterable[Run]) -> int:
    return sum(cell_width(text) for text, _ in runs)


def cut(runs: Iterable[Run], cells: int) -> tuple[Run, ...]:
    """Return runs in exactly `cells` cells: cut after a word with an ellipsis, or padded."""
    result: list[Run] = []
    left = cells
    for text, role in runs:
        if left <= 0:
            break
        width = cell_width(text)
        if width > left:
            text, width = fit_words(text, left), left
        result.append((text, role))
        left -= width
    if left > 0:
        result.append((" " * left, StyleRole.TEXT))
    return tuple(result)


def without_blanks(runs: list[Run], cells: int) -> list[Run]:
    """Return runs without so many of the blank cells at their end, as far as there are, but for one: what
    follows would be cut beside them."""
    kept, text = list(runs), "".join(part for part, _ in runs)
    left = min(cells, len(text) - len(text.rstrip()) - 1)
    while left > 0:
        text, role = kept.pop()
        gone = min(left, len(text) - len(text.rstrip()))
        left -= gone
        if gone < len(text):
            kept.append((text[: len(text) - gone], role))
    return kept


def continued(row: Row, cells: int, aligned: bool = True) -> list[list[Run]]:
    """Return a row as lines of so many cells, those below `aligned` with its last column if that does not
    begin too late."""
    rest = row.runs[row.start :]
    text = "".join(part for part, _ in rest)
    at = len(text) - len(text.lstrip())
    head = [*row.runs[: row.start], (" " * (row.blanks + at), StyleRole.TEXT)]
    begin = width_of(head)
    if begin + cell_width(text[at:]) <= cells:
        return [list(row.runs)]
    is_late = not aligned or begin > cells // 2
    below = INDENT if is_late else begin + INDENT * (row.start == 0)
    lines = []
    for line in folded(text[at:], max(LEAST, cells - begin), max(LEAST, cells - below)):
        at = text.index(line, at)
        lines.append([*head, *_between(rest, at, at + len(line))])
        at += len(line)
        head = [(" " * below, StyleRole.TEXT)]
    return lines


def _between(runs: Sequence[Run], start: int, end: int) -> Iterator[Run]:
    """Yield the letters from `start` to before `end` of runs."""
    for text, role in runs:
        if part := text[max(0, start) : max(0, end)]:
            yield part, role
        start -= len(text)
        end -= len(text)


def column(texts: Iterable[str], at_least: int = 0, at_most: int = 24) -> int:
    """Return the width of a column for these texts: it doesn't jitter when values change."""
    return max(at_least, min(at_most, max(map(cell_width, texts), default=0)))

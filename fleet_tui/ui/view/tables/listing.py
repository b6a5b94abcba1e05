"""The visible part of a table: a cursor that stays with its row, scrolling in both directions."""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Hashable, Iterator, Sequence

from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import cell_width, without_cells
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Button, Run, Table, continued, cut, width_of, without_blanks

CURSOR = "▸"
MARK = "*"
BOTH = "◆"
NO_MARK = (" ", StyleRole.TEXT)
SLIDE = 8
"""Cells that long rows slide at once."""
HEAD_FROM = 5
"""Lines of a pane from which the columns have heads; fewer if all rows fit."""


class Listing:
    """`cursor` is the key of the row for keys and menus; rows of the key None have no cursor. `marks` are
    those of the rows for the next command."""

    def __init__(self) -> None:
        self.cursor: Hashable | None = None
        self.proposed: Hashable | None = None
        """The cursor's row if nobody chose it."""
        self.marks: dict[Hashable, Hashable] = {}
        """Keys of the marked rows, by what identifies them while rows move."""
        self._table = Table((), ())
        self.page = 1
        """The rows in view."""
        self._top = 0
        self._slid = 0
        self._place = 0
        self._first = 1
        """The line of the first row."""
        self._places: Sequence[int] = ()
        """The row of each line from there on."""

    def show(self, table: Table) -> None:
        """Show the newest rows. If the cursor's row is gone, it moves to the one now in its place, or to the
        next above that can have it, else the first."""
        keys = table.keys
        if table.is_followed and keys and self.cursor in (None, *self._table.keys[-1:]):
            self.cursor = keys[-1]
        self._table = table
        if self.marks:
            self.marks = {identity(key): key for key in keys if identity(key) in self.marks}
        if self.cursor is not None and self.cursor in keys:
            self._place = keys.index(self.cursor)
        else:
            places = [place for place, key in enumerate(keys) if key is not None]
            first = places[0] if places else 0
            self._place = max((place for place in places if place <= self._place), default=first)
            self.cursor = self.proposed = keys[self._place] if places else None

    def choose(self, key: Hashable) -> None:
        """Put the cursor on a row that somebody chose."""
        self.cursor = key
        self.proposed = None

    def move(self, step: int) -> bool:
        """Move the cursor by rows, at most to the last one that can have it; return False if there are
        none."""
        keys = self._table.keys
        places = [place for place, key in enumerate(keys) if key is not None]
        if places:
            wanted = max(places[0], min(self._place + step, places[-1]))
            ahead = bisect_left(places, wanted) if step > 0 else bisect_right(places, wanted) - 1
            self._place = places[ahead]
            self.cursor = keys[self._place]
            self.proposed = None
        return bool(keys)

    def toggle_mark(self) -> None:
        """Mark the cursor's row, or no longer."""
        if self.cursor is not None and self.marks.pop(identity(self.cursor), None) is None:
            self.marks[identity(self.cursor)] = self.cursor

    def go_to_best(self, typed: str) -> None:
        """Put the cursor on the row whose name or number is typed, else on the first one."""
        keys, wanted = self._table.keys, typed.casefold().split()[-1:]
        exact = (key for key in keys if wanted and wanted[0] in _names(key))
        self.cursor = next(exact, keys[0] if keys else None)
        self._place = keys.index(self.cursor) if self.cursor is not None else 0

    @property
    def text(self) -> str:
        """Return the marked rows as lines, else the cursor's, empty without one."""
        marked = [n for n, key in enumerate(self._table.keys) if identity(key) in self.marks]
        rows = [self._table.rows[n] for n in marked or [self._place] if n < len(self._table.rows)]
        # The rows of one opened text are that text once.
        texts = {
            row.whole or n: row.whole or "".join(text for text, _ in row.runs).strip()
            for n, row in enumerate(rows)
        }
        return "\n".join(texts.values())

    def slide(self, step: int) -> None:
        """Slide long rows to the left or right."""
        self._slid = max(0, self._slid + step * SLIDE)

    def lines(self, width: int, height: int, focused: bool) -> list[tuple[Run, ...]]:
        """Return the title and the rows in view, each `width` cells wide."""
        has_head = self._table.head and self._table.rows and height >= min(HEAD_FROM, self._table.lines)
        head = [self._head(width)] if has_head else []
        self._first = 1 + len(head)
        rows = max(0, height - self._first)
        self.page = max(1, rows)
        # The cursor's row stays visible, and no line is wasted at the end.
        self._top = max(0, min(self._top, self._place, len(self._table.rows) - rows))
        self._top = max(self._top, self._place - rows + 1, 0)
        lines = list(self._rows(max(0, width - 1), rows, focused))
        self._places = [place for place, _ in lines]
        shown = [line for _, line in lines]
        if not shown:
            shown = [cut([NO_MARK, (self._table.empty, StyleRole.DIM)], width)]
        blank = [((" " * width, StyleRole.TEXT),)] * (rows - len(shown))
        return [self._title(width, rows, focused), *head, *shown, *blank][:height]

    def _rows(self, cells: int, height: int, focused: bool) -> Iterator[tuple[int, tuple[Run, ...]]]:
        """Yield the lines of the rows in view, each with the place of its row. While lines are free, a long
        row goes on in the next ones."""
        free = height - len(self._table.rows)
        for place, row in enumerate(self._table.rows[self._top : self._top + height], self._top):
            lines = continued(row, cells) if free > 0 and not self._slid else []
            first, *rest = lines if 1 < len(lines) <= free + 1 else [row.runs]
            free -= len(rest)
            yield place, (self._sign(row.key, focused), *self._slide(first, cells))
            yield from ((place, (NO_MARK, *cut(line, cells))) for line in rest)

    def _sign(self, key: Hashable, focused: bool) -> Run:
        """Return the first cell of a row: with the cursor, marked, both or neither."""
        is_marked = identity(key) in self.marks
        if key is None or key != self.cursor:
            return (MARK, StyleRole.KEY) if is_marked else NO_MARK
        return BOTH if is_marked else CURSOR, StyleRole.ACCENT if focused else StyleRole.DIM

    def _head(self, width: int) -> tuple[Run, ...]:
        return (NO_MARK, *self._slide(self._table.head, max(0, width - 1)))

    def _title(self, width: int, rows: int, focused: bool) -> tuple[Run, ...]:
        title: list[Run] = [
            (text, StyleRole.TITLE_FOCUSED if role is StyleRole.TITLE and focused else role)
            for text, role in self._table.title
        ]
        if self.marks:
            title.insert(1, (tr(" {marks} marked", marks=len(self.marks)), StyleRole.KEY))
        if len(self._table.rows) > rows and self.cursor is not None:
            seen = tr(
                "{first}-{last} of {rows}",
                first=self._top + 1,
                last=self._top + rows,
                rows=len(self._table.rows),
            )
            if self._table.has_groups:  # else the heads would read as robots
                seen = tr("rows {seen}", seen=seen)
            title = _with_seen(title, seen, bool(self._table.title_buttons))
        rule = StyleRole.ACCENT if focused else StyleRole.RULE
        runs = [("─ ", rule), *title, (" ", rule)]
        return cut([*runs, ("─" * (width - width_of(runs)), rule)], width)

    def _slide(self, row: Sequence[Run], width: int) -> tuple[Run, ...]:
        """Return a row without its first cells but those that stay, at most to its end."""
        if not self._slid:
            return cut(row, width)
        left = max(0, min(self._slid, width_of(row) - width))
        stays = self._stays(width)
        runs: list[Run] = []
        for text, role in row:
            cells = cell_width(text)
            kept = min(stays, cells)
            gone = min(left, cells - kept)
            stays -= kept
            left -= gone
            runs.append((without_cells(text, kept, gone), role))
        return cut(runs, width)

    def _stays(self, width: int) -> int:
        """Return the cells that do not slide, none if they are most of the row."""
        return self._table.stays if self._table.stays <= width // 2 else 0

    def shows_row(self, y: int) -> bool:
        return 0 <= y - self._first < len(self._places)

    def steps_to(self, y: int) -> int:
        """Return the number of rows from the cursor to the row of line `y`."""
        return self._places[y - self._first] - self._place

    def button_at(self, x: int, y: int) -> str:
        """Return the name of the button in cell (x, y), empty for no button: in the title, or in the
        cursor's row."""
        if y == 0:
            return _pressed(self._table.title_buttons, x - 2)
        return _pressed(self._table.rows[self._place].buttons, x - 1)


def identity(key: Hashable) -> Hashable:
    """Return the part of a row's key that stays while rows move: without its place."""
    return key[:2] if isinstance(key, tuple) else key


def _names(key: Hashable) -> list[str]:
    """Return what an operator may call a row: the name of its robot, and the number at its end."""
    name = str(key[0] if isinstance(key, tuple) else key).casefold()
    return [name, *re.findall("[0-9]+$", name)]


def _with_seen(title: list[Run], seen: str, has_button: bool) -> list[Run]:
    """Return a title with the rows in view, before a button at its end as far as it leaves cells for them."""
    if not has_button:
        return [*title, (f"  {seen}", StyleRole.DIM)]
    *named, button = title
    before = without_blanks(named, width_of(named))
    free = width_of(named) - width_of(before)
    return [*before, (f" {seen}".ljust(free), StyleRole.DIM), button] if free > len(seen) else title


def _pressed(buttons: tuple[Button, ...], x: int) -> str:
    return next((button.name for button in buttons if button.start <= x < button.end), "")

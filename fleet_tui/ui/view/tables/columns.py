"""Columns: each is declared once, and its head, width, filter and order follow from that."""

from collections.abc import Callable, Hashable, Iterator, Sequence
from itertools import islice, takewhile
from typing import Any, Generic, TypeVar

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.order import natural
from fleet_tui.text.language import tr
from fleet_tui.text.sanitize import cell_width, fit, sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import (
    LateRows,
    Row,
    Run,
    column,
    continued,
    cut,
    width_of,
    without_blanks,
)

Item = TypeVar("Item")

UNBOUNDED = 10_000
"""Cells of a pane in which every text is whole."""
MEASURED = 1000
"""Rows whose cells decide the width of a column: of ten thousand only those in view are made."""
LEAST_REST = 10
"""Cells that the last column has before the others give way."""
PARTS = 0.7
"""Share of a text from which the whole parts at its end are shown for it."""
GAP: Run = " ", StyleRole.TEXT


class Column(Struct, Generic[Item], frozen=True):
    """A value of the items of a table. Its `name` is its head, finds it in a filter and tells the order.
    `cell` returns what is shown, None for a value that is only found. `cells` is its width, or the least and
    the most of one that depends on what it holds, None for the rest of the row. It is shown in panes of
    `from_cells` on. `text` returns what a filter finds, by default what is shown. `order` returns what sorts;
    one that `sorts` does so by its text. One that `is_apart` is found only by its name, as is a figure, which
    `is_right`. One that `stays` never slides away. `may_go`: it is left out where the others would have too
    few cells, and needs none. `ends_differ`: texts are cut at their front."""

    name: str
    cell: Callable[[Item], str | Run | list[Run]] | None = None
    cells: int | tuple[int, int] | None = None
    head: str | None = None
    from_cells: int = 0
    text: Callable[[Item], str] | None = None
    order: Callable[[Item], Any] | None = None
    sorts: bool = False
    is_apart: bool = False
    is_right: bool = False
    stays: bool = False
    may_go: bool = False
    ends_differ: bool = False

    @property
    def title(self) -> str:
        return tr(self.name) if self.head is None else self.head

    def runs(self, item: Item) -> Sequence[Run]:
        """Return what is shown of an item, uncut and safe."""
        if self.cell is None:
            return []
        made = self.cell(item)
        if isinstance(made, str):
            return [(sanitize(made), StyleRole.TEXT)]
        if isinstance(made, tuple):
            return [(sanitize(made[0]), made[1])]
        return [(sanitize(text), role) for text, role in made]

    def found(self, item: Item) -> str:
        """Return what a filter finds of an item."""
        return self.text(item) if self.text is not None else _text(self.runs(item))

    @property
    def key(self) -> Callable[[Item], Any] | None:
        """Return what returns the key that sorts an item, None if it does not sort."""
        return self.order or ((lambda item: natural(self.found(item))) if self.sorts else None)


class FittedColumns(Generic[Item]):
    """The columns that a pane of `width` cells has. Where the one that takes the rest would have too few
    cells, others give way, first the last of them."""

    def __init__(self, columns: Sequence[Column[Item]], items: Sequence[Item], width: int) -> None:
        self._columns = [one for one in columns if one.cell is not None and width >= one.from_cells]
        self._cells = [_cells(one, items) for one in self._columns]
        self._width = width
        for place, one in reversed(list(enumerate(self._columns))):
            if self._over > 0 and one.may_go and self._cells[place] is not None:
                del self._columns[place], self._cells[place]
        for place, one in reversed(list(enumerate(self._columns))):
            cells = self._cells[place]
            if self._over > 0 and cells is not None and isinstance(one.cells, tuple):
                self._cells[place] = max(one.cells[0], cells - self._over)

    @property
    def _over(self) -> int:
        """Return the cells that the row lacks."""
        pairs = zip(self._columns, self._cells, strict=True)
        has_rest = any(cells is None and not one.may_go for one, cells in pairs)
        return (LEAST_REST if has_rest else 0) - self.rest

    def shows(self, name: str) -> bool:
        """Tell whether it has a column of this name."""
        return any(one.name == name for one in self._columns)

    @property
    def rest(self) -> int:
        """Return the cells that the columns of a fixed width leave, negative if these have too few."""
        return self._width - sum(cells + 1 for cells in self._cells if cells is not None)

    @property
    def stays(self) -> int:
        """Return the cells at the start of a row that never slide away."""
        staying = takewhile(lambda pair: pair[0].stays, zip(self._columns, self._cells, strict=True))
        return sum((cells or 0) + 1 for _, cells in staying)

    @property
    def head(self) -> tuple[Run, ...]:
        """Return the names, each above its column, empty if no column has one."""
        if not any(one.title for one in self._columns):
            return ()
        last = len(self._columns) - 1
        names = (
            one.title
            if cells is None and n == last
            else self._head(one, self.rest - 1 if cells is None else cells)
            for n, (one, cells) in enumerate(zip(self._columns, self._cells, strict=True))
        )
        return (("".join(names), StyleRole.DIM),)

    def _head(self, one: Column[Item], cells: int) -> str:
        return fit(one.title, cells, right=one.is_right) + " "

    def runs(self, item: Item) -> tuple[Run, ...]:
        """Return the row of an item: what takes the rest at its end is not cut, for it can slide."""
        return self.row(item, None).runs

    def row(self, item: Item, key: Hashable) -> Row:
        """Return the same with its key, and where the rest begins."""
        made: list[Run] = []
        start, blanks = 0, 0
        last = self._columns[-1] if self._columns else None
        for one, fixed in zip(self._columns, self._cells, strict=True):
            runs = one.runs(item)
            if fixed is None and one is last:
                kept = without_blanks(made, width_of(runs) - self.rest)
                start, blanks = len(kept), width_of(made) - width_of(kept)
                made = [*kept, *runs]
                continue
            cells = self.rest - 1 if fixed is None else fixed
            if one.ends_differ:
                runs = [(cut_at_front(text, cells), role) for text, role in runs]
            left = cells - (cell_width(runs[0][0]) if len(runs) == 1 else width_of(runs))
            if left >= 0 and len(runs) == 1:  # one run is painted sooner than three
                text, role = runs[0]
                made.append((f"{' ' * left}{text} " if one.is_right else f"{text}{' ' * left} ", role))
                continue
            if one.is_right and left > 0:
                made.append((" " * left, StyleRole.TEXT))
                cells -= left
            made += (*cut(runs, cells), GAP)
        return Row(key, tuple(made), start=start, blanks=blanks)

    def rows(self, item: Item, key: Hashable) -> Iterator[Row]:
        """Yield the row of an item, and below it what its last column has no cells for: at its end is the
        cause."""
        row = replace(self.row(item, key), blanks=0)
        for n, line in enumerate(continued(row, self._width, aligned=False)):
            yield Row(None if n else key, tuple(line), whole=_text(row.runs).strip())


def _cells(one: Column[Item], items: Sequence[Item]) -> int | None:
    if not isinstance(one.cells, tuple):
        return one.cells
    least, most = one.cells
    texts = (_text(one.runs(item)) for item in islice(items, MEASURED))
    return column(texts, max(least, min(most, cell_width(one.title))), most)


def cut_at_front(text: str, cells: int) -> str:
    """Return a text of at most so many letters, cut at its front, before a part if that leaves most of it:
    `…/scan`, but `…e_to_pose/_action/status`, for other actions have such an end, too."""
    if len(text) <= cells:
        return text
    end = text[1 - cells :]
    whole = end[max(0, end.find("/")) :]
    return f"…{whole if len(whole) >= cells * PARTS else end}"


def _text(runs: Sequence[Run]) -> str:
    return "".join(text for text, _ in runs)


def rows_of(
    columns: FittedColumns[Item],
    entries: Sequence[Item | Row],
    key: Callable[[Item], Hashable],
    whole: Callable[[Item], bool] | None = None,
) -> LateRows:
    """Return a row for each item, made when it is shown; rows among them, as below an opened one, stay. Those
    that are `whole` go on in further lines, which have no key, where they would lose their end."""
    if whole is not None:
        entries = [
            row
            for one in entries
            for row in ([one] if isinstance(one, Row) or not whole(one) else columns.rows(one, key(one)))
        ]

    def row(place: int) -> Row:
        entry = entries[place]
        return entry if isinstance(entry, Row) else columns.row(entry, key(entry))

    return LateRows([one.key if isinstance(one, Row) else key(one) for one in entries], row)

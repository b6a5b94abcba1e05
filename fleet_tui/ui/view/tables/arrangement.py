"""The rows of a table as the operator wants them: filtered, sorted, and told so in the title."""

import math
from collections.abc import Callable, Hashable, Iterable, Sequence
from typing import Any

from fleet_tui.text.errors import did_you_mean
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.row_filter import filter_terms, is_wanted
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.columns import UNBOUNDED, Column, FittedColumns, Item, rows_of
from fleet_tui.ui.view.tables.groups import RowGroups
from fleet_tui.ui.view.tables.table import Row, Run, Table

NO_MATCH = Message("nothing matches the filter: Esc clears it")
"""In the place of rows."""


class RowArrangement:
    """The filter as `typed`, the value that sorts, empty for the table's own order, and the groups.
    `whole_numbers`: a filter does not find `robot_2` in `robot_22`."""

    def __init__(self, whole_numbers: bool = False) -> None:
        self.typed = ""
        self._whole_numbers = whole_numbers
        self.groups = RowGroups()
        self.is_typing = False
        """The operator is about to type a letter: what it will search in is made before, for that takes
        longer than a key may."""
        self.column = ""
        self.names: Sequence[str] = ()
        """The columns that `name:text` finds."""
        self._sorted_by: Sequence[str] = ()
        self._known: dict[str, tuple[float, dict[str, str]]] = {}
        """By row, its texts and when they were made (monotonic)."""

    def next_column(self) -> None:
        """Sort by the next value, after the last one in the table's own order again."""
        names = ["", *self._sorted_by]
        self.column = names[(names.index(self.column) + 1) % len(names)] if self.column in names else ""

    def arranged(
        self,
        items: Iterable[Item],
        columns: Sequence[Column[Item]],
        named: Callable[[Item], str] | None = None,
        at: float = 0.0,
        usual: Callable[[Item], Any] | None = None,
    ) -> list[Item]:
        """Return the wanted items in order; equal ones keep theirs, or that of `usual`. With the names of
        items and the time (monotonic), what a filter finds in them may be old by up to two seconds: texts of
        500 robots take longer than a key may."""
        self._sorted_by = [one.name for one in columns if one.key is not None]
        self.names = [one.name for one in columns if one.name]
        terms = filter_terms(self.typed, self.names)
        searched = self._searched(columns, named, at)
        if self.is_typing and not terms and named is not None:
            items = list(items)
            for item in items:
                searched(item)("")
        whole = self._whole_numbers
        found = [item for item in items if not terms or is_wanted(terms, searched(item), whole)]
        if usual is not None:  # not before: of a large fleet a filter leaves few
            found.sort(key=usual)
        order = next((one.key for one in columns if one.name == self.column), None)
        return sorted(found, key=order) if order is not None else found

    def _searched(
        self, columns: Sequence[Column[Item]], named: Callable[[Item], str] | None, at: float
    ) -> Callable[[Item], Callable[[str], str]]:
        """Return what returns the texts of an item for a filter, as `is_wanted` asks for them."""
        by_name = {one.name: one.text or one.found for one in columns}
        common = [by_name[one.name] for one in columns if one.name and not one.is_apart | one.is_right]

        def of(item: Item) -> Callable[[str], str]:
            known = self._texts_of(named(item), at) if named is not None else {}

            def text(name: str) -> str:
                if name not in known:
                    texts = [by_name[name]] if name else common
                    known[name] = "\n".join(make(item) for make in texts).casefold()
                return known[name]

            return text

        return of

    def _texts_of(self, name: str, at: float) -> dict[str, str]:
        """Return the texts of a row as far as they were made a short while ago. Not all get old at once."""
        made, known = self._known.get(name, (-math.inf, {}))
        if not 0.0 <= at - made < 1.0 + hash(name) % 8 / 8:
            known = {}
            self._known[name] = at, known
        return known

    @property
    def no_match(self) -> str:
        """Return what stands in the place of rows that a filter hides: a name that is no value's, if any."""
        typed = (word.removeprefix("!").partition(":") for word in self.typed.casefold().split())
        unknown = [name for name, colon, _ in typed if colon and name.isalpha() and name not in self.names]
        if not unknown:
            return translate(NO_MATCH)
        near = did_you_mean(unknown[0], self.names) or Message(": {names}", names=", ".join(self.names))
        return tr("no value {unknown}{near}", unknown=sanitize(unknown[0]), near=translate(near))

    def notes(self, shown: int) -> list[Run]:
        """Return what the title says of it; `shown` rows are left."""
        runs = [(f" /{sanitize(self.typed)}: {shown}", StyleRole.ACCENT)] if self.typed else []
        sorts = self.column in self._sorted_by  # of several pages in one arrangement each has its own
        return runs + [(tr(" by {column}", column=tr(self.column)), StyleRole.ACCENT)] * sorts


def table_of(
    title: Sequence[Run],
    columns: Sequence[Column[Item]],
    items: Sequence[Item],
    key: Callable[[Item], Hashable],
    width: int = UNBOUNDED,
    *,
    arrangement: RowArrangement | None = None,
    above: Iterable[Row] = (),
    below: Callable[[Item], Iterable[Row]] = lambda _: (),
    empty: str = "",
    is_followed: bool = False,
) -> Table:
    """Return items as rows of `width` cells with their keys, as arranged; `above` are rows before all,
    `below` those of an opened one. `empty` is shown if there are no items."""
    arrangement = arrangement or RowArrangement()
    wanted = arrangement.arranged(items, columns)
    shown = FittedColumns(columns, wanted, width)
    entries: list[Item | Row] = [*above]
    for item in wanted:
        entries.append(item)
        entries += below(item)
    said = arrangement.no_match if items else empty
    if entries and not wanted:  # with rows above, what is said in the place of the others is one, too
        entries.append(Row(None, ((said, StyleRole.DIM),)))
    return Table(
        (*title, *arrangement.notes(len(wanted))),
        rows_of(shown, entries, key),
        said,
        head=shown.head,
        unfiltered=len(items),
        stays=shown.stays,
        is_followed=is_followed,
    )

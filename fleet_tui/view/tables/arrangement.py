"""The rows of a table as the operator wants them: filtered, sorted, and told so in the title."""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Generic, TypeVar

from msgspec import Struct

from fleet_tui.errors import did_you_mean
from fleet_tui.text.language import Message, tr, translate
from fleet_tui.text.row_filter import filter_terms, is_wanted
from fleet_tui.text.sanitize import sanitize
from fleet_tui.view.roles import StyleRole
from fleet_tui.view.tables.groups import RowGroups
from fleet_tui.view.tables.table import Run

Item = TypeVar("Item")
NO_MATCH = Message("nothing matches the filter: Esc clears it")
"""In the place of rows."""


class Value(Struct, Generic[Item], frozen=True):
    """A value of the items of a table: its name in a filter and in the title, its text, what sorts by it,
    None for a value that does not; one `is_apart` is found only by its name."""

    name: str
    text: Callable[[Item], str]
    order: Callable[[Item], Any] | None = None
    is_apart: bool = False


class RowArrangement:
    """The filter as `typed`, the value that sorts, empty for the table's own order, and the groups."""

    def __init__(self) -> None:
        self.typed = ""
        self.groups = RowGroups()
        self.is_typing = False
        """The operator is about to type a letter: what it will search in is made before, for that takes
        longer than a key may."""
        self.column = ""
        self.names: Sequence[str] = ()
        """The values that `name:text` finds."""
        self._columns: Sequence[str] = ()
        self._known: dict[str, tuple[float, dict[str, str]]] = {}
        """By row, its texts and when they were made (monotonic)."""

    def next_column(self) -> None:
        """Sort by the next value, after the last one in the table's own order again."""
        names = ["", *self._columns]
        self.column = names[(names.index(self.column) + 1) % len(names)] if self.column in names else ""

    def arranged(
        self,
        items: Iterable[Item],
        values: Sequence[Value[Item]],
        named: Callable[[Item], str] | None = None,
        at: float = 0.0,
        usual: Callable[[Item], Any] | None = None,
    ) -> list[Item]:
        """Return the wanted items in order; equal ones keep theirs, or that of `usual`. With the names of
        items and the time (monotonic), what a filter finds in them may be old by up to two seconds: texts of
        500 robots take longer than a key may."""
        self._columns = [value.name for value in values if value.order is not None]
        self.names = [value.name for value in values]
        terms = filter_terms(self.typed, self.names)
        searched = self._searched(values, named, at)
        if self.is_typing and not terms and named is not None:
            items = list(items)
            for item in items:
                searched(item)("")
        found = [item for item in items if not terms or is_wanted(terms, searched(item))]
        if usual is not None:  # not before: of a large fleet a filter leaves few
            found.sort(key=usual)
        order = next((value.order for value in values if value.name == self.column), None)
        return sorted(found, key=order) if order is not None else found

    def _searched(
        self, values: Sequence[Value[Item]], named: Callable[[Item], str] | None, at: float
    ) -> Callable[[Item], Callable[[str], str]]:
        """Return what returns the texts of an item for a filter, as `is_wanted` asks for them."""
        by_name = {value.name: value.text for value in values}
        common = [value.text for value in values if not value.is_apart]

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
        runs = [(f" /{self.typed}: {shown}", StyleRole.ACCENT)] if self.typed else []
        return runs + [(tr(" by {column}", column=tr(self.column)), StyleRole.ACCENT)] * bool(self.column)

"""Sections of help, and the search in them."""

from collections.abc import Iterable, Mapping

from msgspec import Struct

from fleet_tui.keys.key import key_name
from fleet_tui.text.language import Message, tr, translate, verbatim
from fleet_tui.ui.view.roles import StyleRole
from fleet_tui.ui.view.tables.table import Run

_RANGES = {"1 2 3 4 5 6 7 8 9": Message("1..9"), "Left Right Up Down": Message("arrows")}


class HelpRow(Struct, frozen=True):
    """A line of help: a key, a glyph or an example, and its meaning. `also`: further texts that find it; one
    of a single character finds it alone."""

    mark: tuple[Run, ...]
    text: Message
    also: tuple[str, ...] = ()


class HelpSection(Struct, frozen=True):
    """Rows under a title."""

    title: Message
    rows: tuple[HelpRow, ...]


def key_row(
    ids: Iterable[str], text: Message, keys: Mapping[str, tuple[str, ...]], most: int, also: str = ""
) -> HelpRow:
    """Return the row of one or more keys, with at most `most` keys of each id. `also`: words that find it."""
    ids = tuple(ids)
    every = [key for id_ in ids for key in keys[id_]]
    names = " ".join(key_name(key) for id_ in ids for key in keys[id_][:most])
    for listed, short in _RANGES.items():
        names = names.replace(listed, translate(short))
    mark = (names, StyleRole.KEY) if names else (tr("palette"), StyleRole.DIM)
    return HelpRow((mark,), text, (*ids, *every, also))


def translated(section: HelpSection) -> HelpSection:
    """Return a section in the language of the user; the words that find a row in English find it still."""
    rows = (HelpRow(row.mark, verbatim(translate(row.text)), (*row.also, row.text)) for row in section.rows)
    return HelpSection(verbatim(translate(section.title)), tuple(rows))


def search(sections: Iterable[HelpSection], wanted: str) -> list[HelpSection]:
    """Return the rows with all wanted words, in their sections. A title counts as part of its rows; a single
    character means the key or the glyph itself."""
    found = []
    for section in sections:
        rows = tuple(row for row in section.rows if _matches(row, section.title, wanted))
        if rows:
            found.append(HelpSection(section.title, rows))
    return found


def _matches(row: HelpRow, title: str, wanted: str) -> bool:
    if len(wanted) == 1:
        return wanted in row.also
    text = " ".join((title, *(part for part, _ in row.mark), row.text, *row.also)).casefold()
    return all(word in text for word in wanted.casefold().split())

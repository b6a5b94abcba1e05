"""The text that filters rows: `word`, `!word`, `key:value`, all of which must hold."""

import re
from collections.abc import Callable, Collection

from msgspec import Struct


class Term(Struct, frozen=True):
    """One condition: `text` is in the value `name`, in any value if that is empty; `wanted` is False for the
    opposite."""

    name: str
    text: str
    wanted: bool = True


def filter_terms(typed: str, names: Collection[str]) -> tuple[Term, ...]:
    """Return the conditions of a typed filter. `names` are those of values; before another colon is no name.
    What is not typed to its end, `!` or `floor:`, is no condition yet."""
    terms = []
    for word in typed.casefold().split():
        text = word.removeprefix("!")
        name, colon, value = text.partition(":")
        if not colon or name not in names:
            name, value = "", text
        if value:
            terms.append(Term(name, value, wanted=text == word))
    return tuple(terms)


def is_wanted(terms: Collection[Term], text: Callable[[str], str], whole_numbers: bool = False) -> bool:
    """Tell whether all conditions hold for a row. `text` returns the folded text of a value by its name, for
    an empty name those of all values in which a word is searched, a line each. `whole_numbers`: `robot_2` is
    not in `robot_22`."""
    return all(_is_in(term.text, text(term.name), whole_numbers) is term.wanted for term in terms)


def _is_in(sought: str, text: str, whole_numbers: bool) -> bool:
    if whole_numbers and sought[-1].isdigit():
        return re.search(re.escape(sought) + r"(?!\d)", text) is not None
    return sought in text

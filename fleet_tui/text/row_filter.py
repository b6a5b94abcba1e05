"""What an operator types to filter rows: `word`, `!word`, `key:value`, all of which must hold."""

from collections.abc import Callable, Collection, Mapping

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


def is_wanted(
    terms: Collection[Term], values: Mapping[str, Callable[[], str]], apart: Collection[str] = ()
) -> bool:
    """Tell whether all conditions hold for a row. `values` are asked for only as far as needed, in order: the
    cheapest come first; those `apart` only where they are named."""
    common = [name for name in values if name not in apart]
    known: dict[str, str] = {}

    def has(name: str, text: str) -> bool:
        if name not in known:
            known[name] = values[name]().casefold()
        return text in known[name]

    return all(
        any(has(name, term.text) for name in ([term.name] if term.name else common)) is term.wanted
        for term in terms
    )

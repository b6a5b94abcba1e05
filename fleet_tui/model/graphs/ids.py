"""Ids of graph elements: new ones, and those that several elements of a file have."""

from collections.abc import Collection, Iterable
from itertools import chain, count


def next_id(*used: Iterable[str]) -> str:
    """Return 1 + the largest number among the ids: of the draft, of the live graph, of removed elements."""
    numbers = (int(id_) for ids in used for id_ in ids if is_number(id_))
    return str(max(numbers, default=-1) + 1)


def is_number(id_: str) -> bool:
    """Tell whether an id is a whole number, as short as it can be written."""
    digits = id_.removeprefix("-")
    plain = digits.isascii() and digits.isdecimal() and len(digits) <= 20
    return plain and (digits == "0" or digits[0] != "0") and id_ != "-0"


def unused(id_: str, used: Collection[str]) -> str:
    """Return the id, with a number where it is taken."""
    return next(one for one in chain((id_,), (f"{id_}-{n}" for n in count(2))) if one not in used)


def distinct(ids: Iterable[str], others: Iterable[str] = ()) -> list[tuple[str, tuple[str, ...]]]:
    """Return for each id a distinct one, and the id that it repeats where it had to change.

    Of several elements with one id the last keeps it, as in the readers of these formats. Numbers are given
    beyond all ids and `others`.
    """
    wanted = list(ids)
    last = {id_: n for n, id_ in enumerate(wanted)}
    used, free = set(last), int(next_id(last, others))
    found = list[tuple[str, tuple[str, ...]]]()
    for n, id_ in enumerate(wanted):
        if last[id_] == n:
            found.append((id_, ()))
            continue
        other = str(free) if is_number(id_) else unused(f"{id_}-2", used)
        free += is_number(id_)
        used.add(other)
        found.append((other, (id_,)))
    return found

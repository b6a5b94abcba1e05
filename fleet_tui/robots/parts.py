"""Reads the lists in a message element by element: their number is limited, and a bad one doesn't affect the
others."""

from collections.abc import Callable
from typing import Any

from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import MOST_ORDERS, too_many


def read_all(
    read: Callable[[Any], Any], parts: list[Any], what: Message, most: int, faults: list[str]
) -> list[Any]:
    """Return the valid ones of the first `most` elements; the errors of the others go to `faults`."""
    if len(parts) > most:
        faults.append(too_many(len(parts), most, what))
    good = []
    for n, part in enumerate(parts[:most]):
        try:
            good.append(read(part))
        except WireError as problem:
            faults.append(f"{what}[{n}]: {problem}")
    return good


def first_orders(orders: list[Any], current: int, id_name: str) -> list[Any]:
    """Return the first orders up to the limit, and the current one wherever it is: a robot that drives is not
    idle."""
    others = (
        part for part in orders[MOST_ORDERS:] if isinstance(part, dict) and part.get(id_name) == current
    )
    return [*orders[:MOST_ORDERS], *list(others)[:1]]

"""Lists of a message part by part: bounded, and a bad part costs no other."""

from typing import Any

from fleet_tui.robots.parts import first_orders, read_all
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import MOST_ORDERS


def positive(part: Any) -> int:
    if part <= 0:
        raise WireError(f"{part} is not positive")
    return int(part)


def test_good_parts_are_kept_and_bad_ones_named_by_their_place() -> None:
    faults = list[str]()
    assert read_all(positive, [1, -2, 3, 0], Message("orders"), 10, faults) == [1, 3]
    assert faults == ["orders[1]: -2 is not positive", "orders[3]: 0 is not positive"]


def test_no_more_are_read_than_are_taken() -> None:
    faults = list[str]()
    assert read_all(positive, [1, 2, 3, -4], Message("orders"), 2, faults) == [1, 2]
    assert faults == ["4 orders: only the first 2 used"]


def test_the_current_order_is_taken_wherever_it_stands() -> None:
    orders = [{"id": n} for n in range(MOST_ORDERS + 50)]
    taken = first_orders(orders, MOST_ORDERS + 20, "id")
    assert len(taken) == MOST_ORDERS + 1 and taken[-1] == {"id": MOST_ORDERS + 20}
    assert first_orders(orders, 3, "id") == orders[:MOST_ORDERS]

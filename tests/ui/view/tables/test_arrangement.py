"""Rows as the operator wants them."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.order import natural
from fleet_tui.ui.view.tables.arrangement import RowArrangement
from fleet_tui.ui.view.tables.columns import Column
from tests.support.fleets import text_of

Item = tuple[str, int]
VALUES: tuple[Column[Item], ...] = (
    Column("robot", text=lambda item: item[0], order=lambda item: natural(item[0])),
    Column("floor", text=lambda item: f"floor_{item[1]}", order=lambda item: item[1]),
    Column("state", text=lambda item: "busy" if item[1] else "idle"),
)
ITEMS: list[Item] = [("robot_10", 1), ("robot_9", 0), ("robot_2", 1)]


def test_it_keeps_the_tables_own_order_until_another_one_is_chosen() -> None:
    chosen = RowArrangement()
    assert chosen.arranged(ITEMS, VALUES) == ITEMS and chosen.notes(3) == []
    chosen.next_column()
    assert chosen.arranged(ITEMS, VALUES) == [("robot_2", 1), ("robot_9", 0), ("robot_10", 1)]
    assert text_of(chosen.notes(3)) == " by robot"
    chosen.next_column()
    assert chosen.arranged(ITEMS, VALUES) == [("robot_9", 0), ("robot_10", 1), ("robot_2", 1)], "stable"
    chosen.next_column()
    assert chosen.arranged(ITEMS, VALUES) == ITEMS, "a value without an order is left out"


def test_the_filter_is_told_with_the_number_of_rows_it_leaves() -> None:
    chosen = RowArrangement()
    chosen.typed = "idle"
    found = chosen.arranged(ITEMS, VALUES)
    assert found == [("robot_9", 0)] and text_of(chosen.notes(len(found))) == " /idle: 1"


@given(st.lists(st.tuples(st.text(), st.integers())), st.text())
def test_nothing_is_added_and_nothing_is_told_twice(items: list[Item], typed: str) -> None:
    chosen = RowArrangement()
    chosen.arranged((), VALUES)
    chosen.next_column()
    chosen.typed = typed
    found = chosen.arranged(items, VALUES)
    assert all(found.count(one) <= items.count(one) for one in found)
    chosen.typed = ""
    assert sorted(chosen.arranged(items, VALUES)) == sorted(items)


def test_texts_of_named_rows_are_made_again_after_a_while_and_at_once_when_time_goes_back() -> None:
    chosen, made = RowArrangement(), list[str]()

    def text(item: Item) -> str:
        made.append(item[0])
        return item[0]

    chosen.typed = "robot_2"
    for at, count in ((10.0, 3), (10.5, 3), (13.0, 6), (5.0, 9)):
        found = chosen.arranged(ITEMS, (Column("robot", text=text),), lambda item: item[0], at)
        assert found == [("robot_2", 1)] and len(made) == count


def test_what_a_filter_searches_in_is_made_before_its_first_letter() -> None:
    chosen, made = RowArrangement(), list[str]()

    def text(item: Item) -> str:
        made.append(item[0])
        return item[0]

    def found() -> list[Item]:
        return chosen.arranged(ITEMS, [Column("robot", text=text)], lambda item: item[0], 1.0)

    found()
    assert not made
    chosen.is_typing = True
    assert found() == ITEMS and len(made) == 3
    chosen.typed = "9"
    assert found() == [("robot_9", 0)] and len(made) == 3


def test_a_filter_by_a_value_that_is_none_says_so() -> None:
    chosen = RowArrangement()
    chosen.arranged(ITEMS, VALUES)
    for typed, told in (
        ("flor:1", "no value flor, did you mean floor?"),
        ("!qqq\x1b:1 idle", "nothing matches the filter: Esc clears it"),
        ("qqq:1", "no value qqq: robot, floor, state"),
        ("12:04 nobody", "nothing matches the filter: Esc clears it"),
    ):
        chosen.typed = typed
        assert chosen.no_match == told

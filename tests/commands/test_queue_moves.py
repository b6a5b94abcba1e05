"""Orders that wait in this console change places; nothing that was begun does."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from fleet_tui.commands.queue_moves import moves
from fleet_tui.model.commands import Stage
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.navigation_events import OrderMoved
from fleet_tui.orders.local_queue import next_to_send, orders_to_save, waiting
from tests.support.fleets import R0, T0, commanded, fleet, link_up, of_kinds, place_order, pose, reduced, tick
from tests.support.kinds import KEEPING

UP, FRONT, DOWN = "Move up", "Move to the front", "Move down"


def queued(count: int, *facts: Event) -> FleetState:
    """One order is driven, so many wait here: k1, k2, ..."""
    begun: list[Event] = [link_up(T0), pose(T0), tick(T0), *commanded(1, place_order(R0, 9), Stage.SENT)]
    for n in range(count):
        begun += commanded(n + 2, place_order(R0, n), Stage.WAITING, at=T0 + 0.1 * (n + 1))
    return reduced(of_kinds(fleet(), KEEPING), *begun, *facts)


def ids(state: FleetState) -> list[str]:
    return [one.order_id or "" for one in waiting(state, state.robots[R0])]


def named(state: FleetState, order_id: str) -> dict[str, str]:
    return dict(moves(state, state.robots[R0], order_id))


def move(order_id: str, before: str) -> OrderMoved:
    return OrderMoved(R0, order_id, before, T0 + 5)


@pytest.mark.parametrize(
    ("order_id", "name", "after"),
    [
        ("k3", UP, ["k1", "k3", "k2", "k4"]),
        ("k3", FRONT, ["k3", "k1", "k2", "k4"]),
        ("k3", DOWN, ["k1", "k2", "k4", "k3"]),
        ("k1", DOWN, ["k2", "k1", "k3", "k4"]),
    ],
)
def test_an_order_moves_to_its_new_place(order_id: str, name: str, after: list[str]) -> None:
    state = queued(4)
    state = reduced(state, move(order_id, named(state, order_id)[name]))
    assert ids(state) == after
    assert [one.order_id for one, _ in orders_to_save(state, state.robots[R0])] == after


def test_only_possible_moves_are_offered() -> None:
    state = queued(3)
    offered = [list(named(state, one)) for one in ("k1", "k2", "k3", "k9")]
    assert offered == [[DOWN], [UP, DOWN], [UP, FRONT], []]
    assert named(queued(1), "k1") == {}


def test_the_record_says_where_it_went() -> None:
    state = reduced(queued(3), move("k3", "k1"), move("k3", ""))
    moved = next(one for one in state.commands if one.order_id == "k3")
    assert [step.detail for step in moved.steps[-2:]] == ["moved before order k1", "moved to the end"]
    assert moved.stage is Stage.WAITING


@pytest.mark.parametrize(("order_id", "before"), [("k2", "k2"), ("k2", "k9"), ("k9", "k1"), ("", "k1")])
def test_a_move_that_has_become_impossible_changes_nothing(order_id: str, before: str) -> None:
    state = queued(3)
    assert reduced(state, move(order_id, before)).commands == state.commands


def test_an_order_that_a_pause_stopped_stays_the_first() -> None:
    state = queued(2)
    driven = replace(
        state.commands[0], order_id="k7", steps=(*state.commands[0].steps, state.commands[1].steps[-1])
    )
    state = replace(state, commands=(driven, *state.commands[1:]))
    assert ids(state) == ["k7", "k1", "k2"]
    assert named(state, "k7") == {} and named(state, "k1") == {DOWN: ""}
    assert ids(reduced(state, move("k2", "k7"))) == ["k7", "k1", "k2"]


def test_the_first_one_after_a_move_leaves_next() -> None:
    state = queued(3)
    state = replace(state, commands=state.commands[1:])
    state = reduced(state, move("k3", "k1"))
    record = next_to_send(state, state.robots[R0])
    assert record is not None and record.order_id == "k3"


PLACES = st.sampled_from(["k1", "k2", "k3", "k4", "k5", "k6", ""])


@given(st.integers(0, 5), st.lists(st.tuples(PLACES, PLACES), max_size=8))
def test_no_move_loses_or_doubles_an_order(count: int, wanted: list[tuple[str, str]]) -> None:
    state = queued(count)
    moved = reduced(state, *(move(*one) for one in wanted))
    assert sorted(ids(moved)) == sorted(ids(state))

"""Goals of action servers as one queue: numbered as they are seen, legs and ended ones left out."""

import math

from msgspec.structs import replace

from fleet_tui.model.navigation import Goal
from fleet_tui.model.order import OrderState, at_vertices
from fleet_tui.orders.goals import (
    LISTED_FOR,
    Goals,
    active,
    is_given_as,
    own_ids,
    queue_of,
    with_reported,
    with_stops,
    without,
)

ON, DONE, FAILED, REPLACED = (OrderState.IN_PROCESS, OrderState.DONE, OrderState.FAILED, OrderState.REPLACED)


def goal(id_: str, state: OrderState = ON, action: str = "go", leads: bool = False) -> Goal:
    return Goal(id_, f"uuid of {id_}", action, state, leads=leads)


def lists(*reports: tuple[float, tuple[Goal, ...]], action: str = "go", known: Goals | None = None) -> Goals:
    """The goals after an action server has listed them at these seconds."""
    found: Goals = known or {}
    for at, goals in reports:
        last = max((one.serial for listed in found.values() for one in listed), default=0)
        found = with_reported(found, action, goals, at, last)
    return found


def ids(goals: Goals, at: float) -> list[str]:
    return [order.id for order in queue_of(goals, at, None).orders]


def test_goals_of_two_actions_are_one_queue_in_the_order_they_were_seen() -> None:
    found = lists((1.0, (goal("a"),)))
    found = lists((2.0, (goal("b", action="tour"),)), action="tour", known=found)
    found = lists((3.0, (goal("a"), goal("c"))), known=found)
    queue = queue_of(found, 3.0, None)
    assert [(order.id, order.serial) for order in queue.orders] == [("a", 1), ("b", 2), ("c", 3)]
    assert (queue.current_id, queue.last_serial) == ("c", 3)


def test_the_first_list_may_hold_goals_of_long_ago() -> None:
    first = lists((1.0, (goal("a", DONE), goal("b"))))
    assert [one.listed_since for one in first["go"]] == [-math.inf] * 2
    assert ids(first, 1.0) == ["b"]
    ended = lists((5.0, (goal("b", DONE),)), known=first)
    assert ids(ended, 5.0 + LISTED_FOR - 0.1) == ["b"] and ids(ended, 5.0 + LISTED_FOR) == []


def test_a_failure_just_when_a_newer_goal_comes_is_a_replacement_and_stays_one() -> None:
    found = lists((1.0, (goal("a"),)), (2.0, (goal("a", FAILED), goal("b"))))
    assert [one.state for one in found["go"]] == [REPLACED, ON]
    found = lists((3.0, (goal("a", FAILED), goal("b", DONE))), known=found)
    assert [one.state for one in found["go"]] == [REPLACED, DONE]
    alone = lists((1.0, (goal("a"),)), (2.0, (goal("a", FAILED),)), (3.0, (goal("a", FAILED), goal("b"))))
    assert [one.state for one in alone["go"]] == [FAILED, ON]


def test_goals_missing_in_a_list_that_was_cut_stay() -> None:
    found = lists((1.0, (goal("a"), goal("b"))))
    cut = with_reported(found, "go", (goal("b", DONE),), 2.0, 2, is_whole=False)
    assert [(one.id, one.state) for one in cut["go"]] == [("a", ON), ("b", DONE)]
    assert [one.id for one in with_reported(found, "go", (goal("b"),), 2.0, 2)["go"]] == ["b"]


def test_a_goal_accepted_after_an_active_tour_is_a_leg_of_it() -> None:
    tour = replace(goal("t", action="tour", leads=True), stamp=10.0)
    found = lists((1.0, (replace(goal("before"), stamp=9.0), replace(goal("leg"), stamp=11.0))))
    found = lists((1.0, (tour,)), action="tour", known=found)
    assert [one.id for listed in found.values() for one in listed if one.is_leg] == ["leg"]
    assert set(ids(found, 1.0)) == {"before", "t"}
    assert {one.id for one in active(found)} == {"before", "leg", "t"}


def test_a_tour_that_succeeded_in_spite_of_a_failed_leg_has_failed() -> None:
    for leg_ends, end in ((FAILED, FAILED), (DONE, DONE)):
        tour = replace(goal("t", action="tour", leads=True), stamp=10.0)
        found = lists((1.0, (tour,)), action="tour")
        first, second = (replace(goal(one), stamp=11.0) for one in ("one", "two"))
        found = lists((2.0, (first,)), (3.0, (replace(first, state=leg_ends), second)), known=found)
        found = lists((4.0, (replace(second, state=DONE),)), known=found)
        found = lists((5.0, (replace(tour, state=DONE),)), action="tour", known=found)
        (order,) = queue_of(found, 5.0, None).orders
        assert (order.id, order.state, order.said) == ("t", end, "a stop was missed" if end is FAILED else "")


def test_stamps_are_told_by_our_clock_and_left_out_while_that_is_unknown() -> None:
    found = lists((1.0, (replace(goal("a"), stamp=10.0),)))
    assert queue_of(found, 1.0, 500.0).orders[0].taken_at == 510.0
    assert queue_of(found, 1.0, None).orders[0].taken_at is None


def test_a_goal_of_ours_is_known_by_its_id_and_by_how_it_is_given() -> None:
    found = lists((1.0, (goal("a"), goal("t", leads=True))))
    stops = at_vertices("1", "2")
    found = with_stops(found, "t", stops, is_ours=True)
    assert own_ids(found) == {"t"} and found["go"][1].stops == stops
    assert is_given_as(found, "t", stops) and not is_given_as(found, "t", stops[:1])
    assert is_given_as(found, "a", stops[:1]) and not is_given_as(found, "a", stops)
    assert [one.id for one in without(found, {"uuid of t"})["go"]] == ["a"]


def test_an_id_that_two_actions_report_is_listed_once() -> None:
    found = lists((1.0, (goal("a"),)), action="dock")
    found = lists((2.0, (goal("a"), goal("b"))), known=found)
    assert sorted(ids(found, 2.0)) == ["a", "b"]

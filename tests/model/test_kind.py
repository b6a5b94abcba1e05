"""Kinds: what a robot accepts and reports, and what is said of what it does not."""

import math

import pytest

from fleet_tui.model.kind import CANCEL, CLEAR, ORDER, ORDER_TO, PAUSE, RESUME, Kind


def test_who_takes_orders_to_one_place_takes_orders() -> None:
    kind = Kind(accepts=(ORDER_TO,))
    assert kind.can(ORDER) and kind.can(ORDER_TO)
    assert not Kind(accepts=(ORDER,)).can(ORDER_TO)


@pytest.mark.parametrize(
    ("kind", "asked", "words"),
    [
        (Kind(), PAUSE, "this kind has no pause"),
        (Kind(), ORDER_TO, "this kind has no orders"),
        (Kind(accepts=(ORDER,)), ORDER_TO, "this kind has no order without a start"),
        (Kind(accepts=(ORDER_TO,)), ORDER, "this kind has no order with a start"),
        (
            Kind(unset={RESUME: "profile.services.resume"}),
            RESUME,
            "profile.services.resume is empty: no resume",
        ),
    ],
)
def test_what_it_lacks_is_said_in_words(kind: Kind, asked: str, words: str) -> None:
    assert kind.lack(asked) == words


def test_only_values_that_come_again_and_again_are_expected() -> None:
    kind = Kind(reports=("pose", "queue"), silence={"queue": math.inf})
    assert kind.expects("pose") and not kind.expects("queue") and not kind.expects("battery")
    assert kind.lists_orders and not Kind(reports=("pose",)).lists_orders
    assert (kind.silence_of("pose", 5.0), kind.silence_of("queue", 5.0)) == (5.0, math.inf)


def test_nothing_is_accepted_unless_it_is_said() -> None:
    assert not any(Kind().can(verb) for verb in (ORDER, ORDER_TO, CANCEL, CLEAR, PAUSE, RESUME))

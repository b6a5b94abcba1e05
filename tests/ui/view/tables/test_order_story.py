"""The origin of an order in a queue, as far as this console knows it."""

from fleet_tui.model.commands import PauseRobot, Stage
from fleet_tui.ui.view.tables.order_story import origin
from tests.support.fleets import R0, T0, commanded, fleet, place_order, queue, reduced, tick
from tests.support.fleets import order as listed

STATE = reduced(fleet(2), queue(T0, (4, 1, 2, "W"), (5, 2, 1, "Q")))


def at(wall: float) -> str:
    return "12:04:31"


def test_an_order_is_ours_anothers_or_perhaps_ours() -> None:
    given = place_order(R0, 1, 2)
    placed = commanded(7, given, Stage.SENT, Stage.ACCEPTED, at=T0 + 1)
    state = reduced(STATE, *placed, queue(T0 + 2, (4, 1, 2, "W"), (6, 1, 2, "Q")), tick(T0 + 2.1))
    assert origin(state, R0, listed(6, 1, 2, "Q"), at) == "sent here at 12:04:31, accepted, confirmed"
    assert origin(state, R0, listed(4, 1, 2, "W"), at) == "not sent by this console"
    unsure = reduced(fleet(), *commanded(7, given, Stage.SENT, Stage.UNKNOWN))
    assert origin(unsure, R0, listed(6, 1, 2, "Q"), at) == "possibly sent here at 12:04:31, outcome unknown"
    assert origin(unsure, R0, listed(6, 2, 1, "Q"), at) == "not sent by this console"
    refused = reduced(fleet(), *commanded(7, given, Stage.SENT, Stage.REFUSED))
    assert origin(refused, R0, listed(6, 1, 2, "Q"), at) == "not sent by this console"
    loaded = reduced(fleet(), *commanded(7, place_order(R0, 2), Stage.SENT))
    assert origin(loaded, R0, listed(6, 9, 2, "Q"), at) == "possibly sent here at 12:04:31, sent"


def test_who_gave_an_order_is_known_as_long_as_it_is_in_the_queue() -> None:
    placed = commanded(7, place_order(R0, 1, 2), Stage.SENT, Stage.ACCEPTED, at=T0 + 1)
    state = reduced(STATE, *placed, queue(T0 + 2, (6, 1, 2, "Q")), tick(T0 + 2.1))
    for n in range(300):
        state = reduced(state, *commanded(100 + n, PauseRobot(R0), Stage.NOT_SENT, at=T0 + 3 + n))
    assert len(state.commands) == 200
    assert origin(state, R0, listed(6, 1, 2, "Q"), at).startswith("sent here")

"""The desk in the fleet state."""

from fleet_tui.model.desk.desk import Colleague, ends_of
from fleet_tui.model.desk.events import (
    AlarmAcknowledged,
    ColleaguesSeen,
    DeskJoined,
    EdgeClosed,
    EdgeOpened,
    RobotClaimed,
    RobotReleased,
)
from fleet_tui.state import desk_events
from tests.support.fleets import R0, T0, fleet, reduced, tick

EDGE = ends_of("floor_0", "1", "2")


def test_claims_are_in_the_order_in_which_they_were_made() -> None:
    state = reduced(fleet(), DeskJoined("ana"), *map(RobotClaimed, ("b", "a", "b")))
    assert state.desk.claims == ("a", "b")
    assert reduced(state, RobotReleased("a"), RobotReleased("none")).desk.claims == ("b",)


def test_the_others_are_replaced_as_a_whole() -> None:
    others = (Colleague("x", "ben", "here"),)
    state = reduced(fleet(), ColleaguesSeen(others))
    assert state.desk.others == others
    assert reduced(state, ColleaguesSeen()).desk.others == ()


def test_an_edge_is_closed_once_in_the_name_of_whoever_did_it() -> None:
    state = reduced(fleet(), DeskJoined("ana"), EdgeClosed(EDGE, 1.0), EdgeClosed(EDGE, 2.0, "ben"))
    assert [(edge.by, edge.wall) for edge in state.desk.closed] == [("ben", 2.0)]
    assert reduced(state, EdgeClosed(EDGE, 3.0)).desk.closed[0].by == "ana"
    assert reduced(state, EdgeOpened(EDGE, "ben")).desk.closed == ()


def test_what_time_changes_nobody_did() -> None:
    state = reduced(fleet(), AlarmAcknowledged(R0, "offline", "ben"))
    assert state.desk.acted == "ben"
    assert reduced(state, tick(T0 + 1)).desk.acted == ""
    assert reduced(state, AlarmAcknowledged()).desk.acted == ""


def test_closed_edges_are_limited() -> None:
    closed = (EdgeClosed(ends_of("f", str(n), "x"), 0.0) for n in range(desk_events.MOST_CLOSED + 5))
    assert len(reduced(fleet(), *closed).desk.closed) == desk_events.MOST_CLOSED

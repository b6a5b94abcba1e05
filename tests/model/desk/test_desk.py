"""Claims of several consoles, and the identity of edges."""

from fleet_tui.model.desk.desk import ClosedEdge, Colleague, Desk, ends_of


def test_an_edge_is_the_same_in_both_directions() -> None:
    assert ends_of("floor_0", "7", "12") == ends_of("floor_0", "12", "7")
    assert ends_of("floor_0", "7", "12") != ends_of("floor_1", "7", "12")


def test_own_claims_come_first_and_an_operator_with_two_consoles_is_named_once() -> None:
    others = tuple(Colleague(str(n), "ben", "here", claims=("robot_3",)) for n in range(2))
    desk = Desk("ana", ("robot_3",), others)
    assert desk.holders("robot_3") == ["ana", "ben"]
    assert desk.other_holders("robot_3") == ["ben"]
    assert desk.holders("robot_1") == []


def test_closed_edges_are_those_of_a_floor() -> None:
    edge = ClosedEdge(ends_of("floor_1", "a", "b"), "ana", 0.0)
    desk = Desk(closed=(edge,))
    assert desk.closed_on("floor_1") == [edge] and desk.closed_on("floor_0") == []

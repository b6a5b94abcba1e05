"""Lookup of the vertex that an operator's text means."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.commands.language.lookup import Place, matches, places, plain_id, starts_here
from fleet_tui.model.events import CargoReported
from fleet_tui.model.kind import ORDER, ORDER_TO, Kind
from fleet_tui.model.robot import Robot
from tests.support.fleets import F0, R0, T0, fleet, graph, labels, pose, queue, reduced
from tests.support.kinds import FULL, GOALS, moved

NAMED = {1: "Base", 2: "Consumidores", 3: "Dock 7", 7: "Lab base"}


def known() -> Robot:
    facts = (
        graph(1, 2, 3, 7, 8),
        labels(NAMED),
        graph(20, floor="floor_1"),
        labels({20: "Attic"}, "floor_1"),
    )
    return reduced(fleet(1, 2), *facts, pose(T0)).robots[R0]


def names(robot: Robot, typed: str) -> list[str]:
    return [place.name for place in matches(robot, typed)]


@pytest.mark.parametrize(
    ("typed", "found"),
    [
        ("base", ["Base", "Lab base"]),
        ("  BASE ", ["Base", "Lab base"]),
        ("con", ["Consumidores"]),
        ("7", ["Lab base", "Dock 7"]),
        ("8", ["8"]),
        ("20", ["Attic"]),
        ("99", []),
        ("²", []),
        ("٣", []),
        ("9" * 5000, []),
        ("nowhere", []),
    ],
)
def test_whole_label_then_id_then_start_then_part(typed: str, found: list[str]) -> None:
    assert names(known(), typed) == found


def test_nothing_typed_is_every_label_this_floor_first_by_name() -> None:
    assert names(known(), "") == ["Base", "Consumidores", "Dock 7", "Lab base", "Attic"]


def test_the_floor_a_robot_is_on_comes_first() -> None:
    facts = (graph(1), labels({1: "Zebra"}), graph(2, floor="floor_1"), labels({2: "Alpha"}, "floor_1"))
    state = reduced(fleet(1, 2), *facts, pose(T0))
    assert [place.name for place in places(state.robots[R0])] == ["Zebra", "Alpha"]
    upstairs = reduced(state, pose(T0, frame="floor_1"))
    assert [place.name for place in places(upstairs.robots[R0])] == ["Alpha", "Zebra"]


def test_a_label_of_a_vertex_that_the_graph_has_not_is_no_place() -> None:
    assert places(reduced(fleet(), labels({5: "Ghost"}), graph(1)).robots[R0]) == []
    assert places(reduced(fleet(), labels({5: "Soon"})).robots[R0]) == [Place("5", "Soon", F0)]


@given(st.text(max_size=8))
def test_whatever_is_typed_finds_only_places_of_the_robots_graphs(typed: str) -> None:
    found = matches(known(), typed)
    assert len(found) == len(set(found))
    assert {place.vertex for place in found} <= {"1", "2", "3", "7", "8", "20"}
    wanted = typed.strip().casefold()
    assert all(wanted in place.name.casefold() or plain_id(wanted) == place.vertex for place in found)


def test_an_order_needs_no_start_with_cargo_and_nothing_to_do() -> None:
    state = fleet()
    assert not starts_here(state.robots[R0])
    loaded = reduced(state, CargoReported(R0, T0, True))
    assert starts_here(loaded.robots[R0])
    assert not starts_here(reduced(loaded, queue(T0, (1, 1, 2, "Q"))).robots[R0])
    assert not starts_here(reduced(loaded, CargoReported(R0, T0, False)).robots[R0])


def test_a_label_that_is_a_number_comes_before_the_id() -> None:
    state = reduced(fleet(), graph(1, 7), labels({1: "7", 7: "Base"}))
    assert names(state.robots[R0], "7") == ["7", "Base"]


@pytest.mark.parametrize(
    ("kind", "may_start_here"),
    [(FULL, False), (GOALS, True), (Kind(accepts=(ORDER_TO,)), True), (Kind(accepts=(ORDER,)), False)],
)
def test_which_orders_may_start_where_the_robot_is(kind: Kind, may_start_here: bool) -> None:
    assert starts_here(moved(kind).robots[R0]) == may_start_here

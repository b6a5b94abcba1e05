"""Places of an order for anyone: a label means the place of that label on each robot's own graph."""

import re

import pytest

from fleet_tui.commands.language.any_robot import any_matches, is_anyone, own_place, parse_anyone
from fleet_tui.commands.language.lookup import Place
from fleet_tui.model.fleet import FleetState
from fleet_tui.text.errors import CommandError
from tests.support.fleets import F0, R0, T0, fleet, graph, labels, link_up, of_kinds, reduced
from tests.support.kinds import FULL, MUTE

R1 = "robot_1"
BASE, STORE = Place("1", "Base", F0), Place("2", "Store", F0)


def two_graphs(named: dict[int, str]) -> FleetState:
    """robot_1 has a graph of its own, and these labels."""
    own = (graph(5, 6, 7, robot=R1), labels(named, robot=R1))
    return reduced(fleet(2), link_up(T0), graph(1, 2, 3), labels({1: "Base", 2: "Store"}), *own)


def own(state: FleetState, place: Place, robot: str = R1) -> Place | None:
    return own_place(state, state.robots[robot], place)


def test_a_label_is_looked_up_on_the_robots_own_graph() -> None:
    state = two_graphs({7: "Base"})
    assert own(state, BASE) == Place("7", "Base", F0)
    assert own(state, BASE, R0) == BASE
    assert own(state, STORE) is None


def test_a_label_of_two_vertices_is_no_place_of_another_robot() -> None:
    assert own(two_graphs({6: "Base", 7: "Base"}), BASE) is None


def test_a_label_of_a_vertex_that_the_graph_lacks_is_no_place() -> None:
    assert own(two_graphs({99: "Base"}), BASE) is None


def test_an_id_without_a_label_means_the_same_place_on_the_same_graph_alone() -> None:
    third = Place("3", "3", F0)
    assert own(two_graphs({}), third) is None
    same = reduced(fleet(2), graph(1, 2, 3), graph(1, 2, 3, robot=R1))
    assert own(same, third) == third
    assert own(reduced(fleet(2), graph(1, 2, 3)), third) is None


def test_a_place_of_another_floor_is_another_place() -> None:
    assert own(two_graphs({7: "Base"}), Place("1", "Base", "attic")) is None


def test_places_of_all_robots_that_take_orders_are_found_once_and_a_whole_label_first() -> None:
    state = two_graphs({5: "Base", 6: "Base 2", 7: "Dock"})
    assert [place.name for place in any_matches(state, "")] == ["Base", "Store", "Base 2", "Dock"]
    assert [place.name for place in any_matches(state, "base 2")] == ["Base 2"]
    assert [place.name for place in any_matches(state, "ba")] == ["Base", "Base 2"]
    mute = of_kinds(state, FULL, MUTE)
    assert [place.name for place in any_matches(mute, "")] == ["Base", "Store"]


@pytest.mark.parametrize(
    ("word", "is_any"), [("", True), ("  ", True), ("Anyone", True), (R0, False), ("x", False)]
)
def test_no_robot_or_anyone_means_any(word: str, is_any: bool) -> None:
    assert is_anyone(word, fleet(2)) is is_any


def test_typed_places_are_labels_of_any_robot_or_ids() -> None:
    state = two_graphs({7: "Dock"})
    assert parse_anyone("anyone Dock Base", state) == [Place("7", "Dock", F0), BASE]
    assert parse_anyone("anyone 2 > Base", state) == [STORE, BASE]
    assert parse_anyone("pause all", state) is None


@pytest.mark.parametrize(
    ("line", "problem"),
    [
        ("anyone", "usage: anyone FROM TO"),
        ("anyone Base >", "usage: anyone FROM TO"),
        ("anyone Base Stor", "no robot has a place 'Stor', did you mean Store?"),
    ],
)
def test_a_line_that_is_wrong_is_explained(line: str, problem: str) -> None:
    with pytest.raises(CommandError, match=re.escape(problem)):
        parse_anyone(line, two_graphs({}))


def test_a_label_of_two_floors_needs_a_robot() -> None:
    other = (graph(8, 9, floor="floor_1"), labels({8: "Base"}, floor="floor_1"))
    with pytest.raises(CommandError, match="'Base' is ambiguous: it is on floor_0 and floor_1"):
        parse_anyone("anyone Base Store", reduced(two_graphs({}), *other))

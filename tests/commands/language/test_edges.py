"""Edges by the names of their ends."""

import pytest

from fleet_tui.commands.language.edges import edge_named, edge_text
from fleet_tui.model.desk.desk import ends_of
from fleet_tui.text.errors import CommandError
from tests.support.fleets import F0, R0, fleet, graph, labels, reduced

ROBOT = reduced(fleet(), graph(1, 2, 3, 4), labels({1: "Base", 2: "Hall", 3: "Shop", 4: "Shop"})).robots[R0]


def test_an_edge_is_named_by_labels_or_ids_in_any_direction() -> None:
    for start, end in (("Base", "Hall"), ("hall", "BASE"), ("2", "1"), ("id=1", "Hall")):
        assert edge_named(ROBOT, F0, start, end) == ends_of(F0, "1", "2")
    assert edge_text(ROBOT, ends_of(F0, "2", "1")) == "Base - Hall"
    assert edge_text(ROBOT, ("attic", "8", "9"), " ") == "8 9"


@pytest.mark.parametrize(
    ("start", "end", "said"),
    [
        ("Base", "id=3", "no edge Base - id=3 on floor_0: Base connects to Hall"),
        ("Bsae", "Hall", "no place 'Bsae' on floor_0 (did you mean Base?)"),
        ("Shop", "Hall", "'Shop' is ambiguous: use id=3 or id=4"),
        ("9", "Hall", "no place '9' on floor_0"),
    ],
)
def test_what_is_no_edge_is_told_with_the_nearest(start: str, end: str, said: str) -> None:
    with pytest.raises(CommandError) as problem:
        edge_named(ROBOT, F0, start, end)
    assert str(problem.value).startswith(said.split(" (did")[0])


def test_without_a_graph_there_are_no_edges() -> None:
    with pytest.raises(CommandError, match="robot_0 has no graph of floor_0"):
        edge_named(fleet().robots[R0], F0, "1", "2")

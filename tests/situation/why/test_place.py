"""The place of a robot, in words."""

import pytest

from fleet_tui.model.fleet import FleetState
from fleet_tui.situation.why.place import place_text
from tests.support.fleets import R0, T0, fleet, graph, labels, link_up, pose, reduced


def at(x: float, floors: int = 1) -> FleetState:
    """A robot on a floor with labels at vertices 1 and 3."""
    named = (graph(1, 2, 3), labels({1: "Base", 3: "Store"}))
    return reduced(fleet(1, floors), link_up(T0), *named, pose(T0, x=x))


def place_of(state: FleetState) -> str:
    return place_text(state.robots[R0])


def test_the_nearest_label_counts_also_between_unlabelled_vertices() -> None:
    vertices = at(0.0).robots[R0].maps["floor_0"].graph
    assert vertices is not None
    base, store = vertices.vertices["1"], vertices.vertices["3"]
    assert place_of(at(base.x)) == "at Base" and place_of(at(store.x)) == "at Store"
    assert place_of(at(store.x + 7.2)) == "7 m from Store"
    assert place_of(at(base.x, floors=2)) == "at Base, floor_0"


@pytest.mark.parametrize("known", [(), (graph(1),), (pose(T0),)])
def test_without_a_label_or_a_pose_nothing_is_said(known: tuple[object, ...]) -> None:
    assert place_of(reduced(fleet(), link_up(T0), *known)) == ""  # type: ignore[arg-type]  # events of several kinds

"""One configured floor from a file of any format."""

import pytest

from fleet_tui.maps.route_graphs import read_site_graph
from fleet_tui.model.graph import Role
from fleet_tui.text.errors import GraphError

RMF = """
levels:
  L1:
    vertices: [[0, 0, {name: Base, is_charger: true}], [1, 0, {name: yes}], [.nan, 0, {}]]
    lanes: [[0, 1, {}], [1, 0, {}], [1, 2, {}]]
  L2:
    vertices: [[5, 5, {}]]
    lanes: []
"""


def test_the_floor_of_that_name_and_what_is_left_out() -> None:
    graph, labels, faults = read_site_graph("L1", RMF)
    assert labels == {"0": "Base", "1": "yes"}
    assert graph.vertices["0"].role is Role.DOCKING and not graph.directed
    assert faults == ["vertex 2 has no position: left out", "edge 2 names unknown vertex 2: left out"]


def test_the_only_floor_whatever_it_is_called() -> None:
    graph, _, faults = read_site_graph("floor_0", "levels: {L7: {vertices: [[1, 2, {}]], lanes: []}}")
    assert (list(graph.vertices), faults) == (["0"], [])


def test_of_several_floors_none_is_guessed() -> None:
    with pytest.raises(GraphError, match="has the floors L1, L2: none is called floor_0"):
        read_site_graph("floor_0", RMF)


def test_a_building_with_several_graphs_is_to_be_converted() -> None:
    lanes = "[[0, 1, {graph_idx: [2, 0]}], [1, 0, {graph_idx: [2, 3]}]]"
    level = f"{{vertices: [[0, 0, 0, a], [1, 1, 0, b]], lanes: {lanes}}}"
    with pytest.raises(GraphError, match=r"graphs 0, 3.*graph convert IN OUT --building-graph"):
        read_site_graph("L1", f"coordinate_system: reference_image\nlevels: {{L1: {level}}}")


def test_a_graph_without_vertices_is_none() -> None:
    with pytest.raises(GraphError, match="has no vertices"):
        read_site_graph("L1", "levels: {L1: {}}")

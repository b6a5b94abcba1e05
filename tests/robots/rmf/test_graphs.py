"""Navigation graphs: one message for all levels of a fleet, its vertices by their names."""

from typing import Any

from fleet_tui.model.events import GraphReceived, LabelsReceived
from fleet_tui.model.graph import Edge, Role, RouteGraph
from tests.support.rmf import CARRIER, TINY, adapter, read


def node(name: str, level: str = "L1", x: float = 0.0, **params: Any) -> dict[str, Any]:
    words = [{"name": "map_name", "type": 1, "value_string": level}]
    for key, value in params.items():
        is_text = isinstance(value, str)
        words.append({"name": key, "value_string": value if is_text else "", "value_bool": value is True})
    return {"x": x, "y": 0.0, "name": name, "params": words}


def lane(start: int, end: int, type_: int = 0) -> dict[str, Any]:
    return {"v1_idx": start, "v2_idx": end, "params": [], "edge_type": type_}


def graphs(*edges: dict[str, Any], fleet: str = "carrier") -> dict[str, RouteGraph]:
    nodes = [
        node("A", is_charger=True),
        node("", x=1.0),
        node("L", x=2.0, lift="lift_1"),
        node("L2", "L2", lift="lift_1"),
        node("A", "L2", x=3.0),
    ]
    found = read(adapter(), "graphs", {"name": fleet, "vertices": nodes, "edges": list(edges)})
    return {one.floor: one.graph for one in found if isinstance(one, GraphReceived) and not one.fault}


def test_vertices_go_by_their_names_on_their_levels_and_lifts_join_none() -> None:
    found = graphs(lane(0, 1), lane(1, 2), lane(2, 3))
    assert {floor: list(graph.vertices) for floor, graph in found.items()} == {
        "L1": ["A", "#1", "L"],
        "L2": ["L2", "#4"],
    }
    assert found["L1"].edges == (Edge("0", "A", "#1"), Edge("1", "#1", "L"))
    roles = {id_: (one.role, one.type) for id_, one in found["L1"].vertices.items()}
    assert roles["A"] == (Role.DOCKING, "charger") and roles["L"] == (Role.ELEVATOR, "lift")


def test_each_robot_of_the_fleet_has_it_and_no_other() -> None:
    message = {"name": "tiny", "vertices": [node("A")], "edges": []}
    found = read(adapter(), "graphs", message)
    assert {one.robot for one in found if isinstance(one, GraphReceived | LabelsReceived)} == {
        TINY,
        "tiny/t2",
    }
    assert LabelsReceived(TINY, "L1", {"A": "A"}) in found
    assert not read(adapter(), "graphs", {**message, "name": "nobody's"})
    assert CARRIER


def test_two_lanes_in_opposite_directions_are_one_edge() -> None:
    assert not graphs(lane(0, 1, 1), lane(1, 0, 1))["L1"].directed
    assert len(graphs(lane(0, 1, 1), lane(1, 0, 1))["L1"].edges) == 1


def test_a_lane_without_a_way_back_gives_directions_to_all() -> None:
    found = graphs(lane(0, 1, 1), lane(1, 2))["L1"]
    assert found.directed
    assert [(one.start, one.end) for one in found.edges] == [("A", "#1"), ("#1", "L"), ("L", "#1")]


def test_a_bad_part_costs_only_itself() -> None:
    message = {"name": "carrier", "vertices": [node("A"), 7, node("B", x=1e99)], "edges": [lane(0, 1)]}
    (graph, _labels) = read(adapter(), "graphs", message)
    assert isinstance(graph, GraphReceived)
    assert list(graph.graph.vertices) == ["A"] and graph.faults == 2
    assert "vertices[1]" in graph.fault

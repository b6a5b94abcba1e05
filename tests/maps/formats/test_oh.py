"""The source's messages as YAML."""

import pytest
from hypothesis import given
from msgspec.structs import replace

from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex, GraphFormat, of_floor
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import again, read_text, sample, vertices, write_text

TEXT = """
graph:
  vertices:
    - {id: 0, x: 0.1, y: 2, type: "docking", z: 3}
    - {id: -5, x: 1, y: 2, type: elevator}
  edges: [{id: 4, start: 0, end: -5}]
  header: {frame_id: map}
labeled_vertices:
  vertices: [{label: 007, vertex_id: 0}, {label: no, vertex_id: -5}]
stamp: 12
"""


def test_the_messages_of_a_floor() -> None:
    floor = read_text(TEXT, floor="f").document.floors["f"]
    assert floor.vertices["0"] == DocumentVertex("0", 0.1, 2.0, "007", "docking", extra={"oh": {"z": 3}})
    assert floor.vertices["-5"].label == "no"
    assert floor.edges == {"4": DocumentEdge("4", "0", "-5")}
    assert again(of_floor(floor), GraphFormat.OH).floors["f"] == floor


def test_the_fields_of_the_graph_alone() -> None:
    text = (
        "vertices: [{id: 1, x: 0, y: 0, type: ''}]\nedges: []\nlabels: {vertices: [{label: A, vertex_id: 1}]}"
    )
    found = read_text(text, floor="f")
    assert found.format is GraphFormat.OH
    assert found.document.floors["f"].labels == {"1": "A"}


@given(vertices("oh"))
def test_nothing_that_it_has_is_lost(found: dict[str, DocumentVertex]) -> None:
    edges = {"9": DocumentEdge("9", "0", "0"), "12": DocumentEdge("12", "0", sorted(found)[-1])}
    document = of_floor(DocumentFloor("f", found, edges))
    assert again(document, GraphFormat.OH) == document


def test_one_way_counts_for_the_whole_graph() -> None:
    floor = sample().floors["ground"]
    text = write_text(of_floor(floor), GraphFormat.OH)
    assert text.startswith("directed: true\n")
    ways = again(of_floor(floor), GraphFormat.OH).floors["ground"].edges
    assert {id_: edge.two_way for id_, edge in ways.items()} == {
        "10": True,
        "12": False,
        "13": True,
        "14": True,
    }


def test_ids_become_numbers() -> None:
    named = DocumentFloor(
        "f",
        {"a": DocumentVertex("a", 0.0, 0.0, "A"), "3": DocumentVertex("3", 1.0, 0.0)},
        {"e": DocumentEdge("e", "a", "3")},
    )
    floor = again(of_floor(named), GraphFormat.OH).floors["f"]
    assert (list(floor.vertices), floor.labels) == (["4", "3"], {"4": "A"})
    assert floor.edges == {"0": DocumentEdge("0", "4", "3")}
    assert again(of_floor(replace(named, vertices={}, edges={})), GraphFormat.OH).floors["f"].vertices == {}


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("graph: {vertices: [{id: 1, x: 0}]}", "vertex 1: no y"),
        ("graph: {vertices: [{id: 1, x: 0, y: [1]}]}", "vertex 1 y: a list instead of a number"),
        ("graph: {vertices: [7]}", "vertices\\[0\\]: 7 instead of a mapping"),
        ("graph: {vertices: [], edges: [{id: 1, start: 0}]}", "edge 1: no end"),
        ("graph: {vertices: []}\nlabels: {vertices: [{label: a}]}", "labels\\[0\\]: no vertex_id"),
        ("graph: {vertices: []}\ndirected: 1", "file directed: 1 instead of true or false"),
    ],
)
def test_faults_are_named(text: str, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        read_text(text)

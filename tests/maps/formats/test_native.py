"""The program's own format, read."""

import pytest
from hypothesis import given

from fleet_tui.model.graphs.document import GraphDocument, GraphFormat, Motion
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import again, documents, read_text, sample

HEAD = "fleet_tui_graph: 1\nfloors:\n  f:\n"


@given(documents())
def test_nothing_is_lost(document: GraphDocument) -> None:
    assert again(document, GraphFormat.NATIVE) == document


def test_the_sample_of_everything() -> None:
    assert again(sample(), GraphFormat.NATIVE) == sample()


def test_written_by_hand() -> None:
    text = HEAD + (
        "    later: {a: 1}\n"
        "    vertices:\n      - {id: 007, x: 1, y: 2e0, label: yes, colour: red}\n"
        "      - {id: b, x: .nan, y: 0}\n"
        "    edges:\n      - {id: 1, start: 007, end: b, two_way: false, motion: backward}\n"
    )
    floor = read_text(text).document.floors["f"]
    assert (floor.vertices["007"].label, floor.vertices["007"].extra) == (
        "yes",
        {"native": {"colour": "red"}},
    )
    assert (floor.edges["1"].motion, floor.edges["1"].two_way) == (Motion.BACKWARD, False)
    assert floor.extra == {"native": {"later": {"a": 1}}}
    assert floor.vertices["b"].x != floor.vertices["b"].x


def test_of_elements_with_one_id_all_are_kept() -> None:
    text = (
        HEAD
        + "    vertices: [{id: 3, x: 1, y: 1}, {id: 3, x: 2, y: 2}, {id: a, x: 0, y: 0}, {id: a, x: 0, y: 0}]"
    )
    floor = read_text(text).document.floors["f"]
    assert {id_: (one.x, one.repeats) for id_, one in floor.vertices.items()} == {
        "4": (1.0, ("3",)),
        "3": (2.0, ()),
        "a-2": (0.0, ("a",)),
        "a": (0.0, ()),
    }


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("fleet_tui_graph: 2", "version 2 of the format: this program reads 1; update it"),
        ("fleet_tui_graph: x", "file fleet_tui_graph: 'x' instead of a number"),
        (HEAD + "    vertices: [{x: 1, y: 1}]", "floor f vertices\\[0\\]: no id"),
        (HEAD + "    vertices: [{id: 3, x: a, y: 1}]", "floor f vertex 3 x: 'a' instead of a number"),
        (HEAD + "    vertices: [{id: 3, x: 1}]", "floor f vertex 3: no y"),
        (HEAD + "    vertices: {a: 1}", "floor f vertices: a mapping instead of a list"),
        (HEAD + "    edges: [{id: 3, start: 1}]", "floor f edge 3: no end"),
        (
            HEAD + "    edges: [{id: 3, start: 1, end: 2, two_way: 1}]",
            "edge 3 two_way: 1 instead of true or false",
        ),
        (
            HEAD + "    edges: [{id: 3, start: 1, end: 2, motion: up}]",
            "'up' is none of any, forward, backward",
        ),
        (HEAD + "    to_site: [1, 2]", "floor f to_site: must be \\[x, y, yaw\\]"),
        (HEAD + "    map: {resolution: 1}", "floor f map: no file"),
        ("fleet_tui_graph: 1\nlifts: [{name: A, stops: [[f]]}]", "a stop must be \\[floor, vertex\\]"),
        ("fleet_tui_graph: 1\nlifts: [{name: A, size: [1]}]", "lift A size: must be two numbers"),
        ("fleet_tui_graph: 1\nfloors: [1]", "floors: a list instead of a mapping"),
    ],
)
def test_faults_are_named(text: str, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        read_text(text)

"""The program's own format, written."""

from fleet_tui.model.graphs.document import GraphDocument, GraphFormat
from tests.support.graph_files import sample, write_text


def test_a_vertex_or_an_edge_in_a_line_without_defaults() -> None:
    lines = write_text(sample(), GraphFormat.NATIVE).splitlines()
    assert '      - {id: "1", x: 4.0, y: 0.25, label: "007"}' in lines
    assert '      - {id: "10", start: "0", end: "1", reverse_id: "11", speed: 0.5, cost: 2.0}' in lines
    assert '      - {id: "12", start: "1", end: "2", two_way: false, motion: "backward"}' in lines
    assert '    map: {file: "ground.yaml"}' in lines
    assert lines[:2] == ["fleet_tui_graph: 1", 'name: "site"']


def test_an_empty_document() -> None:
    assert write_text(GraphDocument(), GraphFormat.NATIVE) == 'fleet_tui_graph: 1\nname: ""\nfloors: {}\n'

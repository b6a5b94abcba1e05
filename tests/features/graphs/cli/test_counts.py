"""Counts as text."""

from fleet_tui.features.graphs.cli.answers import graph_counts
from fleet_tui.model.graphs.document import GraphDocument
from tests.support.graph_files import line_graph


def test_one_and_several() -> None:
    assert graph_counts(line_graph((0.0, 0.0), (1.0, 0.0))) == "1 floor, 2 vertices, 1 edge, 0 labels"
    assert graph_counts(GraphDocument()) == "0 floors, 0 vertices, 0 edges, 0 labels"

"""Counts as text."""

from fleet_tui.model.graphs.document import GraphDocument
from fleet_tui.text.units import counted


def graph_counts(document: GraphDocument) -> str:
    """Return the numbers of floors, vertices, edges and labels."""
    floors = document.floors.values()
    return ", ".join(
        (
            counted(len(floors), "floor"),
            counted(sum(len(floor.vertices) for floor in floors), "vertex", "vertices"),
            counted(sum(len(floor.edges) for floor in floors), "edge"),
            counted(sum(len(floor.labels) for floor in floors), "label"),
        )
    )

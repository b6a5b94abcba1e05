"""Counts as text."""

from fleet_tui.model.graphs.document import GraphDocument


def counted(count: int, what: str, several: str = "") -> str:
    """Return a count with its noun: `1 error`, `2 vertices`."""
    return f"{count} {what if count == 1 else several or f'{what}s'}"


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

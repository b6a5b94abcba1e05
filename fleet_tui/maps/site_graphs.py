"""The graph of one configured floor, from a file of any format with one floor or several."""

from msgspec.structs import replace

from fleet_tui.errors import GraphError
from fleet_tui.graph_files.graph_file import MissingChoiceError, ReadChoices
from fleet_tui.graph_files.reading import read_graph
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.graphs.document import DocumentFloor, GraphDocument
from fleet_tui.model.graphs.live import route_graph
from fleet_tui.text.limits import LONGEST_NAME, truncate

FARTHEST = 1e9
"""Metres; a vertex farther off is on no floor."""


def read_site_graph(floor: str, text: str) -> tuple[RouteGraph, dict[str, str], list[str]]:
    """Return the graph of a floor, its labels, and the faults of elements that are left out.

    Raises GraphError.
    """
    try:
        document = read_graph(text, None, ReadChoices(floor)).document
    except MissingChoiceError as missing:
        remedy = f"make a file of it: fleet-tui graph convert IN OUT {missing.option} ..."
        raise GraphError(f"{missing}; {remedy}") from None
    found, faults = _usable(_floor(document, floor))
    if not found.vertices:
        raise GraphError("has no vertices")
    graph, labels = route_graph(found)
    shown = {id_: truncate(label.strip(), LONGEST_NAME) for id_, label in labels.items() if label.strip()}
    return graph, shown, faults


def _floor(document: GraphDocument, name: str) -> DocumentFloor:
    """Return the floor of that name, else the only one. Raises GraphError."""
    if name in document.floors:
        return document.floors[name]
    if len(document.floors) == 1:
        return next(iter(document.floors.values()))
    names = ", ".join(list(document.floors)[:5]) or "none"
    raise GraphError(f"has the floors {names}: none is called {name}")


def _usable(floor: DocumentFloor) -> tuple[DocumentFloor, list[str]]:
    """Return the floor without vertices at no place and edges without both ends, and the faults."""
    vertices = {id_: v for id_, v in floor.vertices.items() if abs(v.x) <= FARTHEST and abs(v.y) <= FARTHEST}
    faults = [f"vertex {id_} is at no place: left out" for id_ in floor.vertices if id_ not in vertices]
    edges = {}
    for id_, edge in floor.edges.items():
        lost = [end for end in (edge.start, edge.end) if end not in vertices]
        if lost:
            faults.append(f"edge {id_} names unknown vertex {lost[0]}: left out")
        else:
            edges[id_] = edge
    return replace(floor, vertices=vertices, edges=edges), faults

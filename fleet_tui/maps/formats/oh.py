"""The source's graph files: its messages Graph and LabeledVertices as YAML, a floor of a robot in a file."""

from collections.abc import Iterator
from typing import Any

from fleet_tui.maps.formats import fields
from fleet_tui.maps.formats.fields import Table
from fleet_tui.maps.formats.graph_file import GraphFile, ReadChoices, WriteChoices
from fleet_tui.maps.formats.renumbering import Numbered, numbered
from fleet_tui.maps.formats.yaml_text import flow, key_text
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    merge_opposites,
    of_floor,
    one_way_edges,
)
from fleet_tui.model.graphs.ids import distinct
from fleet_tui.text.limits import MOST_LABELS

OWN = GraphFormat.OH.value
LABELS = ("labeled_vertices", "labels")
"""The keys of the labels' message: as the topic is called, or shorter."""


def read(tree: Any, choices: ReadChoices) -> GraphFile:
    """Return the document of a file: the messages under their names, or the graph's own fields at the top.
    Raises GraphError."""
    table = dict(fields.mapping(tree, "file"))
    graph = dict(fields.mapping(table.pop("graph"), "graph")) if "graph" in table else table
    vertices = fields.vertex_elements(graph.pop("vertices", None), "vertices")
    edges = fields.edge_elements(graph.pop("edges", None), "edges")
    directed = bool(fields.optional(table, "directed", fields.flag, "file"))
    messages = {key: fields.optional_mapping(table.pop(key), key) for key in LABELS if key in table}
    found = {one.id: one for one in _vertices(vertices, _labels(messages))}
    ways = _edges(edges, directed)
    extra = fields.rest(OWN, table if graph is table else {**table, **_wrapped("graph", graph)})
    floor = DocumentFloor(choices.floor, found, merge_opposites(ways), extra=extra)
    return GraphFile(GraphFormat.OH, of_floor(floor))


def _wrapped(key: str, table: Table) -> Table:
    return {key: table} if table else {}


def _labels(messages: Table) -> dict[str, str]:
    """Return the labels by vertex id."""
    found = dict[str, str]()
    for message in messages.values():
        for n, part in enumerate(fields.elements(message.get("vertices"), "labels", MOST_LABELS)):
            table = dict(fields.mapping(part, f"labels[{n}]"))
            id_ = fields.required(table, "vertex_id", fields.identifier, f"labels[{n}]")
            found[id_] = fields.required(table, "label", fields.text, f"labels[{n}]")
    return found


def _ids(tables: list[Table], kind: str) -> list[tuple[str, tuple[str, ...]]]:
    ids = [fields.required(one, "id", fields.identifier, f"{kind}[{n}]") for n, one in enumerate(tables)]
    return distinct(ids)


def _vertices(parts: list[Any], labels: dict[str, str]) -> Iterator[DocumentVertex]:
    tables = [dict(fields.mapping(part, f"vertices[{n}]")) for n, part in enumerate(parts)]
    for (id_, repeats), table in zip(_ids(tables, "vertices"), tables, strict=True):
        where = f"vertex {(*repeats, id_)[0]}"
        x, y = (fields.required(table, axis, fields.number, where) for axis in ("x", "y"))
        type_ = fields.optional(table, "type", fields.text, where) or ""
        label = labels.get(id_, "")
        extra = fields.rest(OWN, table)
        yield DocumentVertex(id_, x, y, label, type_, extra=extra, repeats=repeats)


def _edges(parts: list[Any], directed: bool) -> Iterator[DocumentEdge]:
    tables = [dict(fields.mapping(part, f"edges[{n}]")) for n, part in enumerate(parts)]
    for (id_, repeats), table in zip(_ids(tables, "edges"), tables, strict=True):
        where = f"edge {(*repeats, id_)[0]}"
        start, end = (fields.required(table, key, fields.identifier, where) for key in ("start", "end"))
        extra = fields.rest(OWN, table)
        yield DocumentEdge(id_, start, end, not directed, extra=extra, repeats=repeats)


def is_directed(floor: DocumentFloor) -> bool:
    """Tell whether an edge leads one way only: then all do in such a file."""
    return not all(edge.two_way for edge in floor.edges.values())


def new_ids(floor: DocumentFloor) -> Numbered:
    """Return the floor with whole numbers as ids, as the messages have them."""
    return numbered(floor)


def write(document: GraphDocument, choices: WriteChoices) -> str:
    """Return the text of the only floor of a document."""
    (floor,) = document.floors.values()
    return "\n".join([*_lines(new_ids(floor).floor), ""])


def _lines(floor: DocumentFloor) -> Iterator[str]:
    directed, own = is_directed(floor), dict(floor.extra.get(OWN, {}))
    more = own.pop("graph", {}) if isinstance(own.get("graph"), dict) else {}
    if directed:
        yield "directed: true"
    yield "graph:"
    yield "  vertices:" if floor.vertices else "  vertices: []"
    yield from (f"    - {flow(_vertex(one))}" for one in floor.vertices.values())
    ways = one_way_edges(floor.edges.values(), floor.edges) if directed else floor.edges.values()
    yield "  edges:" if floor.edges else "  edges: []"
    yield from (f"    - {flow(_edge(one))}" for one in ways)
    yield from (f"  {key_text(key)}: {flow(value)}" for key, value in more.items())
    yield "labeled_vertices:"
    yield "  vertices:" if floor.labels else "  vertices: []"
    for id_, label in floor.labels.items():
        yield f"    - {flow({'label': label, 'vertex_id': int(id_)})}"
    yield from (f"{key_text(key)}: {flow(value)}" for key, value in own.items())


def _vertex(vertex: DocumentVertex) -> Table:
    own = vertex.extra.get(OWN, {})
    return {"id": int(vertex.id), "x": vertex.x, "y": vertex.y, "type": vertex.type, **own}


def _edge(edge: DocumentEdge) -> Table:
    return {"id": int(edge.id), "start": int(edge.start), "end": int(edge.end), **edge.extra.get(OWN, {})}

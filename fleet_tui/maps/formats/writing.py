"""Writes documents in any format that can be written, after what it loses is known."""

import math
from collections.abc import Callable

from fleet_tui.maps.formats import geojson, lif_text, native_text, oh, rmf
from fleet_tui.maps.formats.graph_file import MissingChoiceError, WriteChoices
from fleet_tui.model.graphs.document import DocumentFloor, GraphDocument, GraphFormat
from fleet_tui.text.errors import GraphError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate

Write = Callable[[GraphDocument, WriteChoices], str]
WRITERS: dict[GraphFormat, Write] = {
    GraphFormat.NATIVE: native_text.write,
    GraphFormat.OH: oh.write,
    GraphFormat.RMF: rmf.write,
    GraphFormat.GEOJSON: geojson.write,
    GraphFormat.LIF: lif_text.write,
}
ENDINGS: dict[str, GraphFormat] = {
    ".building.yaml": GraphFormat.RMF_BUILDING,
    ".site.json": GraphFormat.RMF_SITE,
    ".geojson": GraphFormat.GEOJSON,
    ".lif.json": GraphFormat.LIF,
    ".lif": GraphFormat.LIF,
    ".xml": GraphFormat.OPENTCS,
}
"""The format that the end of a file's name tells."""
ONE_FLOOR = frozenset({GraphFormat.OH, GraphFormat.GEOJSON})
"""The formats with a file for each floor."""


def write_graph(document: GraphDocument, format_: GraphFormat, choices: WriteChoices) -> str:
    """Return the text of a file. Raises GraphError for what the format can't hold, MissingChoiceError for
    what it needs."""
    if format_ not in WRITERS:
        writable = ", ".join(one.value for one in WRITERS)
        raise GraphError(
            Message(
                "{format} can be read, not written: choose one of {writable}",
                format=format_.value,
                writable=writable,
            )
        )
    if format_ in ONE_FLOOR and len(document.floors) != 1:
        names = tuple(document.floors)
        text = Message(
            "{format} has a file for each floor: choose one of {names}",
            format=format_.value,
            names=", ".join(names[:10]) or "none",
        )
        raise MissingChoiceError(text, "--floor", names)
    if format_ is not GraphFormat.NATIVE:
        for floor in document.floors.values():
            _check(floor)
    try:
        return WRITERS[format_](document, choices)
    except (TypeError, ValueError, LookupError, AttributeError) as problem:
        # Only `extra` is unchecked: a native file may have anything there.
        text = Message(
            "contents kept for {format} are not as the format has them: {problem}",
            format=format_.value,
            problem=truncate(str(problem), 80),
        )
        raise GraphError(text) from problem


def named_format(name: str) -> GraphFormat | None:
    """Return the format that a file's name tells, None if several have such names."""
    return next((format_ for end, format_ in ENDINGS.items() if name.lower().endswith(end)), None)


def _check(floor: DocumentFloor) -> None:
    """Raise GraphError for what no format but our own can hold."""
    for vertex in floor.vertices.values():
        if not (math.isfinite(vertex.x) and math.isfinite(vertex.y)):
            raise GraphError(
                Message(
                    "vertex {name} on {floor}: x or y is not finite: correct it first",
                    name=vertex.id,
                    floor=floor.name,
                )
            )
        if vertex.heading is not None and not math.isfinite(vertex.heading):
            raise GraphError(
                Message(
                    "vertex {name} on {floor}: heading is not finite: correct it first",
                    name=vertex.id,
                    floor=floor.name,
                )
            )
    for edge in floor.edges.values():
        lost = [end for end in (edge.start, edge.end) if end not in floor.vertices]
        if lost:
            raise GraphError(
                Message(
                    "edge {name} on {floor}: unknown vertex {vertex}: correct it first",
                    name=edge.id,
                    floor=floor.name,
                    vertex=lost[0],
                )
            )
        numbers = edge.speed, edge.speed_percent, edge.cost, edge.length
        if not all(math.isfinite(one) for one in numbers if one is not None):
            raise GraphError(
                Message(
                    "edge {name} on {floor}: a value is not finite: correct it first",
                    name=edge.id,
                    floor=floor.name,
                )
            )

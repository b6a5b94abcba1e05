"""Documents and files of graphs: made up by hand, and by hypothesis."""

from pathlib import Path
from typing import Any

from hypothesis import strategies as st

from fleet_tui.maps.formats.graph_file import GraphFile, ReadChoices, WriteChoices
from fleet_tui.maps.formats.reading import read_graph
from fleet_tui.maps.formats.writing import write_graph
from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Lift,
    MapReference,
    Motion,
    Station,
    merge_opposites,
    of_floor,
)

SHARED = Path(__file__).parents[3] / "shared"
WRITTEN = WriteChoices("agv", "2026-01-01T00:00:00Z")

NAMES = st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=8) | st.sampled_from(
    [
        "yes",
        "007",
        "1e3",
        "~",
        "null",
        "a: b",
        "#x",
        "{",
        "é",
        "\x1b[2J",
        "\u2028",
        "名前",
        " ",
        "- a",
        "'",
        '"',
        "\\",
    ]
)
LABELS = st.just("") | NAMES
NUMBERS = (
    st.floats(-1e6, 1e6) | st.integers(-1000, 1000).map(float) | st.sampled_from([1e-7, 1e16, 0.1, -0.0])
)
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**31), 2**31) | NUMBERS | st.text(max_size=4) | NAMES,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(NAMES, inner, max_size=3),
    max_leaves=5,
)
TABLES = st.dictionaries(st.text("abcdefgh_", min_size=4, max_size=8), VALUES, max_size=2)
SPEEDS = st.none() | st.floats(0.01, 5.0)


@st.composite
def vertices(draw: st.DrawFn, extra: str = "") -> dict[str, DocumentVertex]:
    """Some vertices, numbered."""
    found = {}
    for n in range(draw(st.integers(1, 5))):
        more = draw(TABLES) if extra else {}
        found[str(n)] = DocumentVertex(
            str(n),
            draw(NUMBERS),
            draw(NUMBERS),
            draw(LABELS),
            draw(st.sampled_from(["", "charger", "lift", "shelf"])),
            extra={extra: more} if more else {},
        )
    return found


@st.composite
def documents(draw: st.DrawFn) -> GraphDocument:
    """A document with everything that the model has."""
    floors = {}
    for name in draw(st.lists(NAMES, min_size=1, max_size=2, unique=True)):
        at = draw(vertices("rmf"))
        ends = st.sampled_from(sorted(at))
        edges = [
            DocumentEdge(
                str(n),
                draw(ends),
                draw(ends),
                draw(st.booleans()),
                speed=draw(SPEEDS),
                speed_percent=draw(SPEEDS),
                cost=draw(SPEEDS),
                locked=draw(st.booleans()),
                motion=draw(st.sampled_from(Motion)),
                length=draw(SPEEDS),
                control_points=tuple(draw(st.lists(st.tuples(NUMBERS, NUMBERS), max_size=2))),
                per_vehicle=draw(st.dictionaries(NAMES, TABLES, max_size=2)),
                source_id=draw(LABELS),
                extra=draw(st.sampled_from([{}, {"lif": {"a": [1, 2.0, None]}}])),
            )
            for n in range(100, draw(st.integers(100, 104)))
        ]
        to_site = draw(st.sampled_from([(0.0, 0.0, 0.0), (1.0, -2.5, 0.5)]))
        map_ = draw(st.none() | st.builds(MapReference, NAMES, NUMBERS, st.tuples(NUMBERS, NUMBERS, NUMBERS)))
        floors[name] = DocumentFloor(name, at, {one.id: one for one in edges}, draw(LABELS), map_, to_site)
    stops = [(name, id_) for name, floor in floors.items() for id_ in floor.vertices]
    lifts = draw(
        st.lists(st.builds(Lift, NAMES, st.just(tuple(stops[:2])), NUMBERS, NUMBERS, NUMBERS), max_size=2)
    )
    stations = draw(st.lists(st.builds(Station, NAMES, st.just(tuple(stops[-1:])), NUMBERS), max_size=2))
    extras: list[dict[str, Any]] = [{}, {"geojson": {"date": "x"}}, {"native": {"later": [1]}}]
    extra = draw(st.sampled_from(extras))
    return GraphDocument(draw(LABELS), floors, tuple(lifts), tuple(stations), extra=extra)


def sample() -> GraphDocument:
    """A floor with something of each sort."""
    places = {
        "0": DocumentVertex("0", 0.0, 0.0, "Base", "charger", 1.5),
        "1": DocumentVertex("1", 4.0, 0.25, "007"),
        "2": DocumentVertex("2", 4.0, 3.0, "yes", "lift"),
        "7": DocumentVertex("7", 1.0000000001, 3.0, "", "shelf"),
    }
    edges = [
        DocumentEdge("10", "0", "1", True, "11", 0.5, None, 2.0),
        DocumentEdge("12", "1", "2", False, motion=Motion.BACKWARD),
        DocumentEdge("13", "2", "7", locked=True, control_points=((3.0, 3.5),), length=3.5),
        DocumentEdge("14", "7", "0", speed_percent=50.0),
    ]
    floor = DocumentFloor("ground", places, merge_opposites(edges), "map", MapReference("ground.yaml"))
    station = Station("Dock", (("ground", "0"),), 0.0, -1.0, 0.5)
    return GraphDocument("site", {"ground": floor}, (Lift("A", (("ground", "2"),)),), (station,))


def read_text(text: str, format_: GraphFormat | None = None, **choices: Any) -> GraphFile:
    """A file's document."""
    return read_graph(text, format_, ReadChoices(**choices))


def write_text(document: GraphDocument, format_: GraphFormat) -> str:
    """The file of a document."""
    return write_graph(document, format_, WRITTEN)


def again(document: GraphDocument, format_: GraphFormat) -> GraphDocument:
    """The document after it was written and read."""
    name = next(iter(document.floors), "floor")
    found = read_text(write_text(document, format_), floor=name)
    assert found.format is format_
    return found.document


def line_graph(*places: tuple[float, float], **changes: Any) -> GraphDocument:
    """A floor with vertices 1, 2, ... each connected with the next."""
    vertices = {str(n): DocumentVertex(str(n), x, y) for n, (x, y) in enumerate(places, 1)}
    edges = {str(n): DocumentEdge(str(n), str(n), str(n + 1)) for n in range(1, len(places))}
    return of_floor(DocumentFloor("f", vertices, edges, **changes))

"""Formats recognised by content, and files that are none or want to harm."""

import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.maps.formats.graph_file import ReadChoices
from fleet_tui.maps.formats.reading import format_named, read_graph, recognised
from fleet_tui.maps.formats.writing import WRITERS
from fleet_tui.model.graphs.document import GraphFormat
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import SHARED, VALUES, read_text, sample, write_text

FILES = {format_: write_text(sample(), format_) for format_ in WRITERS}
FILES[GraphFormat.OPENTCS] = (
    '<model version="7.0.0" name="m"><point name="a" positionX="0" positionY="0"/>'
    '<path name="p" sourcePoint="a" destinationPoint="a" length="1" maxVelocity="1"/></model>'
)
FILES[GraphFormat.RMF_BUILDING] = (
    "coordinate_system: reference_image\nlevels:\n  L:\n"
    "    vertices: [[0, 0, 0, a], [1, 1, 0, b]]\n    lanes: [[0, 1, {bidirectional: [4, true]}]]\n"
)
ANCHORS = {"8": {"Translate2D": [1, 2]}, "9": {"Translate2D": [5, 2]}}
FILES[GraphFormat.RMF_SITE] = json.dumps(
    {
        "format_version": "0.1",
        "levels": {"1": {"properties": {"name": "L"}, "anchors": ANCHORS}},
        "navigation": {"guided": {"lanes": {"30": {"anchors": [8, 9]}}}},
    }
)
SAMPLES = {
    "office_nav.yaml": GraphFormat.RMF,
    "office.building.yaml": GraphFormat.RMF_BUILDING,
    "sample_graph.geojson": GraphFormat.GEOJSON,
    "example.lif.json": GraphFormat.LIF,
    "opentcs7.sample.xml": GraphFormat.OPENTCS,
}


@pytest.mark.parametrize("format_", FILES)
def test_each_format_is_recognised(format_: GraphFormat) -> None:
    assert recognised(FILES[format_]) is format_
    assert read_text(f"\ufeff{FILES[format_]}").format is format_
    assert read_text(FILES[format_], format_).format is format_


@pytest.mark.skipif(not SHARED.is_dir(), reason="samples lie beside the repository only where it was built")
@pytest.mark.parametrize("name", SAMPLES)
def test_files_of_real_projects(name: str) -> None:
    text = (SHARED / "graphs" / name).read_text()
    assert recognised(text) is SAMPLES[name]
    found = read_text(text, floor="f")
    assert read_text(write_text(found.document, GraphFormat.NATIVE)).document == found.document


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("", "empty; known formats: native, oh, rmf, rmf-building, rmf-site, geojson, lif, opentcs"),
        (" \n", "empty"),
        ("hello", "no known format; known formats: native"),
        ("[1]", "no known format"),
        ("<html/>", "no known format"),
        ("<html", "not XML: unclosed token in line 1"),
        ('{"type": "FeatureCollection", "features": [', "not JSON: Input data was truncated"),
        ("levels:\n  L1: [", "not YAML: .* in line [23]"),
        ("\x00\x01", "not YAML"),
    ],
)
def test_what_is_no_graph(text: str, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        read_text(text)


def test_another_format_than_said() -> None:
    with pytest.raises(GraphError, match="not lif but geojson: leave out --from"):
        read_text(FILES[GraphFormat.GEOJSON], GraphFormat.LIF)
    assert format_named("rmf") is GraphFormat.RMF
    with pytest.raises(GraphError, match="unknown format 'geojsn', did you mean geojson"):
        format_named("geojsn")


def _read(text: str) -> None:
    """Read a file, and write it in every format: well, or with an error in words."""
    for format_ in WRITERS:
        _convert(text, format_)


def _convert(text: str, format_: GraphFormat) -> None:
    try:
        document = read_graph(text, None, ReadChoices(building_graph=0)).document
        read_text(write_text(document, format_), format_)
    except GraphError as problem:
        assert str(problem) and len(str(problem)) < 1000


@pytest.mark.parametrize("format_", FILES)
@given(data=st.data())
def test_damaged_files_are_errors_in_words(format_: GraphFormat, data: st.DataObject) -> None:
    text = FILES[format_]
    start = data.draw(st.integers(0, len(text)))
    stop = data.draw(st.integers(start, min(start + 20, len(text))))
    inserted = data.draw(
        st.text(max_size=3) | st.sampled_from(["1e999", "NaN", "-1", "[[", "{}", "\x1b", "9" * 40])
    )
    _read(text[:start])
    _read(text[:start] + inserted + text[stop:])


def _paths(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [path, *(found for key, one in inner for found in _paths(one, (*path, key)))]


TREES: dict[GraphFormat, Any] = {
    GraphFormat.GEOJSON: json.loads(FILES[GraphFormat.GEOJSON]),
    GraphFormat.LIF: json.loads(FILES[GraphFormat.LIF]),
    GraphFormat.NATIVE: {"fleet_tui_graph": 1, "floors": {"f": {"vertices": [{"id": "1", "x": 0, "y": 0}]}}},
    GraphFormat.OH: {
        "graph": {"vertices": [{"id": 1, "x": 0, "y": 0}], "edges": [{"id": 1, "start": 1, "end": 1}]}
    },
    GraphFormat.RMF: {
        "levels": {
            "L": {"vertices": [[0, 0, {"name": "a", "lift": "A"}]], "lanes": [[0, 0, {"speed_limit": 1}]]}
        },
        "lifts": {"A": {"position": [0, 0, 0], "dims": [1, 1]}},
    },
    GraphFormat.RMF_BUILDING: {
        "coordinate_system": "reference_image",
        "levels": {
            "L": {
                "vertices": [[0, 0, 0, "a", {"is_charger": [4, True]}], [1, 1, 0, "b"]],
                "lanes": [[0, 1, {"bidirectional": [4, True], "speed_limit": [3, 1.0]}]],
                "measurements": [[0, 1, {"distance": [3, 5.0]}]],
                "fiducials": [[0, 0, "p"]],
            }
        },
        "lifts": {"A": {"x": 1, "y": 2, "width": 1, "depth": 1}},
    },
}


@pytest.mark.parametrize("format_", TREES)
@given(data=st.data())
def test_other_values_anywhere_are_errors_in_words(format_: GraphFormat, data: st.DataObject) -> None:
    """The same through JSON, which is YAML too."""
    tree = json.loads(json.dumps(TREES[format_]))
    *path, last = data.draw(st.sampled_from(_paths(tree)[1:]))
    holder = tree
    for key in path:
        holder = holder[key]
    holder[last] = data.draw(VALUES | st.sampled_from([10**400, 10**20, [[]], {"a": {}}, "x" * 5000]))
    text = json.dumps(tree)
    _read(text)
    _read(f"# YAML\n{text}")

"""Documents that a format can't hold."""

import math

import pytest
from msgspec.structs import replace

from fleet_tui.maps.formats.graph_file import MissingChoiceError
from fleet_tui.maps.formats.writing import WRITERS
from fleet_tui.model.graphs.document import DocumentFloor, DocumentVertex, GraphFormat, of_floor
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import again, line_graph, sample, write_text

FOREIGN = sorted(set(WRITERS) - {GraphFormat.NATIVE}, key=lambda one: one.value)


def test_formats_that_are_only_read() -> None:
    with pytest.raises(GraphError, match="opentcs can be read, not written: choose one of native, oh"):
        write_text(sample(), GraphFormat.OPENTCS)


def test_extra_contents_may_be_anything_in_our_own_files() -> None:
    vertex = DocumentVertex(
        "1", 0.0, 0.0, extra={"lif": {"vehicleTypeNodeProperties": 7}, "geojson": 7, "rmf": [1]}
    )
    document = of_floor(DocumentFloor("f", {"1": vertex}))
    for format_ in (GraphFormat.LIF, GraphFormat.GEOJSON, GraphFormat.RMF):
        with pytest.raises(
            GraphError, match=f"contents kept for {format_.value} are not as the format has them"
        ):
            write_text(document, format_)
    assert again(document, GraphFormat.NATIVE) == document


def test_a_file_for_each_floor() -> None:
    two = sample().with_floor(DocumentFloor("upper"))
    for format_ in (GraphFormat.OH, GraphFormat.GEOJSON):
        with pytest.raises(MissingChoiceError, match="choose one of ground, upper") as missing:
            write_text(two, format_)
        assert (missing.value.option, missing.value.choices) == ("--floor", ("ground", "upper"))


@pytest.mark.parametrize("format_", FOREIGN)
def test_what_only_our_own_format_holds(format_: GraphFormat) -> None:
    nowhere = line_graph((0.0, 0.0), (math.nan, 0.0))
    with pytest.raises(GraphError, match="vertex 2 on f: x or y is not finite"):
        write_text(nowhere, format_)
    lost = line_graph((0.0, 0.0), (1.0, 0.0))
    (line,) = lost.floors["f"].edges.values()
    turned = replace(lost.floors["f"].vertices["1"], heading=math.inf)
    for name, elements in (("edges", {"1": replace(line, speed=math.nan)}), ("vertices", {"1": turned})):
        with pytest.raises(GraphError, match="is not finite: correct it first"):
            write_text(lost.with_floor(replace(lost.floors["f"], **{name: elements})), format_)
    floor = DocumentFloor("f", {"1": lost.floors["f"].vertices["1"]}, lost.floors["f"].edges)
    with pytest.raises(GraphError, match="edge 1 on f: unknown vertex 2"):
        write_text(lost.with_floor(floor), format_)
    assert again(lost.with_floor(floor), GraphFormat.NATIVE) == lost.with_floor(floor)

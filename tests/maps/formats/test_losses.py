"""Losses of a conversion, counted; and that nothing else is lost."""

import pytest
from msgspec.structs import replace

from fleet_tui.maps.formats.losses import Loss, losses
from fleet_tui.model.graphs.document import DocumentFloor, DocumentVertex, GraphFormat
from tests.support.graph_files import again, sample

LOST = {
    GraphFormat.NATIVE: {},
    GraphFormat.OH: {
        "headings": 1,
        "speeds": 1,
        "speeds in per cent": 1,
        "costs": 1,
        "locked edges": 1,
        "lengths": 1,
        "driving directions": 1,
        "curves": 1,
        "lifts": 1,
        "stations": 1,
        "map files": 1,
        "frames": 1,
    },
    GraphFormat.RMF: {
        "vertex ids": 1,
        "edge ids": 5,
        "types": 1,
        "headings": 1,
        "speeds in per cent": 1,
        "costs": 1,
        "locked edges": 1,
        "lengths": 1,
        "curves": 1,
        "stations": 1,
        "map files": 1,
        "frames": 1,
    },
    GraphFormat.GEOJSON: {
        "headings": 1,
        "speeds in per cent": 1,
        "curves": 1,
        "lifts": 1,
        "stations": 1,
        "map files": 1,
    },
    GraphFormat.LIF: {
        "types": 2,
        "speeds in per cent": 1,
        "costs": 1,
        "locked edges": 1,
        "lengths": 1,
        "lifts": 1,
        "map files": 1,
        "frames": 1,
    },
}


@pytest.mark.parametrize("format_", LOST)
def test_losses_of_each_format(format_: GraphFormat) -> None:
    assert {one.what: one.count for one in losses(sample(), format_)} == LOST[format_]


@pytest.mark.parametrize("format_", LOST)
def test_what_was_read_from_a_format_loses_nothing_in_it(format_: GraphFormat) -> None:
    document = again(sample(), format_)
    assert losses(document, format_) == ()
    assert again(document, format_) == document


def test_ids_that_change_and_details_of_others() -> None:
    vertices = {
        "a": DocumentVertex("a", 0.0, 0.0, extra={"lif": {"x": 1}}),
        "5": DocumentVertex("5", 0.0, 0.0, extra={"oh": {"x": 1}}),
    }
    document = sample().with_floor(DocumentFloor("ground", vertices, to_site=(1.0, 0.0, 0.0)))
    document = replace(document, lifts=(), stations=())
    assert [str(one) for one in losses(document, GraphFormat.OH)] == [
        "vertex ids: 1",
        "places in the site: 1",
        "details of other formats: 1",
    ]
    both = document.with_floor(DocumentFloor("upper", {"5": vertices["5"]}))
    assert str(losses(both, GraphFormat.LIF)[0]) == "vertex ids: 2"


def test_elements_with_new_ids_are_not_called_lost() -> None:
    said = [Loss("edge ids", 1).line, Loss("vertex ids", 2).line, Loss("costs", 1).line]
    assert said == ["new ids: 1 edge", "new ids: 2 vertices", "lost: costs: 1"]

"""Floors in the frame of the site."""

import math

from pytest import approx

from fleet_tui.maps.formats.site_frame import in_site
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex


def test_vertices_headings_and_curves_are_turned_and_moved() -> None:
    vertices = {"0": DocumentVertex("0", 1.0, 0.0, heading=0.0), "1": DocumentVertex("1", 0.0, 0.0)}
    edges = {"0": DocumentEdge("0", "0", "1", control_points=((2.0, 0.0),))}
    floor = DocumentFloor("f", vertices, edges)
    assert in_site(floor) is floor
    moved = in_site(DocumentFloor("f", vertices, edges, to_site=(10.0, 0.0, math.pi / 2)))
    at = moved.vertices["0"]
    assert (at.x, at.y, at.heading) == approx((10.0, 1.0, math.pi / 2))
    assert moved.vertices["1"].heading is None and moved.edges["0"].control_points[0] == approx((10.0, 2.0))

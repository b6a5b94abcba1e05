"""Whole numbers as ids."""

from fleet_tui.maps.formats.renumbering import numbered
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex


def test_ids_that_fit_are_kept_and_the_others_come_after_them() -> None:
    vertices = {id_: DocumentVertex(id_, 0.0, 0.0) for id_ in ("7", "a", "-1", "007")}
    edges = {
        "7": DocumentEdge("7", "a", "7", True, "8"),
        "8": DocumentEdge("8", "a", "-1"),
        "e": DocumentEdge("e", "7", "gone"),
    }
    found = numbered(DocumentFloor("f", vertices, edges), lowest=0, one_counter=True)
    assert {id_: one.source_id for id_, one in found.floor.vertices.items()} == {
        "7": "",
        "8": "a",
        "9": "",
        "10": "007",
    }
    assert [(e.id, e.start, e.end, e.reverse_id) for e in found.floor.edges.values()] == [
        ("11", "8", "7", ""),
        ("12", "8", "9", ""),
        ("13", "7", "gone", ""),
    ]
    assert (found.vertices, found.edges) == (3, 3)


def test_reverse_ids_stay_where_they_fit() -> None:
    floor = DocumentFloor(
        "f", {"0": DocumentVertex("0", 0.0, 0.0)}, {"1": DocumentEdge("1", "0", "0", True, "2")}
    )
    assert numbered(floor, 0, True).floor == floor

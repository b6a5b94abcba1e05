"""The document of a graph: its ids, and edges that lead both ways."""

from msgspec.structs import replace

from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    Lift,
    Motion,
    Station,
    merge_opposites,
    of_floor,
    one_way_edges,
)


def one_way(id_: str, start: str, end: str, speed: float | None = None) -> DocumentEdge:
    return DocumentEdge(id_, start, end, two_way=False, speed=speed)


def test_opposites_with_equal_attributes_become_one() -> None:
    there = replace(one_way("1", "a", "b", 0.5), control_points=((0.0, 1.0), (2.0, 3.0)))
    back = replace(one_way("2", "b", "a", 0.5), control_points=((2.0, 3.0), (0.0, 1.0)))
    merged = merge_opposites([there, back])
    assert list(merged) == ["1"]
    assert (merged["1"].two_way, merged["1"].reverse_id) == (True, "2")
    assert one_way_edges(merged.values(), merged) == [
        replace(there, reverse_id="2"),
        replace(back, reverse_id="1"),
    ]


def test_opposites_that_differ_stay_two() -> None:
    slow = replace(one_way("2", "b", "a"), motion=Motion.BACKWARD)
    assert list(merge_opposites([one_way("1", "a", "b"), slow])) == ["1", "2"]


def test_a_doubled_edge_is_merged_with_one_opposite_only() -> None:
    edges = [one_way("1", "a", "b"), one_way("2", "a", "b"), one_way("3", "b", "a"), one_way("4", "a", "a")]
    merged = merge_opposites(edges)
    assert {id_: edge.two_way for id_, edge in merged.items()} == {"1": True, "2": False, "4": False}


def test_opposite_directions_without_an_id_get_new_ones() -> None:
    edges = {
        "0": replace(DocumentEdge("0", "a", "b"), reverse_id="5"),
        "2": DocumentEdge("2", "b", "c"),
        "e": DocumentEdge("e", "c", "a"),
    }
    ids = [edge.id for edge in one_way_edges(edges.values(), edges)]
    assert ids == ["0", "5", "2", "6", "e", "e-reverse"]


def test_one_floor_of_several_with_its_stops() -> None:
    floors = {name: DocumentFloor(name, {"1": DocumentVertex("1", 0.0, 0.0, "Base")}) for name in ("a", "b")}
    lifts = (Lift("A", (("a", "1"), ("b", "1"))), Lift("B", (("b", "1"),)))
    document = GraphDocument("site", floors, lifts, (Station("S", (("b", "1"),)),))
    only = document.only("a")
    assert (list(only.floors), only.lifts, only.stations) == (["a"], (Lift("A", (("a", "1"),)),), ())
    changed = replace(floors["a"], vertices={})
    assert document.with_floor(changed).floors == {"a": changed, "b": floors["b"]}
    assert of_floor(floors["a"]).floors["a"].labels == {"1": "Base"}

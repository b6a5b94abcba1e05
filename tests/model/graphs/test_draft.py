"""Drafts: every step can be undone and taken again, and no id is given twice."""

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.graphs.rules import edits
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex
from fleet_tui.model.graphs.draft import Change, GraphDraft
from fleet_tui.text.language import Message

EMPTY = DocumentFloor("floor_0")


def connected(draft: GraphDraft, start: str, end: str) -> Change:
    ids = draft.free_ids()
    return edits.connected(next(ids), next(ids), start, end)


def stepped(draft: GraphDraft, number: int) -> None:
    """Take the step of a number: add, connect, move or remove."""
    ids = list(draft.floor.vertices)
    if number % 4 == 0 or len(ids) < 2:
        draft.do(edits.added(DocumentVertex(next(draft.free_ids()), number, -number)))
        return
    one, other = ids[number % len(ids)], ids[(number + 1) % len(ids)]
    vertex = draft.floor.vertices[one]
    match number % 4:
        case 1:
            draft.do(connected(draft, one, other))
        case 2:
            draft.do(edits.renewed(vertex, DocumentVertex(one, vertex.x + 1, vertex.y, "Store", "dock", 0.5)))
        case _:
            draft.do(edits.removed(draft.floor, one))


@given(st.lists(st.integers(0, 99), max_size=30))
def test_all_steps_undone_are_the_floor_before_and_redone_the_floor_after(steps: list[int]) -> None:
    draft, floors = GraphDraft(EMPTY), [EMPTY]
    for step in steps:
        stepped(draft, step)
        floors.append(draft.floor)
    for floor in reversed(floors[:-1]):
        assert draft.undo() is not None
        assert draft.floor == floor
    assert draft.undo() is None
    for floor in floors[1:]:
        assert draft.redo() is not None
        assert draft.floor == floor
    assert draft.redo() is None


def test_a_removed_vertex_takes_its_edges_along_and_its_id_is_not_given_again() -> None:
    draft = GraphDraft(EMPTY)
    for n in range(3):
        draft.do(edits.added(DocumentVertex(next(draft.free_ids()), n, 0)))
    draft.do(connected(draft, "1", "2"))
    draft.do(connected(draft, "2", "3"))
    draft.do(edits.removed(draft.floor, "3"))
    assert list(draft.floor.vertices) == ["1", "2"]
    assert [(edge.id, edge.reverse_id) for edge in draft.floor.edges.values()] == [("4", "5")]
    assert next(draft.free_ids()) == "8"
    draft.undo()
    draft.undo()
    assert next(draft.free_ids()) == "8"


def test_a_new_id_is_above_those_of_vertices_edges_and_ways_back() -> None:
    vertices = {id_: DocumentVertex(id_, 0.0, 0.0) for id_ in ("0", "3")}
    for edge, free in ((DocumentEdge("9", "0", "3"), "10"), (DocumentEdge("4", "0", "3", True, "12"), "13")):
        assert next(GraphDraft(DocumentFloor("f", vertices, {edge.id: edge})).free_ids()) == free


def test_a_new_step_ends_the_undone_ones() -> None:
    draft = GraphDraft(EMPTY)
    draft.do(Change(Message("nothing")))
    draft.undo()
    draft.do(Change(Message("nothing else")))
    assert draft.redo() is None

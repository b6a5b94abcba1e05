"""The graph editor's map mode: the draft in place of the live graph."""

from dataclasses import replace

import pytest

from fleet_tui.features.graphs.edit_mode import EditMode, cell_metres
from fleet_tui.features.graphs.rules import edits
from fleet_tui.model.graphs.document import DocumentEdge, DocumentFloor, DocumentVertex
from fleet_tui.model.graphs.draft import GraphDraft
from fleet_tui.text.language import Message
from fleet_tui.ui.view.map.viewport import Viewport
from tests.support.map_pane import SCENE

FLOOR = DocumentFloor(
    "floor_0",
    {
        "7": DocumentVertex("7", 2.0, 2.0, "Dock"),
        "8": DocumentVertex("8", 10.0, 2.0),
        "9": DocumentVertex("9", 10.0, 8.0),
    },
    {
        "1": DocumentEdge("1", "7", "8"),
        "2": DocumentEdge("2", "8", "9", two_way=False),
        "3": DocumentEdge("3", "9", "?"),
    },
)


def view() -> Viewport:
    return Viewport(100, 29)


def test_the_draft_is_shown_in_place_of_the_live_graph() -> None:
    mode = EditMode(FLOOR, (5.0, 5.0))
    mode.selected, mode.edge = "7", "1"
    scene = mode.adjusted(SCENE)
    assert [vertex.id for vertex in scene.vertices] == ["7", "8", "9"]
    assert scene.edges == ((2.0, 2.0, 10.0, 2.0), (10.0, 2.0, 10.0, 8.0))
    assert scene.one_way == scene.edges[1:]
    assert scene.target_vertices == ("7",) and scene.mission is not None
    assert mode.adjusted(SCENE).vertices is scene.vertices
    assert scene.robots == SCENE.robots


def test_what_is_gone_is_not_selected_any_more() -> None:
    mode = EditMode(FLOOR, (5.0, 5.0))
    mode.selected, mode.edge, mode.held = "7", "1", True
    mode.show(DocumentFloor("floor_0"))
    assert (mode.selected, mode.edge, mode.held) == ("", "", False)
    assert mode.edge_at(view(), SCENE, (5.0, 5.0)) == ""


@pytest.mark.parametrize(("at", "found"), [((2.0, 2.0), "7"), ((6.0, 2.0), "")])
def test_the_vertex_in_the_cursors_cell_is_found(at: tuple[float, float], found: str) -> None:
    assert EditMode(FLOOR, (0.0, 0.0)).vertex_at(view(), SCENE, at) == found


@pytest.mark.parametrize(
    ("at", "found"), [((6.0, 2.1), "1"), ((10.0, 6.0), "2"), ((5.0, 5.0), ""), ((14.0, 2.0), "")]
)
def test_the_nearest_edge_is_found(at: tuple[float, float], found: str) -> None:
    assert EditMode(FLOOR, (0.0, 0.0)).edge_at(view(), SCENE, at) == found


def test_the_banner_says_where_the_cursor_is_and_how_far_from_the_selected_vertex() -> None:
    mode = EditMode(FLOOR, (2.0, 5.0))
    assert mode.banner("floor_0") == "EDIT 2.00, 5.00 m"
    mode.selected, mode.note = "7", Message("2E")
    assert mode.banner("floor_0") == "EDIT 2.00, 5.00 m 2E, from Dock 3.0 m"
    mode.held = True
    assert "moving Dock" in mode.banner("floor_0")


def test_the_banner_names_the_drafts_floor_while_another_one_is_shown() -> None:
    assert EditMode(FLOOR, (2.0, 5.0)).banner("floor_1") == "EDIT floor_0 2.00, 5.00 m"


def test_the_mouse_grasps_a_vertex_and_moves_it_along() -> None:
    mode = EditMode(FLOOR, (0.0, 0.0))
    assert mode.press(view(), SCENE, (5.0, 5.0)) is False
    assert mode.press(view(), SCENE, (2.0, 2.0)) is True
    mode.drag((3.0, 3.0))
    assert (mode.selected, mode.held, mode.cursor) == ("7", True, (3.0, 3.0))


def test_a_cell_is_some_decimetres_high_here() -> None:
    assert 0.2 < cell_metres(view(), SCENE) < 1.0


def test_another_floor_is_shown_as_it_is() -> None:
    mode = EditMode(DocumentFloor("floor_1"), (0.0, 0.0))
    assert mode.adjusted(SCENE) is SCENE


def test_after_a_change_the_picture_is_as_if_all_were_drawn_anew() -> None:
    mode, draft = EditMode(FLOOR, (0.0, 0.0)), GraphDraft(FLOOR)
    steps = (
        edits.renewed(FLOOR.vertices["8"], DocumentVertex("8", 11.0, 2.0, "Store")),
        edits.connected("4", "5", "7", "9"),
        edits.turned(FLOOR.edges["1"]),
        edits.removed(FLOOR, "9"),
        edits.added(DocumentVertex("?", 1.0, 1.0)),
    )
    for step in steps:
        draft.do(step)
        mode.show(draft.floor, step)
        anew = EditMode(draft.floor, (0.0, 0.0)).adjusted(SCENE)
        scene = mode.adjusted(SCENE)
        assert sorted(scene.vertices, key=str) == sorted(anew.vertices, key=str)
        assert sorted(scene.edges) == sorted(anew.edges) and sorted(scene.one_way) == sorted(anew.one_way)


def test_the_mouse_grasps_nothing_of_another_floor_and_nothing_that_is_gone() -> None:
    mode = EditMode(FLOOR, (0.0, 0.0))
    assert mode.press(view(), replace(SCENE, floor="floor_1"), (2.0, 2.0)) is False
    mode.drag((3.0, 3.0))
    assert mode.selected == "" and mode.banner("floor_0")
    mode.press(view(), SCENE, (2.0, 2.0))
    mode.show(DocumentFloor("floor_0"))
    mode.drag((3.0, 3.0))
    assert mode.selected == "" and mode.banner("floor_0")

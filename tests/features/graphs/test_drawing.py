"""Drawing in the graph editor: what each key makes of the draft."""

from itertools import product

import pytest

from fleet_tui.features.graphs.edit_mode import cell_metres
from fleet_tui.model.geometry import Pose
from tests.support.desk import ready
from tests.support.drawn_graph import DrawnGraph, drawn_graph
from tests.support.fleets import T0, pose, reduced, tick


def select(it: DrawnGraph, vertex: str) -> None:
    at = it.floor.vertices[vertex]
    it.at((at.x, at.y))
    it.mode.selected = it.mode.edge = ""
    it.drawing.select()
    assert it.mode.selected == vertex


async def test_a_way_is_drawn_by_cursor_and_key_alone() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.at((4.0, 6.0))
        it.drawing.add_at_cursor()
        for place in ((8.0, 6.0), (8.0, 9.0)):
            it.at(place)
            it.drawing.connect()
        made = [(v.x, v.y) for id_, v in it.floor.vertices.items() if id_ not in "12"]
        assert made == [pytest.approx(place, abs=0.5) for place in ((4.0, 6.0), (8.0, 6.0), (8.0, 9.0))]
        ids = [*it.floor.vertices, *it.floor.edges, *(e.reverse_id for e in it.floor.edges.values())]
        assert sorted(ids) == ["", "0", *"123456789"]  # one counter for all
        assert [(e.start, e.end) for e in it.floor.edges.values()][-2:] == [("3", "4"), ("4", "7")]
        it.editor.undo()
        assert "7" not in it.floor.vertices and it.mode.selected == ""


async def test_ways_join_vertices_once_and_say_what_is_missing() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.drawing.connect()
        assert "select the vertex" in it.desk.notices.text
        select(it, "1")
        it.drawing.connect()
        assert "move the cursor" in it.desk.notices.text
        store = it.floor.vertices["2"]
        it.at((store.x, store.y))
        edges = len(it.floor.edges)
        it.drawing.connect()
        assert len(it.floor.edges) == edges
        assert "joins them already" in it.desk.notices.text


async def test_no_vertex_is_put_where_one_is() -> None:
    """The cursor is in the next cell, and in line with a vertex in both directions is where the vertex is."""
    async with drawn_graph() as it:
        it.editor.start()
        scene, store = it.picture.scene, it.floor.vertices["2"]
        assert scene is not None
        aside = 0.4 * cell_metres(it.picture.viewport, scene)
        for x, y in product((store.x - aside, store.x + aside), (store.y - aside, store.y + aside)):
            it.at((x, y))
            it.drawing.add_at_cursor()
            select(it, "1")
            it.at((x, y))
            it.drawing.connect()
            it.drawing.hold()
            it.at((x, y))
            it.drawing.select()
            if it.mode.held:
                it.editor.leave()
        places = [(vertex.x, vertex.y) for vertex in it.floor.vertices.values()]
        assert len(set(places)) == len(places)


async def test_a_vertex_is_moved_and_escape_puts_it_back() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        select(it, "1")
        before = it.floor.vertices["1"]
        it.drawing.hold()
        it.at((6.0, 3.0))
        it.editor.leave()
        assert it.floor.vertices["1"] == before
        it.drawing.hold()
        it.drawing.select()
        assert it.floor.vertices["1"] != before and not it.mode.held


async def test_a_vertex_and_an_edge_are_removed_and_an_edge_turns() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        one, two = it.floor.vertices["1"], it.floor.vertices["2"]
        it.at(((one.x + two.x) / 2, (one.y + two.y) / 2))
        it.drawing.turn()
        (edge,) = it.floor.edges.values()
        assert not edge.two_way
        it.drawing.remove()
        assert not it.floor.edges
        select(it, "2")
        it.drawing.remove()
        assert list(it.floor.vertices) == ["1"]


async def test_enter_selects_and_again_opens_the_menu() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        select(it, "1")
        it.drawing.select()
        (menu,) = it.desk.menus
        assert "Base" in menu.title and "Label (n)" in menu.texts
        menu.choose("Type")
        assert "none" in it.desk.menus[1].texts
        it.at((30.0, 30.0))
        it.drawing.select()
        assert "nothing here" in it.desk.notices.text


async def test_a_vertex_is_placed_at_the_robot_with_its_heading_but_not_at_an_old_pose() -> None:
    state = reduced(ready(), pose(T0 + 0.5, 3.0, 4.0), tick(T0 + 0.6))
    async with drawn_graph(state=state) as it:
        it.editor.start()
        it.drawing.add_at_robot()
        made = it.floor.vertices["3"]
        assert (made.x, made.y, made.heading) == (3.0, 4.0, Pose(0, 0).yaw)
    async with drawn_graph(state=reduced(state, tick(T0 + 3))) as it:
        it.editor.start()
        it.drawing.add_at_robot()
        assert "3" not in it.floor.vertices and "old" in it.desk.notices.text


async def test_two_vertices_in_one_cell_need_a_closer_look() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        select(it, "1")
        it.drawing.add_at_cursor()
        assert list(it.floor.vertices) == ["1", "2"] and "zoom in" in it.desk.notices.text

"""Values of vertices in the graph editor: typed, or chosen."""

import math

import pytest

from tests.support.drawn_graph import drawn_graph


async def test_a_label_a_type_and_a_heading_are_typed() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.mode.selected = "1"
        it.values.name()
        assert it.desk.begun == ["name Base"]
        it.typed("name Dock 7")
        it.typed("type docking_station")
        it.typed("heading 450")
        vertex = it.floor.vertices["1"]
        assert (vertex.label, vertex.type) == ("Dock 7", "docking_station")
        assert vertex.heading == pytest.approx(math.pi / 2)
        it.typed("heading any")
        it.typed("name")
        assert (it.floor.vertices["1"].heading, it.floor.vertices["1"].label) == (None, "")
        wrong = it.values.typed("heading north")
        assert wrong is not None and "degrees" in wrong.problem
        assert it.values.typed("robot_0 Base > Store") is None


async def test_types_in_use_are_offered_else_usual_ones() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.values.choose_type()
        assert "no vertex is selected" in it.desk.notices.text
        it.mode.selected = "1"
        it.values.choose_type()
        assert it.desk.menus[0].texts == ["none", "docking_station", "elevator", "another one: type it"]
        it.typed("type shelf")
        it.values.choose_type()
        assert it.desk.menus[1].texts == ["none", "shelf", "another one: type it"]
        it.desk.menus[1].choose("none")
        assert it.floor.vertices["1"].type == ""

"""Speed and cost of edges in the graph editor: typed, undone, and offered in the menu of an edge."""

import pytest

from fleet_tui.features.graphs.edge_values import values_text
from tests.support.drawn_graph import DrawnGraph, drawn_graph


def only_edge(it: DrawnGraph) -> str:
    (id_,) = it.floor.edges
    return id_


async def test_speed_and_cost_are_typed_and_undone() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        id_ = it.mode.edge = only_edge(it)
        assert values_text(it.floor.edges[id_]) == "speed any, cost any"
        it.typed("speed 0.5")
        it.typed("cost 2")
        it.typed("cost 0")
        assert values_text(it.floor.edges[id_]) == "speed 0.5 m/s, cost 0"
        it.editor.undo()
        assert (it.floor.edges[id_].speed, it.floor.edges[id_].cost) == (0.5, 2.0)
        it.typed("speed any")
        it.typed("cost")
        assert (it.floor.edges[id_].speed, it.floor.edges[id_].cost) == (None, None)


@pytest.mark.parametrize("line", ["speed 0", "speed -1", "speed fast", "speed nan", "speed inf", "cost -0.1"])
async def test_what_no_edge_can_have_is_refused(line: str) -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.mode.edge = only_edge(it)
        typed = it.edge_values.typed(line)
        assert typed is not None and typed.problem.endswith(", or: any") and not typed.entries


async def test_it_is_the_edge_at_the_cursor_else_none() -> None:
    async with drawn_graph() as it:
        assert it.edge_values.typed("speed 1") is None
        it.editor.start()
        assert it.edge_values.typed("robot_0 Base > Store") is None
        one, two = it.floor.vertices["1"], it.floor.vertices["2"]
        it.at((30.0, 30.0))
        it.typed("speed 1")
        assert "no edge is selected" in it.desk.notices.text
        it.at(((one.x + two.x) / 2, (one.y + two.y) / 2))
        it.typed("speed 1")
        assert it.floor.edges[only_edge(it)].speed == 1.0 and it.mode.edge == only_edge(it)


async def test_the_menu_of_an_edge_tells_and_begins_them() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        one, two = it.floor.vertices["1"], it.floor.vertices["2"]
        it.at(((one.x + two.x) / 2, (one.y + two.y) / 2))
        it.typed("cost 3")
        it.drawing.select()
        (menu,) = it.desk.menus
        assert menu.title.endswith("both ways, speed any, cost 3")
        menu.choose("Speed")
        menu.choose("Cost")
        assert it.desk.begun == ["speed ", "cost "]

"""Checks of a draft: live counts, lists that lead to the place."""

from collections.abc import Callable
from typing import Any

from fleet_tui.features.graphs.checks import DraftChecks, counts_text, short_counts
from fleet_tui.features.graphs.rules.finding import GraphFinding
from fleet_tui.text.language import EMPTY
from tests.support.drawn_graph import DrawnGraph, drawn_graph


def found_in(it: DrawnGraph) -> tuple[GraphFinding, ...]:
    checked = it.checks.of(it.floor)
    assert checked is not None
    return checked.found


async def test_the_counts_are_in_the_banner_after_each_step_and_each_finding_leads_to_its_place() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        assert not any(one.is_error for one in found_in(it))
        it.mode.selected = "2"
        it.typed("name Base")
        assert " 1E" in it.mode.banner(it.floor.name)
        it.checks.show_findings()
        (menu,) = it.desk.menus
        assert menu.title.startswith("1 error") and "labels reachable" in menu.title
        it.at((9.0, 9.0))
        menu.choose("error: ")
        assert it.mode.selected in ("1", "2")
        where = it.floor.vertices[it.mode.selected]
        assert it.mode.cursor == (where.x, where.y)
        it.editor.undo()
        assert " 1E" not in it.mode.banner(it.floor.name)


async def test_the_difference_from_the_live_graph_is_listed_by_id() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.checks.compare()
        assert it.desk.menus[0].title == "0 differences from the live graph"
        it.mode.selected = "2"
        it.typed("name Dock")
        it.at((30.0, 7.0))
        it.drawing.add_at_cursor()
        it.checks.compare()
        assert it.desk.menus[1].texts == ['relabelled vertex 2: "Store" -> "Dock"', "added vertex 3"]
        it.desk.menus[1].choose("added")
        assert it.mode.selected == "3"
        it.editor.undo()
        it.desk.menus[1].choose("added")
        assert "no longer in the draft" in it.desk.notices.text


async def test_an_order_that_names_a_removed_vertex_is_an_error() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        it.mode.selected = "2"
        it.drawing.remove()
        assert any("order 1 of robot_0" in one.text and one.is_error for one in found_in(it))


async def test_one_check_runs_at_a_time_and_the_newest_draft_is_checked_after_it() -> None:
    waiting = list[tuple[Callable[[], Any], Callable[[Any], None]]]()
    async with drawn_graph() as it:
        it.desk.in_background = lambda work, then: waiting.append((work, then))
        checks = DraftChecks(it.console, it.editor)
        it.editor.start()
        it.mode.selected = "2"
        it.typed("name Base")
        it.typed("name Base ")
        assert len(waiting) == 1
        assert checks.of(it.floor) is None and "being checked" in it.desk.notices.text
        while waiting:
            work, then = waiting.pop()
            then(work())
        last = checks.of(it.floor)
        assert last is not None and "1 error" in counts_text(last.found)
        it.editor.leave()
        it.editor.leave()
        assert not it.editor.is_open and not waiting


def test_counts_are_words() -> None:
    error, warning = GraphFinding("a", EMPTY, True), GraphFinding("b", EMPTY, False)
    assert counts_text((error, warning, warning)) == "1 error, 2 warnings"
    assert counts_text(()) == ""
    assert short_counts((error, warning, warning)) == "1E 2W" and short_counts((warning,)) == "1W"

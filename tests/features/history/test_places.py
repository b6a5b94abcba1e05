"""Blocked places on the map of the terminal."""

from fleet_tui.features.history.places import heat_rows, near, places_table
from fleet_tui.model.history.totals import BlockedPlace
from fleet_tui.ui.view.map.layers import MapOptions
from fleet_tui.ui.view.selection import Selection
from tests.support.fleets import F0, R0, T0, fleet, graph, labels, link_up, pose, reduced, text_of

STATE = reduced(fleet(), link_up(T0), graph(1, 2, 3), labels({1: "Base", 3: "Store"}), pose(T0))
BASE = STATE.robots[R0].maps[F0].graph.vertices["1"]  # type: ignore[union-attr]  # the line above sent it
SELECTION = Selection(R0, F0)
PLACES = [
    BlockedPlace(F0, BASE.x + 0.5, BASE.y, 400.0),
    BlockedPlace(F0, BASE.x + 900.0, BASE.y, 100.0),
    BlockedPlace(F0, BASE.x, BASE.y, 2.0),
]


def test_a_place_is_named_after_a_vertex_nearby() -> None:
    assert near(STATE, PLACES[0]) == "Base" and near(STATE, PLACES[1]) == ""
    assert near(STATE, BlockedPlace("elsewhere", 0.0, 0.0, 9.0)) == ""


def test_the_worst_are_on_the_map_and_listed_beside_it() -> None:
    rows = heat_rows(STATE, SELECTION, PLACES, MapOptions(), (100, 20), is_ascii=False)
    text = "\n".join(text_of(row.runs) for row in rows)
    assert len(rows) == 20 and "●" in text
    assert "8 min blocked here" in text and "6 min" in text and "Base (" in text and "2 s" not in text
    plain = heat_rows(STATE, SELECTION, PLACES, MapOptions(), (100, 20), is_ascii=True)
    assert "@" in "".join(text_of(row.runs) for row in plain)


def test_the_title_names_other_floors_and_an_empty_page_says_so() -> None:
    other = BlockedPlace("floor_9", 0.0, 0.0, 9.0)
    assert text_of(places_table([], SELECTION, [*PLACES, other], "").title).endswith(
        f"{F0}; also on floor_9: f goes there"
    )
    assert places_table([], SELECTION, [], "no robot was blocked").empty == "no robot was blocked"

"""Sites of the site editor: anchors, lanes and locations of levels become a graph; the rest is counted."""

import json
from typing import Any

import pytest

from fleet_tui.maps.formats.graph_file import GraphFile
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import read_text


def level(name: str, anchors: dict[str, list[Any]], **more: Any) -> dict[str, Any]:
    placed = {id_: {"Translate2D": place} for id_, place in anchors.items()}
    return {"properties": {"name": name, "elevation": 0.0}, "anchors": placed, **more}


def site(lanes: dict[str, Any], locations: dict[str, Any] | None = None) -> GraphFile:
    levels = {
        "1": level(
            "L1", {"8": [10.5, -4.7], "9": [15.4, -4.7], "10": [0.0, 0.0]}, walls={"40": {}, "41": {}}
        ),
        "2": level("L2", {"11": [10.5, -4.7]}),
    }
    guided = {"graphs": {"20": {"name": "g"}}, "lanes": lanes, "locations": locations or {}}
    tree = {"format_version": "0.1", "properties": {"name": "hall"}, "levels": levels}
    return read_text(json.dumps({**tree, "lifts": {"50": {}}, "navigation": {"guided": guided}}))


def test_lanes_and_locations_of_a_level_are_its_graph() -> None:
    places = {
        "31": {"anchor": 8, "name": "Dock", "tags": ["Charger"]},
        "32": {"anchor": 9, "name": "<Unnamed>"},
    }
    found = site({"30": {"anchors": [8, 9], "graphs": "All", "forward": {"speed_limit": 0.5}}}, places)
    first, second = found.document.floors.values()
    assert (found.document.name, first.name, second.vertices) == ("hall", "L1", {})
    dock, other = first.vertices["8"], first.vertices["9"]
    assert (dock.x, dock.y, dock.label, dock.type) == (10.5, -4.7, "Dock", "charger")
    assert (other.label, other.type) == ("", "")
    (edge,) = first.edges.values()
    assert (edge.start, edge.end, edge.two_way, edge.speed) == ("8", "9", True, 0.5)


def test_a_lane_may_have_no_way_back_and_what_is_not_read_is_counted() -> None:
    found = site(
        {
            "30": {"anchors": [8, 9], "reverse": "Disable"},
            "33": {"anchors": [8, 11]},
            "34": {"anchors": [8, 99]},
        }
    )
    assert [edge.two_way for edge in found.document.floors["L1"].edges.values()] == [False]
    assert found.left_out == {"walls": 2, "lifts": 1, "lanes between levels or to unknown anchors": 2}


@pytest.mark.parametrize("place", [["1", "2"], [1.0, 2.0]])
def test_places_may_be_written_as_text(place: list[Any]) -> None:
    tree = {"format_version": "0.1", "levels": {"1": level("L", {"8": place, "9": [0, 0]})}}
    found = read_text(json.dumps({**tree, "navigation": {"guided": {"lanes": {"1": {"anchors": [8, 9]}}}}}))
    assert found.document.floors["L"].vertices["8"].x == 1.0


def test_ids_are_the_keys_and_the_first_location_of_a_place_counts() -> None:
    lanes = {"30": {"id": 5, "anchors": [8, 9]}, "33": {"id": 5, "anchors": [9, 10]}}
    places = {"1": {"anchor": 8, "name": "A", "tags": ["Charger"]}, "2": {"anchor": 8, "name": "B"}}
    floor = site(lanes, places).document.floors["L1"]
    assert [*floor.edges] == ["30", "33"] and floor.vertices["8"].label == "A"


def test_what_is_no_place_is_named() -> None:
    tree = {"format_version": "0.1", "levels": {"1": level("L", {"8": [None, 1.0]})}}
    with pytest.raises(GraphError, match="level L anchor 8: nothing instead of a number"):
        read_text(json.dumps(tree))

"""Buildings of the traffic editor: pixels become metres."""

import math

import pytest
from pytest import approx

from fleet_tui.maps.formats.graph_file import MissingChoiceError
from fleet_tui.model.graphs.document import GraphFormat, Motion
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import SHARED, read_text

LEVEL = """
    vertices:
      - [0, 0, 0, ""]
      - [100, 0, 0, 007, {is_charger: [4, true]}]
      - [100, 200, 0, yes, {lift_cabin: [1, A]}]
      - [50, 50, 0, wall]
      - [10, 20, 0, "", {dock_name: [1, d]}]
    lanes:
      - [1, 2, {bidirectional: [4, true], speed_limit: [3, 0.5], orientation: [1, forward]}]
      - [2, 4, {bidirectional: [4, false], graph_idx: [2, 3], speed_limit: [3, 0]}]
    measurements:
      - [0, 1, {distance: [3, 10]}]
      - [0, 1, {distance: [3, 30]}]
    fiducials: [[0, 0, p], [100, 0, q]]
    walls: [[0, 3, {}]]
"""
TEXT = f"name: b\nlevels:\n  L1:{LEVEL}"


def test_one_graph_of_several() -> None:
    found = read_text(TEXT, building_graph=0)
    floor = found.document.floors["L1"]
    assert (found.format, found.left_out) == (GraphFormat.RMF_BUILDING, {"walls": 1, "measurements": 2})
    assert [(one.id, one.x, one.y, one.label, one.type) for one in floor.vertices.values()] == [
        ("1", 20.0, 0.0, "007", "charger"),
        ("2", 20.0, -40.0, "yes", "lift"),
    ]
    (edge,) = floor.edges.values()
    assert (edge.two_way, edge.speed, edge.motion) == (True, 0.5, Motion.FORWARD)
    other = read_text(TEXT, building_graph=3).document.floors["L1"]
    assert [(one.id, one.type) for one in other.vertices.values()] == [("2", "lift"), ("4", "dock")]
    assert [(one.two_way, one.speed) for one in other.edges.values()] == [(False, None)]


def test_the_graph_is_to_be_chosen() -> None:
    with pytest.raises(MissingChoiceError, match="graphs 0, 3: choose one") as missing:
        read_text(TEXT)
    assert (missing.value.option, missing.value.choices) == ("--building-graph", ("0", "3"))
    with pytest.raises(GraphError, match="no graph 5 in the building: it has 0, 3"):
        read_text(TEXT, building_graph=5)


def test_other_levels_are_placed_by_their_fiducials() -> None:
    upper = """
    vertices: [[10, 10, 0, a], [10, -40, 0, b]]
    lanes: [[0, 1, {}]]
    fiducials: [[10, 10, p], [10, -40, q], [5, 5, other]]
"""
    text = f"{TEXT}  L2:{upper}lifts: {{A: {{x: 100, y: 200, yaw: 0.5, width: 2, depth: 1}}}}\n"
    document = read_text(text, building_graph=0).document
    places = [(one.x, one.y) for one in document.floors["L2"].vertices.values()]
    # The fiducials are at the reference level's (0, 0) and (100, 0) pixels of 0.2 m.
    assert places == [approx((0.0, 0.0)), approx((20.0, 0.0))]
    (lift,) = document.lifts
    assert (lift.stops, lift.x, lift.y, lift.size) == ((("L1", "2"),), 20.0, -40.0, (2.0, 1.0))


def test_metres_are_not_turned_over_and_pixels_pass_as_metres() -> None:
    level = "levels: {L: {vertices: [[1, 2, 0, a], [3, 4, 0, b]], lanes: [[0, 1, {}]]}}"
    found = read_text(f"coordinate_system: cartesian_meters\n{level}")
    assert [one.y for one in found.document.floors["L"].vertices.values()] == [2.0, 4.0] and found.notes == ()
    found = read_text(f"coordinate_system: reference_image\n{level}")
    assert [one.y for one in found.document.floors["L"].vertices.values()] == [-2.0, -4.0]
    assert found.notes == ("level L: no measurement, so a pixel passes as a metre",)


@pytest.mark.parametrize(
    ("level", "problem"),
    [
        ("{vertices: [[0]], measurements: [[0, 0, {}]]}", "level L vertex 0|must begin|measurement 0"),
        (
            "{vertices: [[0, 0]], measurements: [[0, 0, {distance: [3, 1]}]]}",
            "1 m over 0 pixels gives no scale",
        ),
        ("{vertices: [[0, 0]], lanes: [[0, 7, {}]]}", "level L lane 0: unknown vertex 7"),
        ("{vertices: [[0, 0]], lanes: [[0, 0, {a: [1]}]]}", "level L lane 0 a: must be \\[type, value\\]"),
        ("{vertices: [[0, 0]], lanes: [[0]]}", "level L lane 0: must be a list of three parts"),
        ("{vertices: 7}", "level L vertices: 7 instead of a list"),
    ],
)
def test_faults_are_named(level: str, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        read_text(f"levels: {{L: {level}}}", GraphFormat.RMF_BUILDING)


@pytest.mark.skipif(not SHARED.is_dir(), reason="samples lie beside the repository only where it was built")
def test_the_office() -> None:
    text = (SHARED / "graphs" / "office.building.yaml").read_text()
    floor = read_text(text).document.floors["L1"]
    assert (len(floor.vertices), len(floor.edges)) == (29, 30)
    assert "tinyRobot1_charger" in floor.labels.values()
    assert all(one.y < 0 and math.isfinite(one.x) for one in floor.vertices.values())


@pytest.mark.parametrize("system", ["wgs84", "web_mercator"])
def test_places_on_earth_are_no_metres_of_a_floor(system: str) -> None:
    with pytest.raises(GraphError, match=f"coordinate_system {system}: no metres of a floor"):
        read_text(f"coordinate_system: {system}\nlevels:\n  L:\n    vertices: [[13.4, 52.5, 0, a]]\n")


@pytest.mark.parametrize(
    ("parts", "label"),
    [
        ("[0, 0, 0.5, B]", "B"),
        ("[0, 0, 0.5, {is_charger: [4, true]}]", ""),
        ("[0, 0, {is_charger: [4, true]}]", ""),
        ("[0, 0, '7']", "7"),
        ("[0, 0, 0.5, 7]", "7"),
        ("[0, 0]", ""),
    ],
)
def test_a_height_is_no_label(parts: str, label: str) -> None:
    text = f"coordinate_system: cartesian_meters\nlevels:\n  L:\n    vertices: [{parts}, [1, 0, b]]\n"
    floor = read_text(f"{text}    lanes: [[0, 1]]\n").document.floors["L"]
    assert floor.vertices["0"].label == label


def test_parameters_may_have_no_types() -> None:
    text = "coordinate_system: cartesian_meters\nlevels:\n  L:\n"
    text += (
        "    vertices: [[0, 0, a, {is_charger: true}], [1, 0, b]]\n    lanes: [[0, 1, {speed_limit: 0.5}]]\n"
    )
    floor = read_text(text).document.floors["L"]
    charger = floor.vertices["0"]
    assert (charger.label, charger.type, floor.edges["0"].speed) == ("a", "charger", 0.5)

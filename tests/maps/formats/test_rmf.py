"""Navigation graphs of Open-RMF, and a checker of the rules of parse_graph."""

import json
import math
from typing import Any

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.graphs.document import (
    DocumentEdge,
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Lift,
    Motion,
    of_floor,
)
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import NAMES, NUMBERS, SHARED, TABLES, again, read_text, sample, write_text

F = GraphFormat.RMF
FLAGS = ("is_charger", "is_parking_spot", "is_holding_point", "is_passthrough_point")


def check(text: str) -> dict[str, Any]:
    """The rules by which RMF refuses a file."""
    found: dict[str, Any] = yaml.safe_load(text)
    names = list[str]()
    for level in found["levels"].values():
        vertices, lanes = level["vertices"], level["lanes"]
        for x, y, options in vertices:
            assert type(x) is float and type(y) is float and isinstance(options, dict)
            assert isinstance(options["name"], str)
            assert all(type(options[flag]) is bool for flag in FLAGS if flag in options)
            names += [options["name"]] if options["name"] else []
            assert not found["lifts"] or "lift" not in options or options["lift"] in found["lifts"]
        for start, end, options in lanes:
            assert 0 <= start < len(vertices) and 0 <= end < len(vertices) and isinstance(options, dict)
            assert options.get("speed_limit", 1.0) > 0
    assert len(set(names)) == len(names)
    return found


OPTIONS = st.builds(
    lambda more, flags, name: {**more, **flags, **({"name": name} if name else {})},
    TABLES,
    st.dictionaries(st.sampled_from(FLAGS), st.booleans(), max_size=2),
    st.just("") | NAMES,
)


@given(st.lists(st.tuples(NUMBERS, NUMBERS, OPTIONS), min_size=2, max_size=4), TABLES, st.floats(0.1, 2.0))
def test_nothing_of_a_file_is_lost(vertices: list[Any], more: dict[str, Any], speed: float) -> None:
    lanes = [[0, 1, more], [1, 0, more], [1, 1, {"speed_limit": speed, **more}], [0, 1, {}]]
    lanes += [[1, 0, {"orientation_constraint": "forward", "door_name": "d"}]]
    level = {"vertices": [list(one) for one in vertices], "lanes": lanes, "extra_key": more}
    tree = {"building_name": "b", "levels": {"L 1": level}, "lifts": {}, **more}
    text = json.dumps(tree)
    document = read_text(text, F).document
    written = read_yaml(write_text(document, F))
    for one in level["vertices"]:
        one[2].setdefault("name", "")
    assert written == tree
    assert again(document, F) == document


def read_yaml(text: str) -> Any:
    """The values of a file, as another parser reads them."""
    return yaml.safe_load(text)


def test_flags_and_types() -> None:
    text = """
levels:
  L1:
    vertices:
      - [0, 1, {name: 007, is_charger: true, is_parking_spot: true}]
      - [2, 3, {name: yes, is_holding_point: true, is_charger: false}]
      - [4, 5, {lift: A}]
      - [4, 5]
    lanes: [[0, 1, {speed_limit: 0}], [1, 0, {speed_limit: 0.0, dock_name: d}], [1, 2]]
lifts:
  A: {position: [4, 5, 0.5], dims: [2, 1], doors: 1}
"""
    document = read_text(text).document
    floor = document.floors["L1"]
    assert [(one.label, one.type) for one in floor.vertices.values()] == [
        ("007", "charger"),
        ("yes", "holding_point"),
        ("", "lift"),
        ("", ""),
    ]
    assert document.lifts == (Lift("A", (("L1", "2"),), 4.0, 5.0, 0.5, (2.0, 1.0), {"rmf": {"doors": 1}}),)
    assert [(one.two_way, one.speed) for one in floor.edges.values()] == [(False, None)] * 3
    check(write_text(document, F))
    changed = DocumentVertex("0", 0.0, 0.0, "a", "parking_spot", extra={"rmf": {"is_charger": True, "w": 1}})
    options = check(write_text(of_floor(DocumentFloor("f", {"0": changed})), F))["levels"]["f"]["vertices"][
        0
    ][2]
    assert options == {"name": "a", "w": 1, "is_parking_spot": True}


def test_all_floors_in_one_frame_and_lifts_in_the_table() -> None:
    upper = DocumentFloor(
        "upper",
        {"5": DocumentVertex("5", 1.0, 0.0)},
        {"1": DocumentEdge("1", "5", "5")},
        to_site=(10.0, 0.0, math.pi / 2),
    )
    document = sample().with_floor(upper)
    lifts = (Lift("A", (("ground", "2"), ("upper", "5")), size=(1.0, 2.0)), Lift("B", (("ground", "7"),)))
    found = check(write_text(GraphDocument("s", document.floors, lifts), F))
    x, y, options = found["levels"]["upper"]["vertices"][0]
    assert (round(x, 9), round(y, 9), options) == (10.0, 1.0, {"name": "", "lift": "A"})
    assert set(found["lifts"]) == {"A", "B"}
    assert found["levels"]["ground"]["lanes"][:2] == [
        [0, 1, {"speed_limit": 0.5}],
        [1, 0, {"speed_limit": 0.5}],
    ]
    assert found["levels"]["ground"]["lanes"][2] == [1, 2, {"orientation_constraint": "backward"}]


def test_lane_indices_begin_at_0_in_each_level() -> None:
    level = "{vertices: [[0, 0, {}], [1, 1, {}]], lanes: [[0, 1, {}]]}"
    document = read_text(f"levels: {{a: {level}, b: {level}}}").document
    assert [list(floor.edges) for floor in document.floors.values()] == [["0"], ["0"]]
    assert document.floors["b"].edges["0"].motion is Motion.ANY


@pytest.mark.parametrize(
    ("level", "problem"),
    [
        (
            "{vertices: [[0, 0, {}]], lanes: [[0, 1, {}]]}",
            "level L lane 0: unknown vertex 1, the last one is 0",
        ),
        ("{vertices: [[0, 0, {}]], lanes: [[0, -1, {}]]}", "lane 0: unknown vertex -1"),
        ("{vertices: [[0, 0, {}]], lanes: [[0, x, {}]]}", "lane 0: 'x' instead of a whole number"),
        ("{vertices: [[0]]}", "level L vertex 0: must be a list of three parts"),
        ("{vertices: [[0, a, {}]]}", "level L vertex 0: 'a' instead of a number"),
        ("{vertices: [[0, 1, {name: [a]}]]}", "vertex 0 name: a list instead of text"),
        ("{vertices: 7}", "level L vertices: 7 instead of a list"),
        ("7", "level L: 7 instead of a mapping"),
        ("{vertices: [[0, 0, {}], [0, 0, {}]], lanes: [[0]]}", "lane 0: must be a list of three parts"),
    ],
)
def test_faults_are_named(level: str, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        read_text(f"levels: {{L: {level}}}", F)


@pytest.mark.skipif(not SHARED.is_dir(), reason="samples lie beside the repository only where it was built")
def test_the_sample_of_rmf() -> None:
    text = (SHARED / "graphs" / "office_nav.yaml").read_text()
    before, after = yaml.safe_load(text), check(write_text(read_text(text).document, F))
    levels, changed = before["levels"]["L1"], after["levels"]["L1"]
    assert changed["lanes"] == levels["lanes"]
    assert changed["vertices"] == [[x, y, {"name": "", **options}] for x, y, options in levels["vertices"]]

"""All rules together."""

import numpy as np
from msgspec.structs import replace

from fleet_tui.features.graphs.rules.finding import LintInputs
from fleet_tui.features.graphs.rules.lint import lint
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.graphs.document import (
    DocumentFloor,
    DocumentVertex,
    GraphDocument,
    GraphFormat,
    Lift,
    Station,
    of_floor,
)
from fleet_tui.model.occupancy import FREE, build_grid
from tests.support.graph_files import line_graph, sample


def test_errors_come_first() -> None:
    floor = line_graph((0.0, 0.0), (0.05, 0.0), (float("nan"), 0.0)).floors["f"]
    found = lint(of_floor(floor), LintInputs())
    assert [one.rule for one in found] == ["place", "close vertices", "docking"]
    assert found[0].is_error and found[0].floor == "f" and found[0].vertices == ("3",)


def test_the_sample() -> None:
    found = lint(sample(), LintInputs(target=GraphFormat.NATIVE))
    assert [one.text for one in found] == [
        "vertex 0 (Base): robots read a missing id as 0, that is as this vertex",
        "vertex 2 (yes): a dead end, no way back to the others",
    ]


def test_elevators_and_docking_count_for_the_site() -> None:
    dock, lift = DocumentVertex("1", 0.0, 0.0, "D", "dock"), DocumentVertex("2", 5.0, 0.0, "Up", "lift")
    floors = {
        "a": DocumentFloor("a", {"1": dock, "2": lift}),
        "b": DocumentFloor("b", {"2": lift}),
        "c": DocumentFloor("c", {"2": DocumentVertex("2", 0.0, 0.0, "Other", "lift")}),
    }
    found = lint(GraphDocument("s", floors), LintInputs())
    assert [(one.floor, one.rule) for one in found if one.rule != "reach"] == [("c", "elevator")]
    lifts = (Lift("A", (("a", "2"), ("c", "2"))),)
    assert not any(one.rule == "elevator" for one in lint(GraphDocument("s", floors, lifts), LintInputs()))
    assert [one.rule for one in lint(GraphDocument(), LintInputs())] == ["empty"]


def test_with_a_map() -> None:
    grid = build_grid(MapFrame(0.05, 40, 40), np.full((40, 40), FREE, np.uint8))
    found = lint(line_graph((1.0, 1.0), (5.0, 1.0)), LintInputs(grid))
    assert [one.text for one in found if one.rule == "place"] == ["vertex 2: (5.00, 1.00) m is off the map"]
    assert any(one.rule == "no room" for one in found)


def test_stops_at_nothing_are_found() -> None:
    document = of_floor(DocumentFloor("f", {"1": DocumentVertex("1", 0.0, 0.0)}))
    lift = Lift("L", (("f", "1"), ("f", "9"), ("g", "1")))
    found = lint(replace(document, lifts=(lift,), stations=(Station("S", (("f", "8"),)),)), LintInputs())
    assert [one.text for one in found if one.rule == "stop" and one.is_error] == [
        "lift L: stops at unknown vertex 9 on f",
        "lift L: stops on unknown floor g",
        "station S: stops at unknown vertex 8 on f",
    ]

"""Orders that may not be meant: over a closed edge, or far on a nearly flat battery."""

import pytest
from msgspec.structs import replace

from fleet_tui.commands.routes.doubts import doubts
from fleet_tui.model.desk.desk import ends_of
from fleet_tui.model.desk.events import EdgeClosed
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Role
from fleet_tui.model.request import Request
from tests.support.fleets import F0, R0, T0, battery, place_order, pose, reduced, tick
from tests.support.street import fleet_with, street


def doubted(state: FleetState, *vertices: int) -> list[str]:
    """What is asked before an order along the street."""
    return [problem.text for problem in doubts(state, Request((place_order(R0, *vertices),)))]


def at_1(percent: float, *more: Event) -> FleetState:
    return reduced(fleet_with(pose(T0 + 1), battery(T0 + 1, percent), *more), tick(T0 + 2))


@pytest.mark.parametrize(
    ("percent", "stops", "asked"),
    [
        (6.9, (1, 5), ["battery of robot_0: 6 %, for 30 m"]),
        (6.9, (3, 5), ["battery of robot_0: 6 %, for 20 m"]),
        (6.9, (1, 2), []),
        (6.9, (2, 4), []),
        (12.0, (1, 5), []),
    ],
)
def test_a_far_order_on_a_nearly_flat_battery_is_asked_about_with_the_way_to_its_start(
    percent: float, stops: tuple[int, int], asked: list[str]
) -> None:
    assert doubted(at_1(percent), *stops) == asked


def test_an_order_to_a_charger_is_meant() -> None:
    drawn = street(R0)
    dock = replace(drawn.graph.vertices["5"], role=Role.DOCKING)
    docks = replace(drawn, graph=replace(drawn.graph, vertices={**drawn.graph.vertices, "5": dock}))
    assert doubted(at_1(6.9, docks), 1, 5) == []


def test_an_old_battery_report_is_no_doubt() -> None:
    assert doubted(reduced(at_1(6.9), pose(T0 + 900), tick(T0 + 900)), 1, 5) == []


def test_a_closed_edge_on_the_way_is_asked_about() -> None:
    state = reduced(at_1(80.0), EdgeClosed(ends_of(F0, "2", "3"), T0 + 2))
    assert doubted(state, 1, 5) == ["the way of robot_0 is closed: 2 - 3"]
    assert doubted(state, 1, 2) == []

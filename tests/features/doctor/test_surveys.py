"""Floors as robots report them: equal reports share one, and what lies at a place of the map."""

import numpy as np
from msgspec.structs import replace

from fleet_tui.features.doctor.surveys import OFF_MAP, FloorSurvey, class_at, live_grid, surveys_of
from fleet_tui.links.discovery.facts import TopicFacts, key_of
from fleet_tui.model.events import Event, FrameReceived, GridReceived
from fleet_tui.model.geometry import MapFrame, Pose
from fleet_tui.model.occupancy import FREE, OCCUPIED, UNKNOWN, build_grid
from fleet_tui.robots.adapter import Feed
from tests.support.fleets import F0, R0, T0, battery, graph, labels

FRAME = MapFrame(0.5, 2, 2, Pose(-1.0, 3.0))
GRID = build_grid(FRAME, np.array([[FREE, OCCUPIED], [UNKNOWN, FREE]], np.uint8))


def received(event: Event | None, robot: str = R0, floor: str = F0) -> TopicFacts:
    return TopicFacts(Feed("", (robot,), floor, "", ""), event=event)


def test_robots_with_equal_reports_share_one() -> None:
    topics = [
        received(fact)
        for fact in (graph(1, 2), labels({1: "Base"}), FrameReceived(R0, F0, FRAME), battery(T0), None)
    ]
    topics += [received(graph(1, 2, robot="robot_1"), "robot_1"), received(labels({1: "Base"}), "robot_1")]
    topics += [received(FrameReceived("robot_1", F0, FRAME), "robot_1"), received(graph(1), "robot_2")]
    topics += [received(graph(7), floor="floor_1")]
    (both, robots), (other, alone) = surveys_of(F0, topics)
    assert robots == [R0, "robot_1"] and alone == ["robot_2"]
    assert both == FloorSurvey(graph(1, 2).graph, {"1": "Base"}, FRAME)
    assert (other.graph, other.labels, other.frame) == (graph(1).graph, None, None)
    assert (both.name_of("1"), both.name_of("2"), other.name_of("1")) == ("1 (Base)", "2", "1")


def test_one_topic_reports_the_floors_of_all_robots() -> None:
    told: list[Event] = [
        graph(1, 2),
        labels({1: "Base"}),
        graph(3, robot="robot_1"),
        replace(graph(7), floor="floor_1"),
    ]
    shared = Feed("graphs", (R0, "robot_1"), "", "/nav_graphs", "", is_shared=True)
    topics = [TopicFacts(shared, event=told[-1], events={key_of(one): one for one in told})]
    (first, one), (second, other) = surveys_of(F0, topics)
    assert (one, other) == ([R0], ["robot_1"]) and first == FloorSurvey(graph(1, 2).graph, {"1": "Base"})
    assert second.graph == graph(3).graph
    assert [robots for _, robots in surveys_of("floor_1", topics)] == [[R0]]


def test_a_live_map_is_the_first_that_came_of_its_floor() -> None:
    topics = [received(None), received(GridReceived(R0, F0, GRID))]
    assert live_grid(F0, topics) is GRID and live_grid("floor_1", topics) is None


def test_a_place_in_metres_has_the_class_of_its_cell_or_none() -> None:
    places = {(-0.9, 3.6): FREE, (-0.4, 3.9): OCCUPIED, (-0.9, 3.1): UNKNOWN, (-0.4, 3.1): FREE}
    assert {place: class_at(GRID, *place) for place in places} == places
    assert [class_at(GRID, x, y) for x, y in ((-1.1, 3.1), (0.1, 3.1), (-0.9, 2.9), (-0.9, 4.1))] == [
        OFF_MAP
    ] * 4

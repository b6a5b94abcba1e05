"""Floors as robots report them, and the content of a map at a place. Pure."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import assert_never

from fleet_tui.links.discovery.facts import TopicFacts
from fleet_tui.model.events import (
    Event,
    FrameReceived,
    GraphReceived,
    GridReceived,
    LabelsReceived,
    MapFactReceived,
)
from fleet_tui.model.geometry import MapFrame
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.grid import OccupancyGrid

OFF_MAP = 255


@dataclass(frozen=True)
class FloorSurvey:
    """A floor as robots report it; robots with equal reports share one."""

    graph: RouteGraph | None = None
    labels: Mapping[str, str] | None = None
    frame: MapFrame | None = None

    def name_of(self, vertex: str) -> str:
        """Return the name of a vertex for people."""
        label = (self.labels or {}).get(vertex)
        return f"{vertex} ({label})" if label else str(vertex)


def surveys_of(floor: str, topics: list[TopicFacts]) -> list[tuple[FloorSurvey, list[str]]]:
    """Return every different report of a floor, with its robots."""
    found = dict[str, FloorSurvey]()
    for facts in topics:
        if facts.wanted.floor == floor:
            survey = found.get(facts.wanted.robot, FloorSurvey())
            found[facts.wanted.robot] = _with(survey, facts.event)
        for event in facts.events.values() if facts.wanted.is_shared else ():  # one message: all floors
            if isinstance(event, GraphReceived | LabelsReceived) and event.floor == floor:
                found[event.robot] = _with(found.get(event.robot, FloorSurvey()), event)
    surveys = list[tuple[FloorSurvey, list[str]]]()
    for robot, survey in found.items():
        owners = next((robots for other, robots in surveys if other == survey), None)
        if owners is None:
            surveys.append((survey, [robot]))
        else:
            owners.append(robot)
    return surveys


def _with(survey: FloorSurvey, event: Event | None) -> FloorSurvey:
    if not isinstance(event, MapFactReceived):
        return survey
    match event:
        case GraphReceived():
            return replace(survey, graph=event.graph)
        case LabelsReceived():
            return replace(survey, labels=event.labels)
        case FrameReceived():
            return replace(survey, frame=event.frame)
        case GridReceived():
            return survey
        case _:
            assert_never(event)


def live_grid(floor: str, topics: list[TopicFacts]) -> OccupancyGrid | None:
    """Return a live map of a floor, if one arrived."""
    events = [facts.event for facts in topics if facts.wanted.floor == floor]
    events += [facts.events.get(floor) for facts in topics if facts.wanted.has_pictures]
    return next((event.grid for event in events if isinstance(event, GridReceived)), None)


def class_at(grid: OccupancyGrid, x: float, y: float) -> int:
    """Return the class of a map at a place in metres, OFF_MAP beside it."""
    column, row = grid.frame.to_pixel(x, y)
    if not (0 <= column < grid.frame.width and 0 <= row < grid.frame.height):
        return OFF_MAP
    return int(grid.levels[0][int(row), int(column)])

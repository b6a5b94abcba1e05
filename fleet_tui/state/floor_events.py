"""Events of floors: files that were read."""

from typing import assert_never

from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.robot import Robot
from fleet_tui.text.limits import truncate


def apply_to_floor(state: FleetState, event: events.FloorMapLoaded | events.FloorGraphLoaded) -> FleetState:
    """Return the state after an event of a floor."""
    floor = state.floors[event.floor]
    match event:
        case events.FloorMapLoaded():
            floor = replace(floor, grid=event.grid, problem=truncate(event.problem), tied=event.tied)
        case events.FloorGraphLoaded():
            floor = replace(floor, graph_problem=truncate(event.problem))
            graphs = {False: event, True: _by_label(event)}
            robots = {name: _given(one, graphs[one.kind.names_places]) for name, one in state.robots.items()}
            state = replace(state, robots=robots)
        case _:
            assert_never(event)
    return replace(state, floors={**state.floors, floor.name: floor})


def _given(robot: Robot, event: events.FloorGraphLoaded) -> Robot:
    """Return the robot with the graph, if it is on the floor and publishes none itself. All share one
    object."""
    robot_map = robot.maps.get(event.floor)
    if robot_map is None or event.graph is None or "graph" in robot.kind.reports:
        return robot
    robot_map = replace(robot_map, graph=event.graph, labels=event.labels)
    return replace(robot, maps={**robot.maps, event.floor: robot_map})


def _by_label(event: events.FloorGraphLoaded) -> events.FloorGraphLoaded:
    """Return the graph with the labels of its vertices as their ids: their numbers are those of a file, and
    begin again on each floor."""
    if event.graph is None:
        return event
    ids = {id_: event.labels.get(id_, f"#{id_}") for id_ in event.graph.vertices}
    vertices = {ids[id_]: replace(one, id=ids[id_]) for id_, one in event.graph.vertices.items()}
    edges = tuple(replace(one, start=ids[one.start], end=ids[one.end]) for one in event.graph.edges)
    graph = RouteGraph(vertices, edges, event.graph.directed)
    return replace(event, graph=graph, labels={label: label for label in event.labels.values()})

"""Checks of an order against the robot's graphs and floors. A missing graph proves nothing."""

import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import pairwise
from typing import assert_never

from fleet_tui.model import commands
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import Role, RouteGraph
from fleet_tui.model.order import vertices_of
from fleet_tui.model.problem import Problem
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.text.errors import did_you_mean
from fleet_tui.text.language import Message


def _name(robot: Robot, vertex: str) -> str:
    return robot.name_of(vertex) or vertex


def ends_of(command: commands.Command) -> tuple[str, ...]:
    """Return the vertices that an order names."""
    match command:
        case commands.PlaceOrder(_, stops):
            return vertices_of(stops)
        case commands.CancelOrder() | commands.ClearOrders() | commands.PauseRobot() | commands.ResumeRobot():
            return ()
        case SetUpCommand():
            return ()
        case _:
            assert_never(command)


def _legs(command: commands.Command) -> Iterator[tuple[str, str]]:
    """Return the pairs of consecutive vertices of an order."""
    for one, other in pairwise(command.stops if isinstance(command, commands.PlaceOrder) else ()):
        if one.pose is None and other.pose is None:
            yield one.vertex, other.vertex


def unknown_vertex(state: FleetState, robot: Robot, command: commands.Command) -> Iterator[Problem]:
    """Check that the robot's graphs have the vertices. A missing graph proves nothing."""
    missing = [floor for floor, robot_map in robot.maps.items() if robot_map.graph is None]
    for vertex in ends_of(command):
        if robot.name_of(vertex) is not None:
            continue
        if missing and "graph" not in robot.kind.reports:
            text = Message(
                "{name} has no vertex {vertex}: no graph of {missing}",
                name=robot.name,
                vertex=vertex,
                missing=", ".join(missing),
            )
            yield Problem("unknown vertex", text)
        elif missing:
            waits = Message(
                "vertex {vertex} unknown: no graph of {missing} received yet",
                vertex=vertex,
                missing=", ".join(missing),
            )
            yield Problem(
                "unknown vertex", Message("{name}: {waits}", name=robot.name, waits=waits), blocks=False
            )
        else:
            known = [id_ for graph in _graphs(robot).values() for id_ in graph.vertices]
            text = Message(
                "{name} has no vertex {vertex}{did_you_mean}",
                name=robot.name,
                vertex=vertex,
                did_you_mean=did_you_mean(vertex, known),
            )
            yield Problem("unknown vertex", text)


def same_place(state: FleetState, robot: Robot, command: commands.Command) -> Iterator[Problem]:
    """Check that start and end differ."""
    for start, end in _legs(command):
        if start == end:
            yield Problem(
                "same place", Message("From and To are the same place: {name}", name=_name(robot, end))
            )


def _graphs(robot: Robot) -> Mapping[str, RouteGraph]:
    return {floor: robot_map.graph for floor, robot_map in robot.maps.items() if robot_map.graph is not None}


def _floors(robot: Robot, vertex: str) -> set[str]:
    """Return the floors with such a vertex. Ids of different floors may be the same."""
    return {floor for floor, graph in _graphs(robot).items() if vertex in graph.vertices}


def _lifts(graph: RouteGraph) -> list[str]:
    return [vertex.id for vertex in graph.vertices.values() if vertex.role is Role.ELEVATOR]


def _are_joined(graphs: Mapping[str, RouteGraph], start: str, end: str) -> bool:
    """Tell whether a way is known, on one floor or by elevators, which are all assumed to connect."""
    if any(graph.path(start, end) for graph in graphs.values()):
        return True
    lifts = [(graph, lift) for graph in graphs.values() for lift in _lifts(graph)] if len(graphs) > 1 else []
    ways_up = any(graph.path(start, lift) for graph, lift in lifts)
    return ways_up and any(graph.path(lift, end) for graph, lift in lifts)


def _lack_lifts(robot: Robot, floors: Iterable[str]) -> bool:
    """Tell whether one of these floors names no elevator: its exits are not in its graph."""
    return any(not _lifts(_graphs(robot)[floor]) for floor in floors)


def no_path(state: FleetState, robot: Robot, command: commands.Command) -> Iterator[Problem]:
    """Check that the graph leads from one to the other."""
    if not robot.knows_all_graphs():
        return
    for start, end in _legs(command):
        starts, ends = _floors(robot, start), _floors(robot, end)
        unknown = not starts or not ends or (not starts & ends and _lack_lifts(robot, starts | ends))
        if not unknown and not _are_joined(_graphs(robot), start, end):
            names = Message("{start} to {end}", start=_name(robot, start), end=_name(robot, end))
            yield Problem("no path", Message("no path for {name} from {names}", name=robot.name, names=names))


def no_way_there(state: FleetState, robot: Robot, command: commands.Command) -> Iterator[Problem]:
    """Check that the graph leads from the robot to the start of the order."""
    graphs, floor = _graphs(robot), robot.floor or ""
    here = graphs.get(floor)
    if robot.pose is None or not here or not here.vertices or not robot.knows_all_graphs():
        return
    pose = robot.pose.value
    near = min(here.vertices.values(), key=lambda one: math.dist((one.x, one.y), (pose.x, pose.y)))
    for vertex in ends_of(command)[:1]:
        floors = _floors(robot, vertex)
        unknown = not floors or (floor not in floors and _lack_lifts(robot, {floor, *floors}))
        if not unknown and not _are_joined(graphs, near.id, vertex):
            text = Message(
                "no path for {name} from its position to {end}", name=robot.name, end=_name(robot, vertex)
            )
            yield Problem("no path", text, blocks=False)


def floor_mismatch(state: FleetState, robot: Robot, command: commands.Command) -> Iterator[Problem]:
    """Check that the robot and both places are on one floor, or an elevator is known. An unknown floor proves
    nothing."""
    stops = [(robot.name, {floor for floor in _graphs(robot) if floor == robot.floor})]
    stops += [(_name(robot, vertex), _floors(robot, vertex)) for vertex in ends_of(command)]
    for (one, here), (other, there) in pairwise(stops):
        if not here or not there or here & there:
            continue
        where = Message(
            "{one} is on {here}, {other} on {there}", one=one, here=min(here), other=other, there=min(there)
        )
        if not robot.kind.changes_floors:
            yield Problem("floor mismatch", Message("{where}: an order can't change floors", where=where))
        elif _lack_lifts(robot, here | there):
            yield Problem("floor mismatch", Message("{where}, no elevator known", where=where), blocks=False)


def mistakable(robot: Robot, floors: Iterable[tuple[str, str]]) -> Iterator[Problem]:
    """Check for ambiguous ids: an order names a vertex by its id alone, which a robot takes as that of the
    floor it is on, if that has one. `floors`: the ids with the floors that were meant."""
    for vertex, floor in floors:
        others = sorted(_floors(robot, vertex) - {floor})
        if floor not in robot.maps or floor == robot.floor or not others:
            continue
        meant = Message("{name_on} on {floor}", name_on=_name_on(robot, vertex, floor), floor=floor)
        if robot.floor is not None and robot.floor in others:
            taken = Message(
                "{name_on} on {floor}", name_on=_name_on(robot, vertex, robot.floor), floor=robot.floor
            )
            text = Message(
                "{meant} can't be ordered: where {name} is, the id {vertex} is that of {taken}",
                meant=meant,
                name=robot.name,
                vertex=vertex,
                taken=taken,
            )
            yield Problem("floor mismatch", text)
        else:
            text = Message(
                "{meant} has the id {vertex}, as has {others}: the robot decides between them",
                meant=meant,
                vertex=vertex,
                others=others[0],
            )
            yield Problem("floor mismatch", text, blocks=False)


def _name_on(robot: Robot, vertex: str, floor: str) -> str:
    return robot.maps[floor].labels.get(vertex, vertex)

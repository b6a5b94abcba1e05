"""The reducer: each event turns the state into the next one."""

from collections.abc import Sequence
from typing import assert_never

from msgspec.structs import replace

from fleet_tui.commands.routes.blocked import with_blocked_edges
from fleet_tui.model import events, navigation_events
from fleet_tui.model.alarm import advance, withdraw
from fleet_tui.model.desk.events import OperatorEvent
from fleet_tui.model.fleet import FleetState, with_robot
from fleet_tui.model.fleets.events import DispatchFailed, MemberFact, RequestAnswered
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.grid import OccupancyGrid
from fleet_tui.model.link import Phase
from fleet_tui.model.navigation_events import Navigation
from fleet_tui.model.robot import Robot, with_fault
from fleet_tui.model.vehicles.events import VehicleFact
from fleet_tui.orders.local_queue import with_held_queues
from fleet_tui.situation.alarms.conditions import conditions
from fleet_tui.situation.alarms.floods import without_floods
from fleet_tui.situation.deadlocks import with_deadlocks
from fleet_tui.situation.failures import taken_back
from fleet_tui.situation.lag import with_lags
from fleet_tui.situation.pose_checks.misplaced import with_misplaced
from fleet_tui.state.clocks import site_clock
from fleet_tui.state.command_events import (
    advance_command,
    change_queue,
    confirm_commands,
    issue_command,
    take_answer,
)
from fleet_tui.state.desk_events import apply_operator
from fleet_tui.state.fleet_reports import apply_member_fact
from fleet_tui.state.goal_reports import without_ended, without_unlisted
from fleet_tui.state.link_events import apply_to_link
from fleet_tui.state.navigation_reports import apply_navigation
from fleet_tui.state.reports import apply_map_fact, apply_report
from fleet_tui.state.task_reports import without_unreported
from fleet_tui.state.vehicle_reports import apply_vehicle, at_last_node
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


# Made once: putting the types together for every event would take as long as finding one among them.
_OfRobot = (
    events.Telemetry | Navigation | VehicleFact | MemberFact | events.MapFactReceived | events.MessageRejected
)

RELISTED_WITHIN = 10.0, 15.0
"""Seconds after a link came up within which an active robot has listed its goals."""
LIVE_MAPS_KEPT = 4
LIVE_CELLS_KEPT = 16_000_000
"""Limits of kept live maps and their cells: a dropped one is requested again when it is shown."""


def _pass_time(state: FleetState, event: events.TimePassed) -> FleetState:
    before = state.now
    state = with_lags(replace(state, now=event.at, wall=event.wall), event.behind)
    if state.desk.acted:  # what time changes, nobody did
        state = replace(state, desk=replace(state.desk, acted=""))
    state = _without_ended(state)
    state = with_misplaced(with_held_queues(confirm_commands(state)), before)
    state = with_deadlocks(state, before)
    held = {alarm.key: alarm.condition for alarm in state.alarms if alarm.holds}
    found = list(conditions(state, held))
    began = {one.key: state.began.get(one.key, event.at) for one in found}
    due = without_floods(state, found, held)
    alarms = advance(state.alarms, due, event.at, event.wall, state.limits.clear_after, state.limits.latched)
    alarms = withdraw(alarms, taken_back(state))
    return with_blocked_edges(replace(state, began=began, alarms=alarms))


def _without_ended(state: FleetState) -> FleetState:
    changed = {
        name: left
        for name, robot in state.robots.items()
        if robot.goals and (left := _left(state, robot)) is not robot
    }
    return replace(state, robots={**state.robots, **changed}) if changed else state


def _left(state: FleetState, robot: Robot) -> Robot:
    """Return a robot without its lost goals."""
    link = state.links[robot.link]
    earliest, latest = RELISTED_WITHIN
    is_due = link.phase is Phase.UP and earliest <= state.now - link.ready_since < latest
    is_due = is_due and robot.kind.keeps_goals  # a late console gets no list of tasks
    if is_due and state.is_online(robot):
        # Many lists arrive long before the last subscription of a large fleet is handled.
        robot = without_unlisted(robot, link.since, state.now)
    if robot.kind.is_told_changes:
        robot = without_unreported(robot, state.now)
    return without_ended(robot, state.now)


def _may_keep(new: OccupancyGrid, grids: Sequence[OccupancyGrid]) -> bool:
    """Tell whether live maps are small and few enough to be kept beside a new one."""
    cells = sum(grid.frame.width * grid.frame.height for grid in [new, *grids])
    return cells <= LIVE_CELLS_KEPT and len(grids) < LIVE_MAPS_KEPT


def _forget_grids(state: FleetState, event: events.GridReceived) -> FleetState:
    """Drop all other live maps if they would be too large together."""
    maps = [one for robot in state.robots.values() for one in robot.maps.values()]
    grids = [one.grid for one in maps if one.grid]
    if _may_keep(event.grid, grids):
        return state
    robots = {
        name: replace(
            robot, maps={floor: replace(robot_map, grid=None) for floor, robot_map in robot.maps.items()}
        )
        for name, robot in state.robots.items()
    }
    return replace(state, robots=robots)


def _with_robots_map(state: FleetState, event: events.GridReceived) -> FleetState:
    state = _forget_grids(state, event)
    return with_robot(state, apply_map_fact(state.robots[event.robot], event))


def _with_live_map(state: FleetState, event: events.GridReceived) -> FleetState:
    """Store a floor's live map, shared by its robots, and drop those of other floors if they would be too
    large together."""
    if event.robot or event.floor not in state.floors:
        return state
    others = {name: floor for name, floor in state.floors.items() if name != event.floor}
    grids = [floor.live for floor in others.values() if floor.live]
    if not _may_keep(event.grid, grids):
        others = {name: replace(floor, live=None, live_at=None) for name, floor in others.items()}
    shown = replace(state.floors[event.floor], live=event.grid, live_at=event.at)
    floors = {name: others.get(name, shown) for name in state.floors}
    return replace(state, floors=floors)


def _shared(state: FleetState, event: events.GraphReceived) -> events.GraphReceived:
    """Return the event with the equal graph of another robot, if any: one object, and one drawing of it,
    serve all."""
    for robot in state.robots.values():
        robot_map = robot.maps.get(event.floor)
        if robot_map is not None and robot_map.graph == event.graph:
            return replace(event, graph=robot_map.graph)
    return event


def _apply_to_robot(state: FleetState, event: _OfRobot) -> FleetState:
    if isinstance(event, MemberFact):
        return _placed(apply_member_fact(state, event), event.robot)
    if (robot := state.robots.get(event.robot)) is None:
        return _with_live_map(state, event) if isinstance(event, events.GridReceived) else state
    if isinstance(event, Navigation):
        return _moved(state, apply_navigation(robot, event, site_clock(state, robot, event.at)))
    if isinstance(event, VehicleFact):
        return _moved(state, at_last_node(state, apply_vehicle(robot, event), event.at))
    return _apply_report(state, robot, event)


def _apply_report(
    state: FleetState, robot: Robot, event: events.Telemetry | events.MapFactReceived | events.MessageRejected
) -> FleetState:
    match event:
        case events.MessageRejected():
            return with_robot(state, with_fault(robot, event.text))
        case events.GraphReceived():
            return with_robot(state, apply_map_fact(robot, _shared(state, event)))
        case events.FrameReceived() | events.LabelsReceived():
            return with_robot(state, apply_map_fact(robot, event))
        case events.GridReceived():
            return _with_robots_map(state, event)
        case events.PoseReported():
            return _moved(state, apply_report(robot, event, site_clock(state, robot, event.at)))
        case (
            events.BatteryReported()
            | events.CargoReported()
            | events.ObstacleReported()
            | events.QueueReported()
            | events.PausedReported()
        ):
            return with_robot(state, apply_report(robot, event))
        case _:
            assert_never(event)


def _moved(state: FleetState, robot: Robot) -> FleetState:
    return with_robot(state, replace(robot, floor=_floor_of(state, robot)))


def _placed(state: FleetState, name: str) -> FleetState:
    return _moved(state, state.robots[name]) if name in state.robots else state


def _floor_of(state: FleetState, robot: Robot) -> str | None:
    """The floor a robot is on: by the frame of its poses, else as it reports, else the only possible one."""
    if robot.kind.frames_are_floors:
        named = (floor.name for floor in state.floors.values() if floor.frame_id == robot.frame_id)
        return next(named, None)
    if robot.own_floor:
        return robot.own_floor if robot.own_floor in state.floors else None
    return next(iter(robot.maps)) if len(robot.maps) == 1 else None


def apply(state: FleetState, event: events.Event) -> FleetState:
    if isinstance(event, events.TimePassed):
        return _pass_time(state, event)
    if isinstance(event, _OfRobot):
        return _apply_to_robot(state, event)
    if isinstance(event, OperatorEvent):
        return apply_operator(state, event)
    match event:
        case (
            events.LinkChanged()
            | events.MessageArrived()
            | events.CommandPathChanged()
            | events.MessagesUnsourced()
            | events.TopicsDropped()
            | events.TopicNotAllowed()
            | events.CallNotAllowed()
            | events.SubscriptionsAdvanced()
            | events.BridgeAnswered()
            | events.FrameRejected()
        ):
            return apply_to_link(state, event)
        case events.CommandIssued():
            return issue_command(state, event)
        case events.CommandAdvanced():
            return advance_command(state, event)
        case navigation_events.GoalAnswered() | RequestAnswered() | DispatchFailed():
            return take_answer(state, event)
        case navigation_events.QueueHeld() | navigation_events.OrderMoved():
            return change_queue(state, event)
        case events.FloorMapLoaded() | events.FloorGraphLoaded():
            return apply_to_floor(state, event)
        case _:
            assert_never(event)

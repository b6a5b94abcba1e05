"""Reports of vehicles that a master control moves over nodes: the effect of each on its robot."""

import math
from typing import assert_never

from msgspec.structs import replace

from fleet_tui.model.events import PoseReported
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, RouteGraph
from fleet_tui.model.navigation import Blocked
from fleet_tui.model.robot import Reading, Robot
from fleet_tui.model.vehicles import events as vehicle_events
from fleet_tui.model.vehicles.vehicle import REMOVED, CurrentAction, Vehicle
from fleet_tui.state.goal_reports import with_sign_of_life
from fleet_tui.state.reports import apply_report

NODE = "node of an order"
"""Type of the vertices that only an order has told."""
FIELD = "protective field"


def apply_vehicle(robot: Robot, event: vehicle_events.VehicleFact) -> Robot:
    match event:
        case vehicle_events.VehicleReported():
            robot = _with_motion(_with_field(robot, event), event, robot.vehicle is not None)
            return with_sign_of_life(replace(robot, vehicle=Reading(event.vehicle, event.at)), event.at)
        case vehicle_events.ConnectionReported():
            return _with_connection(robot, event)
        case vehicle_events.NodesReported():
            return _with_nodes(robot, event)
        case vehicle_events.FactsheetReported():
            return replace(robot, factsheet=dict(event.facts), features=event.features)
        case vehicle_events.MasterSeen():
            return replace(robot, master=Reading(event.what, event.at))
        case vehicle_events.MessageKept():
            return replace(robot, kept_at=event.at)
        case _:
            assert_never(event)


def _with_connection(robot: Robot, event: vehicle_events.ConnectionReported) -> Robot:
    """Take a connection. Whatever else arrives is newer than a message that the broker had kept; one for
    other topics of the same vehicle, as before an update of its software, tells nothing. Neither does a
    removed one of a vehicle that is there."""
    if event.connection.word == REMOVED:
        before = robot.connection
        if before is None or before.value.address != event.connection.address:
            return robot
        return replace(robot, connection=Reading(event.connection, before.at) if robot.is_gone else None)
    if not event.is_kept:
        return replace(robot, connection=Reading(event.connection, event.at))
    known = (robot.vehicle or robot.connection) if robot.vehicle or robot.connection else None
    is_other = known is not None and known.value.address != event.connection.address
    if is_other and event.connection.is_gone:
        return robot
    at = -math.inf if robot.last_received is None else min(event.at, robot.last_received)
    return replace(robot, connection=Reading(event.connection, at))


def _with_field(robot: Robot, event: vehicle_events.VehicleReported) -> Robot:
    """Count the seconds of a violated protective field from its first report."""
    violated = event.vehicle.field_violation
    if violated is None:
        return robot
    before = robot.blocked.value if robot.blocked else None
    goes_on = before is not None and before.is_stopped == violated
    blocked = before if goes_on else Blocked("stop" if violated else "", FIELD, event.at)
    return replace(robot, blocked=Reading(blocked, event.at)) if blocked else robot


def _with_motion(robot: Robot, event: vehicle_events.VehicleReported, was_known: bool) -> Robot:
    """Take what it says it does: while it says that it drives, it stands nowhere, whatever its poses are. One
    without poses makes progress, too; those of another may show that it does not."""
    found = next((one for one in event.vehicle.actions if one.is_carried_out), None)
    if found is None:
        robot = replace(robot, acting=None)
    elif robot.acting is None or robot.acting.action.id != found.id:
        robot = replace(robot, acting=CurrentAction(found, event.at, was_known))
    if not event.vehicle.moves or robot.pose is None:
        return robot
    here = Reading(robot.pose.value, event.at)
    return replace(robot, standing=here, place=here if robot.is_estimated else robot.place)


def _with_nodes(robot: Robot, event: vehicle_events.NodesReported) -> Robot:
    """Add the nodes of an order that no graph has to that of the floor, in place of those of the last one."""
    robot_map = robot.maps.get(robot.floor or "")
    if robot_map is None or event.frame_id not in ("", robot.frame_id):
        return robot
    graph = robot_map.graph or RouteGraph()
    known = {id_: one for id_, one in graph.vertices.items() if one.type != NODE}
    added = {id_: replace(one, type=NODE) for id_, one in event.graph.vertices.items() if id_ not in known}
    if not added and len(known) == len(graph.vertices):
        return robot
    vertices = {**known, **added}
    old = tuple(edge for edge in graph.edges if not edge.id.startswith(NODE))
    joined = {(edge.start, edge.end) for edge in old}
    new = tuple(
        Edge(f"{NODE} {edge.id}", edge.start, edge.end)
        for edge in event.graph.edges
        if (edge.start, edge.end) not in joined and edge.start in vertices and edge.end in vertices
    )
    found = RouteGraph(vertices, old + new, graph.directed or bool(new))
    if found == graph:
        return robot
    return replace(robot, maps={**robot.maps, robot.floor or "": replace(robot_map, graph=found)})


def at_last_node(state: FleetState, robot: Robot, at: float) -> Robot:
    """Place a vehicle that reports no position by the node where it was last, if a graph has it."""
    vehicle = robot.vehicle.value if robot.vehicle is not None and robot.vehicle.at == at else None
    if vehicle is None or vehicle.is_placed or not vehicle.last_node:
        return robot
    known = None if robot.is_estimated else robot.pose
    if known is not None and at - known.at <= robot.kind.silence_of("pose", state.limits.offline_after):
        return robot  # its visualization has positions
    for name, one in robot.maps.items():
        pose = _between_nodes(robot, vehicle, one.graph) if one.graph is not None else None
        if pose is not None and name in state.floors:
            frame = state.floors[name].frame_id
            placed = apply_report(robot, PoseReported(robot.name, at, pose, frame, None))
            # From node to node is no jump of a localisation, and no speed.
            same = replace(placed, jumps=robot.jumps, relocated=robot.relocated, pace=robot.pace)
            return replace(same, is_estimated=True)
    return robot


def _between_nodes(robot: Robot, vehicle: Vehicle, graph: RouteGraph) -> Pose | None:
    """Return the place at the last node, or as far as it drove from there straight towards the next one."""
    node = graph.vertices.get(vehicle.last_node)
    if node is None:
        return None
    ahead = graph.vertices.get(vehicle.nodes_left[0]) if vehicle.nodes_left else None
    length = math.dist((node.x, node.y), (ahead.x, ahead.y)) if ahead is not None else 0.0
    if ahead is None or length == 0.0:
        return Pose(node.x, node.y, robot.pose.value.yaw if robot.pose else 0.0)
    part = min(max(vehicle.distance or 0.0, 0.0), length) / length
    dx, dy = ahead.x - node.x, ahead.y - node.y
    return Pose(node.x + dx * part, node.y + dy * part, math.atan2(dy, dx))

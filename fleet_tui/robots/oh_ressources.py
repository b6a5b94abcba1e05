"""The robots of the source: OH_ressources messages behind `Application_layout` services."""

import math
import re
from array import array
from collections.abc import Callable
from functools import partial

from fleet_tui.config.profile import Profile
from fleet_tui.errors import MapError, WireError
from fleet_tui.model import events
from fleet_tui.model.bounds import (
    LONGEST_NAME,
    MOST_EDGES,
    MOST_LABELS,
    MOST_ORDERS,
    MOST_VERTICES,
    beyond,
    brief,
)
from fleet_tui.model.geometry import MapFrame, Pose, yaw_of_quaternion
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.grid import check_frame
from fleet_tui.model.order import Order, OrderQueue, OrderState, at_vertices
from fleet_tui.robots.interface import Interface, TopicKind, Translate, judge
from fleet_tui.robots.oh_calls import call
from fleet_tui.robots.parts import first_orders, read_all
from fleet_tui.rosbridge import messages as ros

STATES = {
    "Q": OrderState.QUEUED,
    "W": OrderState.IN_PROCESS,
    "D": OrderState.DONE,
    "C": OrderState.CANCELLED,
}
"""The letters that are known. W and Q come from the source; the others occur."""

# Metres; a place farther off is none on any floor, and a picture that had to hold it would overflow.
FARTHEST = 1e9


def _is_place(*numbers: float) -> bool:
    return all(abs(number) <= FARTHEST for number in numbers)


def _finite(*numbers: float, field: str) -> None:
    if not _is_place(*numbers):
        raise WireError(f"{field} is not a finite number")


def _pose(pose: ros.RosPose, field: str) -> Pose:
    _finite(pose.position.x, pose.position.y, field=f"{field}.position")
    turn = pose.orientation
    try:
        return Pose(pose.position.x, pose.position.y, yaw_of_quaternion(turn.x, turn.y, turn.z, turn.w))
    except ValueError as problem:
        raise WireError(f"{field}.orientation: {problem}") from None


def _frame(metadata: ros.MapMetadata, added: bool) -> MapFrame:
    try:
        origin = _pose(metadata.origin, "origin")
    except WireError:
        # Map servers are known to leave the origin's rotation unset: that is no rotation.
        position = metadata.origin.position
        _finite(position.x, position.y, field="origin.position")
        origin = Pose(position.x, position.y)
    frame = MapFrame(metadata.resolution, metadata.width, metadata.height, origin, added)
    _finite(frame.resolution, field="resolution")
    try:
        check_frame(frame)
    except MapError as problem:
        raise WireError(str(problem)) from None
    return frame


def _translate_pose() -> Translate:
    read = ros.reader(ros.PoseStamped)

    def translate(robot: str, _floor: str, msg: object, at: float) -> events.Event:
        message = read(msg)
        pose = _pose(message.pose, "pose")
        return events.PoseReported(robot, at, pose, message.header.frame_id, message.header.stamp.seconds)

    return translate


def _translate_bool(event: Callable[[str, float, bool], events.Event]) -> Translate:
    read = ros.reader(ros.Bool)
    return lambda robot, _floor, msg, at: event(robot, at, read(msg).data)


def _translate_number(
    event: Callable[[str, float, float], events.Event], low: float, high: float
) -> Translate:
    read = ros.reader(ros.Float32)

    def translate(robot: str, _floor: str, msg: object, at: float) -> events.Event:
        number = read(msg).data
        if not (math.isfinite(number) and low <= number <= high):
            raise WireError(f"data is {number}, not within {low:g} and {high:g}")
        return event(robot, at, number)

    return translate


def _order(order: ros.QueuedOrder) -> Order:
    stops = at_vertices(str(order.start), str(order.end))
    state, word = STATES.get(order.status), brief(order.status, LONGEST_NAME)
    return Order(str(order.id), stops, state, word, order.id)


def _translate_queue(profile: Profile) -> Translate:
    read = ros.reader(ros.ActionQueue, profile.names("queue"))
    names = profile.names("order")
    read_order = ros.reader(ros.QueuedOrder, names)

    def translate(robot: str, _floor: str, msg: object, at: float) -> events.Event:
        queue = read(msg)
        current = queue.current_order_id
        parts = map(read_order, first_orders(queue.orders, current, names.get("id", "id")))
        orders = tuple(map(_order, parts))
        fault = beyond(len(queue.orders), MOST_ORDERS, "orders")
        echo = queue.request_id if isinstance(queue.request_id, int) else 0
        # None: no order of the list has that id.
        is_listed = any(order.serial == current for order in orders)
        reported = OrderQueue(queue.last_order_id, str(current) if is_listed else "", orders, echo)
        return events.QueueReported(robot, at, reported, fault)

    return translate


def _translate_graph(profile: Profile) -> Translate:
    read = ros.reader(ros.Graph, profile.names("graph"))
    read_vertex = ros.reader(ros.GraphVertex, profile.names("vertex"))
    read_edge = ros.reader(ros.GraphEdge, profile.names("edge"))

    def translate(robot: str, floor: str, msg: object, _at: float) -> events.Event:
        graph, faults = read(msg), list[str]()
        vertices = {}
        for vertex in read_all(read_vertex, graph.vertices, "vertices", MOST_VERTICES, faults):
            if not _is_place(vertex.x, vertex.y):
                faults.append(f"vertex {vertex.id} has no finite place")
                continue
            id_, role = str(vertex.id), Role(profile.vertex_types.get(vertex.type, "plain"))
            vertices[id_] = Vertex(id_, vertex.x, vertex.y, role, brief(vertex.type, LONGEST_NAME))
        edges = []
        for edge in read_all(read_edge, graph.edges, "edges", MOST_EDGES, faults):
            start, end = str(edge.start), str(edge.end)
            lost = [one for one in (start, end) if one not in vertices]
            if lost:
                faults.append(f"edge {edge.id} names unknown vertex {lost[0]}")
                continue
            edges.append(Edge(str(edge.id), start, end))
        routes = RouteGraph(vertices, tuple(edges), profile.directed)
        fault = f"graph of {floor}: {faults[0]}" if faults else ""
        return events.GraphReceived(robot, floor, routes, len(faults), fault)

    return translate


def _translate_labels(profile: Profile) -> Translate:
    read = ros.reader(ros.LabeledVertices, profile.names("labels"))
    read_label = ros.reader(ros.LabeledVertex, profile.names("label"))

    def translate(robot: str, floor: str, msg: object, _at: float) -> events.Event:
        parts = read(msg).vertices
        found = map(read_label, parts[:MOST_LABELS])
        labels = {str(one.vertex_id): brief(one.label, LONGEST_NAME) for one in found}
        fault = f"labels of {floor}: {beyond(len(parts), MOST_LABELS, 'labels')}"
        return events.LabelsReceived(robot, floor, labels, *((1, fault) if len(parts) > MOST_LABELS else ()))

    return translate


def _translate_metadata(profile: Profile) -> Translate:
    read = ros.reader(ros.MapMetadata)
    added = profile.origin == "added"
    return lambda robot, floor, msg, _at: events.FrameReceived(robot, floor, _frame(read(msg), added))


def _translate_map(profile: Profile) -> Translate:
    read = ros.reader(ros.OccupancyGridMessage)
    added = profile.origin == "added"

    def translate(robot: str, floor: str, msg: object, _at: float) -> events.Event:
        # With numpy, whose import takes longer than all that a command without a screen does.
        from fleet_tui.model.occupancy import grid_from_ros

        message = read(msg)
        data = message.data if isinstance(message.data, bytes) else array("b", message.data).tobytes()
        try:
            return events.GridReceived(robot, floor, grid_from_ros(_frame(message.info, added), data))
        except MapError as problem:
            raise WireError(str(problem)) from None

    return translate


def interface(profile: Profile) -> Interface:
    """The interface of these robots under the names of a profile."""
    refusals = [re.compile(pattern) for pattern in profile.refusals]
    return Interface(
        topics=(
            TopicKind("pose", _translate_pose(), fast=True),
            TopicKind("queue", _translate_queue(profile)),
            TopicKind("obstacle", _translate_number(events.ObstacleReported, 0.0, math.inf)),
            TopicKind("battery", _translate_number(events.BatteryReported, 0.0, 101.0)),
            TopicKind("cargo", _translate_bool(events.CargoReported)),
            TopicKind("paused", _translate_bool(events.PausedReported)),
            TopicKind("graph", _translate_graph(profile), per_floor=True),
            TopicKind("labels", _translate_labels(profile), per_floor=True),
            TopicKind("map_metadata", _translate_metadata(profile), per_floor=True),
            TopicKind("map", _translate_map(profile), per_floor=True, heavy=True),
        ),
        call=partial(call, profile),
        outcome=lambda command, values, result: judge(command, values, result, refusals),
    )

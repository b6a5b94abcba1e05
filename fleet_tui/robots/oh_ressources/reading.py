"""Messages of the package OH_ressources as events."""

from fleet_tui.model import events
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.model.order import Order, OrderQueue, OrderState, at_vertices
from fleet_tui.robots.parts import first_orders, read_all
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.facts import Translate, is_place
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.limits import (
    LONGEST_NAME,
    MOST_EDGES,
    MOST_LABELS,
    MOST_ORDERS,
    MOST_VERTICES,
    too_many,
    truncate,
)

STATES = {"Q": OrderState.QUEUED, "W": OrderState.IN_PROCESS, "D": OrderState.DONE, "C": OrderState.CANCELLED}
"""The known letters. W and Q are from the source; the others occur."""


def _order(order: ros.QueuedOrder) -> Order:
    stops = at_vertices(str(order.start), str(order.end))
    state, word = STATES.get(order.status), truncate(order.status, LONGEST_NAME)
    return Order(str(order.id), stops, state, word, order.id)


def read_queue(names: Names) -> Translate:
    read = ros.reader(ros.ActionQueue, names.paths("queue"))
    read_order = ros.reader(ros.QueuedOrder, names.paths("order"))
    id_name = names.path("order", "id")

    def translate(robot: str, _floor: str, msg: object, at: float) -> events.Event:
        queue = read(msg)
        current = queue.current_order_id
        parts = map(read_order, first_orders(queue.orders, current, id_name))
        orders = tuple(map(_order, parts))
        fault = too_many(len(queue.orders), MOST_ORDERS, Message("orders"))
        echo = queue.request_id if isinstance(queue.request_id, int) else 0
        # None: no order of the list has that id.
        is_listed = any(order.serial == current for order in orders)
        reported = OrderQueue(queue.last_order_id, str(current) if is_listed else "", orders, echo)
        return events.QueueReported(robot, at, reported, fault)

    return translate


def read_graph(names: Names) -> Translate:
    read = ros.reader(ros.GraphMessage, names.paths("graph"))
    read_vertex = ros.reader(ros.GraphVertex, names.paths("vertex"))
    read_edge = ros.reader(ros.GraphEdge, names.paths("edge"))
    scale = names.scale("vertex")

    def translate(robot: str, floor: str, msg: object, _at: float) -> events.Event:
        graph, faults = read(msg), list[str]()
        vertices = {}
        for vertex in read_all(read_vertex, graph.vertices, Message("vertices"), MOST_VERTICES, faults):
            x, y = vertex.x * scale, vertex.y * scale
            if not is_place(x, y):
                faults.append(Message("vertex {id} has no finite position", id=vertex.id))
                continue
            id_, role = str(vertex.id), Role(names.role(vertex.type))
            vertices[id_] = Vertex(id_, x, y, role, truncate(vertex.type, LONGEST_NAME))
        edges = []
        for edge in read_all(read_edge, graph.edges, Message("edges"), MOST_EDGES, faults):
            start, end = str(edge.start), str(edge.end)
            lost = [one for one in (start, end) if one not in vertices]
            if lost:
                faults.append(f"edge {edge.id} names unknown vertex {lost[0]}")
                continue
            edges.append(Edge(str(edge.id), start, end))
        routes = RouteGraph(vertices, tuple(edges), names.profile.directed)
        fault = Message("graph of {floor}: {faults}", floor=floor, faults=faults[0]) if faults else EMPTY
        return events.GraphReceived(robot, floor, routes, len(faults), fault)

    return translate


def read_labels(names: Names) -> Translate:
    read = ros.reader(ros.LabeledVertices, names.paths("labels"))
    read_label = ros.reader(ros.LabeledVertex, names.paths("label"))

    def translate(robot: str, floor: str, msg: object, _at: float) -> events.Event:
        parts = read(msg).vertices
        found = map(read_label, parts[:MOST_LABELS])
        labels = {str(one.vertex_id): truncate(one.label, LONGEST_NAME) for one in found}
        most = too_many(len(parts), MOST_LABELS, Message("labels"))
        fault = Message("labels of {floor}: {most}", floor=floor, most=most)
        return events.LabelsReceived(robot, floor, labels, *((1, fault) if len(parts) > MOST_LABELS else ()))

    return translate

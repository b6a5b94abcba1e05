"""Navigation graphs as events: one message has a fleet's vertices on all levels."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import msgspec
from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.graph import Edge, Role, RouteGraph, Vertex
from fleet_tui.robots.parts import read_all
from fleet_tui.robots.rmf.fleets import Read
from fleet_tui.robots.rmf.names import fleet_and_name
from fleet_tui.robots.ros import messages as ros
from fleet_tui.robots.ros.facts import is_place
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.limits import LONGEST_NAME, MOST_EDGES, MOST_VERTICES, too_many, truncate

ONE_WAY = 1
"""The type of an edge in one direction."""
LEVEL = "map_name"
LIFTS = ("lift", "lift_name", "in_lift")
"""Parameters of a vertex in a lift."""
FLAGS = {
    "is_charger": "charger",
    "is_parking_spot": "parking_spot",
    "is_holding_point": "holding_point",
    "is_passthrough_point": "passthrough_point",
}
"""Types of vertices by their parameters, the first of several."""
ROLES = {"lift": Role.ELEVATOR, "charger": Role.DOCKING}


class ParamMessage(msgspec.Struct, frozen=True):
    """rmf_building_map_msgs/Param."""

    name: str
    value_string: str = ""
    value_bool: bool = False


class NodeMessage(msgspec.Struct, frozen=True):
    """rmf_building_map_msgs/GraphNode, metres."""

    x: float
    y: float
    name: str = ""
    params: list[ParamMessage] = []


class LaneMessage(msgspec.Struct, frozen=True):
    """rmf_building_map_msgs/GraphEdge."""

    v1_idx: int
    v2_idx: int
    edge_type: int = 0


class NavGraphMessage(msgspec.Struct, frozen=True):
    """rmf_building_map_msgs/Graph, its parts unread: one bad vertex must not cost the others."""

    name: str
    vertices: list[Any]
    edges: list[Any]


def read_graphs() -> Read:
    """Read a rmf_building_map_msgs/Graph."""
    read = ros.reader(NavGraphMessage)

    def facts(robots: frozenset[str], msg: object, at: float) -> Iterable[events.Event]:
        message = read(msg)
        own = sorted(robot for robot in robots if fleet_and_name(robot)[0] == message.name)
        if not own:
            return
        faults = list[str]()
        levels = _levels(message, faults)
        for level, (graph, labels) in levels.items():
            fault = (
                Message("graph of {name}: {faults}", name=message.name, faults=faults[0]) if faults else EMPTY
            )
            for robot in own:
                yield events.GraphReceived(robot, level, graph, len(faults), fault)
                yield events.LabelsReceived(robot, level, labels)

    return facts


def _levels(
    message: NavGraphMessage, faults: list[str]
) -> Mapping[str, tuple[RouteGraph, Mapping[str, str]]]:
    """Return graph and labels of each level. Lanes between levels are rides in a lift, and left out."""
    nodes = dict(_nodes(message, faults))
    read_lane = ros.reader(LaneMessage)
    if more := too_many(len(message.edges), MOST_EDGES, Message("edges")):
        faults.append(more)
    lanes = [
        (n, lane)  # closed lanes are named by the number that bad ones count for
        for n, part in enumerate(message.edges[:MOST_EDGES])
        for lane in read_all(read_lane, [part], Message("edges[{n}]", n=n), 1, faults)
        if lane.v1_idx in nodes and lane.v2_idx in nodes
    ]
    found = {}
    for level in dict.fromkeys(level for level, _, _ in nodes.values()):
        vertices = {n: vertex for n, (other, vertex, _) in nodes.items() if other == level}
        labels = {vertices[n].id: label for n, (other, _, label) in nodes.items() if other == level and label}
        here = [(n, one) for n, one in lanes if one.v1_idx in vertices and one.v2_idx in vertices]
        edges = tuple(Edge(str(n), vertices[one.v1_idx].id, vertices[one.v2_idx].id) for n, one in here)
        found[level] = _graph(tuple(vertices.values()), edges, [one for _, one in here]), labels
    return found


def _nodes(message: NavGraphMessage, faults: list[str]) -> Iterator[tuple[int, tuple[str, Vertex, str]]]:
    """Return level, vertex and label by index. A vertex goes by its label, as orders name it."""
    read_node, taken = ros.reader(NodeMessage), set[str]()
    for n, part in enumerate(message.vertices[:MOST_VERTICES]):
        found = read_all(read_node, [part], Message("vertices[{n}]", n=n), 1, faults)
        node = found[0] if found else None
        if node is None:
            continue
        if not is_place(node.x, node.y):
            faults.append(Message("vertex {n} has no finite position", n=n))
            continue
        params = {one.name: one for one in node.params}
        level = truncate(params[LEVEL].value_string, LONGEST_NAME) if LEVEL in params else ""
        label = truncate(node.name.strip(), LONGEST_NAME)
        is_unique = label not in taken and not label.startswith("#")
        id_ = label if label and is_unique else f"#{n}"
        taken.add(id_)
        type_ = _type(params)
        yield n, (level, Vertex(id_, node.x, node.y, ROLES.get(type_, Role.PLAIN), type_), label)


def _type(params: Mapping[str, ParamMessage]) -> str:
    if any(name in params and params[name].value_string for name in LIFTS):
        return "lift"
    return next((type_ for name, type_ in FLAGS.items() if name in params and params[name].value_bool), "")


def _graph(vertices: tuple[Vertex, ...], edges: tuple[Edge, ...], lanes: list[LaneMessage]) -> RouteGraph:
    """Return the graph of a level: with directions only if an edge has no way back."""
    by_id = {vertex.id: vertex for vertex in vertices}
    ways = {(one.start, one.end) for one in edges}
    pairs_of = [
        (edge,) if lane.edge_type == ONE_WAY else (edge, Edge(f"{edge.id}b", edge.end, edge.start, edge.id))
        for edge, lane in zip(edges, lanes, strict=True)
    ]
    if any(len(pair) == 1 and (pair[0].end, pair[0].start) not in ways for pair in pairs_of):
        return RouteGraph(by_id, tuple(edge for pair in pairs_of for edge in pair), directed=True)
    pairs = dict[frozenset[str], Edge]()
    for edge in edges:
        ends = frozenset((edge.start, edge.end))
        first = pairs.setdefault(ends, edge)
        if first is not edge and not first.reverse_id:
            pairs[ends] = replace(first, reverse_id=edge.id)
    return RouteGraph(by_id, tuple(pairs.values()))

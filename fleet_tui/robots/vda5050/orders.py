"""Orders and instant actions as messages, without their headers."""

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any
from uuid import UUID

from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.order import Stop
from fleet_tui.model.robot import Robot
from fleet_tui.model.vehicles.vehicle import (
    START_CHARGING,
    STOP_CHARGING,
    Vehicle,
    VehicleConnection,
    VehicleFeatures,
)
from fleet_tui.orders.goals import active
from fleet_tui.robots.adapter import Publication
from fleet_tui.robots.vda5050.settings import VehicleSettings
from fleet_tui.robots.vda5050.topics import INSTANT_ACTIONS, INTERFACE, INTERFACE_3, ORDER, with_name
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message

TAKES_NO_ORDERS = 3
"""The first major version whose orders are not written here; its instant actions are those of 2.1."""
NEWEST = {"3.0.0": INTERFACE_3, "2.1.0": INTERFACE, "1.1.0": INTERFACE}
"""The newest version of each number, with its interface, for a vehicle of which nothing has arrived."""
BOTH_WAYS = ("2.1.0", "1.1.0")
"""Versions of both ways to write an instant action, for a vehicle that names none."""
_MAJOR = re.compile(r"v?(\d+)", re.IGNORECASE)
HERE = "here"
"""The first node of an order for a vehicle that stands at none."""
AT_NODE = 0.5
"""Metres within which a vehicle stands at a node."""

Place = tuple[str, float | None, float | None]
"""A node: its id, and its place where that is known."""


class NeverSeenError(CommandError):
    """Nothing of a vehicle has arrived that tells its topics and its version, or one that is none."""


def major_of(version: str) -> int | None:
    """Return the first number of a version such as 2.0.0, v1.1 or V2, None without one."""
    found = _MAJOR.match(version.strip())
    return int(found[1]) if found else None


def seen_of(robot: Robot) -> Vehicle | VehicleConnection | None:
    """Return what a vehicle told last of its topics and its version."""
    return robot.vehicle.value if robot.vehicle else robot.connection.value if robot.connection else None


def address_of(robot: Robot, name: str) -> tuple[str, str]:
    """Return the topic of a name and the version of a vehicle's messages. Raises CommandError for one that
    was never seen, and for orders of a version in which they are not written here."""
    seen = seen_of(robot)
    if seen is None:
        raise NeverSeenError(Message("{name} was never seen: its version is unknown", name=robot.name))
    version = seen.version or "2.0.0"
    major = major_of(version)
    if major is None:
        said = Message(
            "{name} reports version {version}, whose messages are unknown here",
            name=robot.name,
            version=f"{version!r}",
        )
        raise NeverSeenError(said)
    if name == ORDER and major >= TAKES_NO_ORDERS:
        raise CommandError(
            Message(
                "{name} speaks VDA 5050 {version}: orders in that version are not supported",
                name=robot.name,
                version=version,
            )
        )
    return with_name(seen.address, name), version


def instant_action(settings: VehicleSettings, robot: Robot, type_: str, unique: str) -> Publication:
    """Return an instant action; its id is the publication's name. Raises CommandError."""
    return action_at(settings, *address_of(robot, INSTANT_ACTIONS), type_, unique)


def action_at(settings: VehicleSettings, topic: str, version: str, type_: str, unique: str) -> Publication:
    """Return an instant action on a topic, as vehicles of a version read it."""
    key = settings.instant_actions or ("instantActions" if major_of(version) == 1 else "actions")
    id_ = str(UUID(hex=unique))
    action = {"actionType": type_, "actionId": id_, "blockingType": "NONE", "actionParameters": []}
    return Publication(topic, version, {key: [action]}, id_)


def is_field_open(settings: VehicleSettings, robot: Robot) -> bool:
    """Tell whether a vehicle may read its instant actions in the other field: its version names both, in its
    text and in its schema."""
    version = robot.vehicle.value.version.strip().lower().removeprefix("v") if robot.vehicle else ""
    return not settings.instant_actions and (version == "2" or version.startswith("2.0"))


def cancel(settings: VehicleSettings, robot: Robot, order_id: str, unique: str) -> Publication:
    """Return the cancellation of the one order that a vehicle has. Raises CommandError for another one."""
    if not any(goal.id == order_id for goal in active(robot.goals)):
        raise CommandError(
            Message("unknown order {order_id}: see the queue of {name}", order_id=order_id, name=robot.name)
        )
    return instant_action(settings, robot, "cancelOrder", unique)


def order(
    settings: VehicleSettings, frames: Mapping[str, str], robot: Robot, stops: Sequence[Stop], unique: str
) -> Publication:
    """Return an order to the stops in sequence, all of it released; `frames` are those of floors. Raises
    CommandError for an unknown or unreachable place."""
    topic, version = address_of(robot, ORDER)
    floor = _floor_of(robot)
    known = robot.maps.get(floor)
    places = _route(robot, (known.graph if known else None) or RouteGraph(), stops)
    map_id, id_ = robot.frame_id or frames.get(floor, ""), str(UUID(hex=unique))
    headings = _headings(robot, stops)
    nodes = [
        {**_part(2 * n), "nodeId": node, **_position(settings, map_id, x, y, headings.get(node))}
        for n, (node, x, y) in enumerate(places)
    ]
    edges = [_edge(2 * n + 1, start[0], end[0]) for n, (start, end) in enumerate(pairwise(places))]
    _add_actions(settings, nodes, places, stops, id_)
    features = robot.features or VehicleFeatures()
    if is_charging(robot) and STOP_CHARGING in features.at_nodes:
        nodes[0]["actions"] = [_hard(f"{id_}-free", STOP_CHARGING), *nodes[0]["actions"]]
    if known and known.graph and features.charges:
        chargers = {charger.id for charger in known.graph.chargers}
        given = nodes[-1]["actions"]
        if stops[-1].vertex in chargers and all(one["actionType"] != START_CHARGING for one in given):
            nodes[-1]["actions"] = [*given, _hard(f"{id_}-charge", START_CHARGING)]
    message = {"orderId": id_, "orderUpdateId": 0, "nodes": nodes, "edges": edges}
    return Publication(topic, version, message, id_)


def is_charging(robot: Robot) -> bool:
    """Tell whether a vehicle says that it charges, which ends before it drives."""
    return robot.vehicle is not None and robot.vehicle.value.charging is True


def _part(number: int) -> dict[str, Any]:
    """Return what nodes and edges have in common: they share one sequence."""
    return {"sequenceId": number, "released": True, "actions": []}


def _edge(number: int, start: str, end: str) -> Mapping[str, object]:
    return {**_part(number), "edgeId": f"{start}-{end}", "startNodeId": start, "endNodeId": end}


def _goal(number: int) -> str:
    """Return the node of a stop that is a pose."""
    return f"goal_{number}"


def _headings(robot: Robot, stops: Sequence[Stop]) -> Mapping[str, float]:
    """Return the headings to keep, by node: those that were given, unless the vehicle takes none."""
    if robot.features is not None and robot.features.refuses_headings:
        return {}
    given = ((n, stop.pose) for n, stop in enumerate(stops) if stop.pose and not stop.turns_freely)
    return {_goal(n): math.remainder(pose.yaw, math.tau) for n, pose in given}


def _position(
    settings: VehicleSettings, map_id: str, x: float | None, y: float | None, heading: float | None
) -> Mapping[str, object]:
    if x is None or y is None:
        return {}
    theta = {} if heading is None else {"theta": heading}
    deviation = {"allowedDeviationXY": settings.deviation} if settings.deviation else {}
    return {"nodePosition": {"x": x, "y": y, **theta, "mapId": map_id, **deviation}}


def _add_actions(
    settings: VehicleSettings,
    nodes: Sequence[dict[str, Any]],
    places: Sequence[Place],
    stops: Sequence[Stop],
    id_: str,
) -> None:
    """Add the site's actions: picking at the first of several stops, dropping at the last."""
    names = [stop.vertex for stop in stops]
    if len(names) < 2:
        return
    ids = [place[0] for place in places]
    for key, n in (("pick", ids.index(names[0]) if names[0] in ids else 0), ("drop", len(nodes) - 1)):
        action = settings.actions.get(key)  # type: ignore[call-overload]  # a literal
        if action:
            nodes[n]["actions"] = [{**_hard(f"{id_}-{key}"), **action}]


def _hard(id_: str, type_: str = "") -> dict[str, Any]:
    """Return an action during which nothing else is done."""
    return {"actionType": type_, "actionId": id_, "blockingType": "HARD", "actionParameters": []}


def _floor_of(robot: Robot) -> str:
    """Return the floor of a vehicle: that of its pose, else one with the node where it was last."""
    last = robot.vehicle.value.last_node if robot.vehicle else ""
    graphs = {name: one.graph for name, one in robot.maps.items() if one.graph is not None}
    return robot.floor or next((name for name, graph in graphs.items() if last in graph.vertices), "")


def _route(robot: Robot, graph: RouteGraph, stops: Sequence[Stop]) -> list[Place]:
    """Return the nodes to drive over, the first where the vehicle is. Raises CommandError."""
    if not stops:
        raise CommandError(Message("an order needs a destination"))
    places = [_start(robot, graph)]
    for n, stop in enumerate(stops):
        places += _leg(robot, graph, places[-1], stop, n)
    return places


def _start(robot: Robot, graph: RouteGraph) -> Place:
    """Return the first node: the one where the vehicle was last, or a new one where it stands."""
    last = robot.vehicle.value.last_node if robot.vehicle else ""
    pose = robot.pose.value if robot.pose else None
    known = graph.vertices.get(last)
    if known is not None and (pose is None or math.dist((known.x, known.y), (pose.x, pose.y)) <= AT_NODE):
        return last, known.x, known.y
    if pose is None:
        if not last:
            raise CommandError(
                Message(
                    "{name} reports neither a pose nor a node: an order has no first node", name=robot.name
                )
            )
        return (last, known.x, known.y) if known else (last, None, None)
    here = (pose.x, pose.y)
    near = [(math.dist((one.x, one.y), here), one.id) for one in graph.vertices.values()]
    metres, id_ = min(near, default=(math.inf, ""))
    if metres <= AT_NODE:
        return id_, graph.vertices[id_].x, graph.vertices[id_].y
    return HERE, pose.x, pose.y


def _leg(robot: Robot, graph: RouteGraph, start: Place, stop: Stop, number: int) -> Iterator[Place]:
    """Yield the nodes after `start` up to a stop. Raises CommandError."""
    if stop.pose is not None:
        yield _goal(number), stop.pose.x, stop.pose.y
        return
    if stop.vertex not in graph.vertices:
        raise CommandError(
            Message(
                "position of node {vertex} unknown: no graph of its floor contains it", vertex=stop.vertex
            )
        )
    id_, x, y = start
    if id_ in graph.vertices:
        way = graph.path(id_, stop.vertex)
        if not way:
            raise CommandError(
                Message("no path from {name} to {vertex} on the graph", name=id_, vertex=stop.vertex)
            )
        way = way[1:]
    else:
        way = (stop.vertex,) if x is None or y is None else _from_nowhere(graph, (x, y), stop.vertex)
    for node in way:
        yield node, graph.vertices[node].x, graph.vertices[node].y


def _from_nowhere(graph: RouteGraph, here: tuple[float, float], goal: str) -> tuple[str, ...]:
    """Return the way from the nearest node from which the goal can be reached."""
    reachable = graph.metres_to([goal])
    near = min(
        reachable,
        key=lambda id_: math.dist((graph.vertices[id_].x, graph.vertices[id_].y), here),
        default=goal,
    )
    return graph.path(near, goal) or (goal,)

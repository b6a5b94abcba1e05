"""A World as the bridge sees it."""

import math
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from fleet_tui.simulator.fleets import Fleet, Line, Subscriptions
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.logs import BROKEN, DEBUG, DOUBTFUL, ERROR, HEALTHY, INFO, WARN, entry
from fleet_tui.simulator.messages import Message, Topic, flat
from fleet_tui.simulator.oh_ressources.messages import graph_of, labels_of, map_of, topics_of
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.robot import EMPTY, LOW, SimRobot
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.filling import ServiceType, service_type
from fleet_tui.simulator.senses.camera import camera_topic
from fleet_tui.simulator.senses.laser import scan_topic
from fleet_tui.simulator.senses.mapping import Surveys
from fleet_tui.simulator.senses.wheels import twists
from fleet_tui.simulator.warehouse import SimEdge, SimFloor, SimGraph, SimVertex

DESK = "Application_layout"
ORDER_SERVICES = {
    "Execute_order": "OH_ressources/Execute_manual_order",
    "Execute_order_with_cargo": "OH_ressources/Execute_manual_order_with_cargo",
    "Cancel_order": "OH_ressources/Cancel_order",
    "Clear_orders": "OH_ressources/Clear_orders",
    "Pause": "std_srvs/Trigger",
    "Resume": "std_srvs/Trigger",
}
MAPPING = "set_mapping"
SAVE = "save_map"


GRAPH_SAVE = "graph_save"
LABELS_SAVE = "labels_save"


class OhFleet(World, Fleet):
    """The robots of the source's stack on the wire."""

    kind = "oh_ressources"
    robots: dict[str, SimRobot]

    def __init__(
        self, robots: int, floors: int, seed: int = 0, quiet: bool = False, first: int = 0, step: int = 1
    ) -> None:
        super().__init__(robots, floors, seed, quiet, first, step)
        self._graphs = SentGraphs(self)
        self._seen: dict[str, _Seen] = {}
        self._surveys = Surveys(self.robots, self._map_topics)
        self.troubles.append(self._surveys.step)

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        yield from topics_of(self, loaded_at, dialect, self._surveys.cells)
        yield from self._surveys.topics(dialect)
        for robot in self.robots.values():
            yield scan_topic(robot, dialect)
            yield camera_topic(robot, dialect)

    def _map_topics(self, floor: SimFloor) -> list[str]:
        return [f"/{robot}/{floor.name}/map" for robot in self.robots]

    def subscriptions(self) -> Subscriptions:
        """The topics of each robot for its pose, a goal beside its orders, twists, and a graph."""
        return {
            f"/{name}/{topic}": (type_, partial(take, robot))
            for name, robot in self.robots.items()
            for topic, (type_, take) in SUBSCRIPTIONS.items()
        } | {**self._graphs.subscriptions(), **twists(self.robots)}

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        orders = {f"{DESK}/{verb}": name for verb, name in ORDER_SERVICES.items()}
        set_up = {MAPPING: "std_srvs/SetBool", SAVE: "slam_toolbox_msgs/SaveMap"}
        return {
            f"/{robot}/{part}": service_type(dialect, name)
            for parts in (orders, set_up)
            for robot in self.robots
            for part, name in parts.items()
        }

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        """The world's answer, or that of the switch of mapping, or of a map that is saved."""
        if service.endswith(f"/{SAVE}"):
            return {}
        if service.endswith(f"/{MAPPING}"):
            self._surveys.switch(service.split("/")[1], on=args["data"])
            return {"success": True, "message": ""}
        return super().answer(service, args)

    def news(self, dialect: Dialect) -> Iterable[tuple[str, Payload]]:
        """Return modes, graphs and live maps that changed: all other topics are published continuously."""
        now = time.time()
        yield from self._graphs.news()
        yield from self._surveys.news(lambda floor: map_of(floor, now, dialect, self._surveys.cells))

    def lines(self) -> Iterator[Line]:
        for name, robot in self.robots.items():
            seen, before = _seen(robot), self._seen.get(name)
            self._seen[name] = seen
            if before is not None and before != seen and not robot.silence:
                for level, node, message in _changes(before, seen, robot):
                    yield level, f"/{name}/{node}", message

    def health(self) -> Iterable[Message]:
        return (entry for robot in self.robots.values() if not robot.silence for entry in health(robot))


class SentGraphs:
    """Takes graphs and labels of floors; one that a robot could not drive on is dropped silently."""

    def __init__(self, world: World) -> None:
        self._world = world
        self._redrawn: set[str] = set()

    def subscriptions(self) -> Subscriptions:
        """The topics of each robot and floor on which a graph and its labels are sent."""
        taken = {
            GRAPH_SAVE: ("OH_ressources/Graph", self._take_graph),
            LABELS_SAVE: ("OH_ressources/LabeledVertices", self._take_labels),
        }
        return {
            f"/{robot}/{floor.name}/{topic}": (type_, partial(take, number))
            for robot in self._world.robots
            for number, floor in enumerate(self._world.building.floors)
            for topic, (type_, take) in taken.items()
        }

    def news(self) -> Iterator[tuple[str, Payload]]:
        """Return the graphs and labels of floors that were redrawn since the last call."""
        for floor in self._world.building.floors:
            if floor.name in self._redrawn:
                for topic, message in (("graph", graph_of(floor)), ("labeled_vertices", labels_of(floor))):
                    payload = Payload(message)
                    yield from ((f"/{robot}/{floor.name}/{topic}", payload) for robot in self._world.robots)
        self._redrawn.clear()

    def _take_graph(self, number: int, message: Message) -> None:
        """Take a graph; labels without a vertex, and edges to one that is unknown, are dropped."""
        floors = self._world.building.floors
        floor, vertices = floors[number], {one["id"]: _vertex(one) for one in message["vertices"]}
        others = {id_ for other in floors if other is not floor for id_ in other.graph.vertices}
        places = [metres for one in vertices.values() for metres in (one.x, one.y)]
        # The ids of a building are unique: robots plan across its floors.
        if not vertices or others & vertices.keys() or not all(map(math.isfinite, places)):
            return
        edges = [SimEdge(one["id"], one["start"], one["end"]) for one in message["edges"]]
        known = tuple(edge for edge in edges if edge.start in vertices and edge.end in vertices)
        types = {one["id"]: one["type"] for one in message["vertices"]}
        labels = {id_: label for id_, label in floor.labels.items() if id_ in vertices}
        graph = SimGraph(vertices, known)
        self._world.redraw(replace(floor, graph=graph, types=types, labels=labels))
        self._redrawn.add(floor.name)

    def _take_labels(self, number: int, message: Message) -> None:
        """Take labels, all of them or, if one names an unknown vertex, none."""
        floor = self._world.building.floors[number]
        labels = {one["vertex_id"]: one["label"] for one in message["vertices"]}
        if labels.keys() <= floor.graph.vertices.keys():
            self._world.building.redraw(replace(floor, labels=labels))
            self._redrawn.add(floor.name)


def _vertex(given: Mapping[str, Any]) -> SimVertex:
    return SimVertex(given["id"], given["x"], given["y"])


@dataclass(frozen=True)
class _Seen:
    """What the log tells of a robot, as it was at the last call."""

    last_order: int
    current: int
    loaded: bool
    obstacle: bool
    paused: bool
    stuck: bool
    low: bool
    floor: str
    vertex: int


def _seen(robot: SimRobot) -> _Seen:
    return _Seen(
        robot.last_order_id,
        robot.current_order_id,
        robot.cargo,
        robot.obstacle > 0.0,
        robot.paused,
        robot.stuck and robot.current_order_id != -1,
        robot.battery < LOW,
        robot.floor.name,
        robot.vertex,
    )


def _changes(before: _Seen, now: _Seen, robot: SimRobot) -> Iterator[Line]:
    if now.last_order > before.last_order:
        order = next((one for one in robot.orders if one.id == now.last_order), None)
        way = f": {order.start} -> {order.end}" if order else ""
        yield INFO, "planner", f"took order {now.last_order}{way}"
    if now.current != before.current:
        yield from _order_changes(before, now, robot)
    if now.loaded != before.loaded:
        yield INFO, "lift", "cargo is on board" if now.loaded else "cargo is unloaded"
    if now.floor != before.floor:
        yield INFO, "navigation", f"now on {now.floor}"
    if now.vertex != before.vertex:
        yield DEBUG, "navigation", f"at vertex {now.vertex}"
    if now.obstacle != before.obstacle:
        message = "obstacle in front of the laser" if now.obstacle else "the obstacle is gone"
        yield (WARN if now.obstacle else INFO), "laser", message
    if now.paused != before.paused:
        yield WARN, "drive", "brakes on" if now.paused else "brakes off"
    if now.stuck and not before.stuck:
        yield ERROR, "drive", "wheels turn, odometry does not change"
    if now.low and not before.low:
        yield WARN, "battery", f"{robot.battery:.1f} %, charging soon"


def _order_changes(before: _Seen, now: _Seen, robot: SimRobot) -> Iterator[Line]:
    if before.current != -1 and all(order.id != before.current for order in robot.orders):
        yield INFO, "planner", f"order {before.current} has left the queue"
    if now.current != -1:
        yield DEBUG, "planner", f"working on order {now.current}"


def health(robot: SimRobot) -> Iterator[Message]:
    """The entries of /diagnostics about one robot."""
    empty, low = robot.battery < EMPTY, robot.battery < LOW
    level = BROKEN if empty else DOUBTFUL if low else HEALTHY
    charge = "empty" if empty else "low" if low else "charged"
    yield entry(robot, "battery", level, charge, percent=f"{robot.battery:.1f}")
    slips = robot.stuck and robot.current_order_id != -1
    drive = "no odometry" if slips else "brakes on" if robot.paused else "ready"
    x, y = f"{robot.pose.x:.2f}", f"{robot.pose.y:.2f}"
    yield entry(robot, "drive", BROKEN if slips else HEALTHY, drive, x=x, y=y)
    blocked = robot.obstacle > 0.0
    message = "something is close" if blocked else "clear"
    contact = f"{robot.obstacle:.1f}"
    yield entry(robot, "laser", DOUBTFUL if blocked else HEALTHY, message, contact_s=contact)


def _take_pose(robot: SimRobot, message: Message) -> None:
    """Take a pose on its floor; one in a foreign frame is dropped silently."""
    if message["header"]["frame_id"].lstrip("/") == robot.floor.name:
        robot.belief.place(flat(message["pose"]["pose"]), robot.pose)


def _take_goal(robot: SimRobot, message: Message) -> None:
    if message["header"]["frame_id"].lstrip("/") == robot.floor.name:
        robot.visit(flat(message["pose"]))


def _cancel_goal(robot: SimRobot, message: Message) -> None:
    """Stop; the only id known here is the empty one, for every goal."""
    if not message["id"]:
        robot.visit(None)


SUBSCRIPTIONS: Mapping[str, tuple[str, Callable[[SimRobot, Message], None]]] = {
    "initialpose": ("geometry_msgs/PoseWithCovarianceStamped", _take_pose),
    "goal": ("geometry_msgs/PoseStamped", _take_goal),
    "goal_cancel": ("actionlib_msgs/GoalID", _cancel_goal),
}
"""Type of each topic, and the function that takes its messages."""

"""A fleet with Nav2 as the bridge sees it: topics, actions, services."""

import json
import time
from collections.abc import Iterator, Mapping
from functools import cached_property, partial
from pathlib import Path
from typing import Any, NamedTuple

from fleet_tui.simulator.fleets import Line, Subscriptions
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.logs import ERROR, HEALTHY, INFO, WARN
from fleet_tui.simulator.messages import FRAME, Header, Message, Topic, headers, raw_payload
from fleet_tui.simulator.nav2 import messages
from fleet_tui.simulator.nav2.navigation import NODES, TO_POSE, SimNavigation
from fleet_tui.simulator.navigating.fleet import FileServices, NavigatingFleet, plan_topic, robot_topic
from fleet_tui.simulator.navigating.robot import TAKEN_OVER, NavigatingRobot
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.filling import ServiceType, service_type
from fleet_tui.simulator.ros.goals import (
    ABORTED,
    CANCELED,
    EXECUTING,
    SUCCEEDED,
    ActionServer,
    ServedGoal,
    uuid_of,
)

SAVES: FileServices = {
    "map_saver/save_map": ("nav2_msgs/SaveMap", {"result": True}),
    "slam_toolbox/serialize_map": ("slam_toolbox/SerializePoseGraph", {"result": 0}),
}
SET_GRAPH = "route_server/set_route_graph"
MANAGER = "lifecycle_manager_navigation"
ACTIVE = f"{MANAGER}/is_active"
STATE = "get_state"
STATES = ["unknown", "unconfigured", "inactive", "active", "activating"]
CANCEL = "_action/cancel_goal"
MONITOR = "nav2_msgs/CollisionMonitorState"
STATUS = "action_msgs/GoalStatusArray"
LARGEST = 20_000_000
"""Bytes of a file of a graph that is read."""
LINES = ("LineString", "MultiLineString")
_ENDS = {
    SUCCEEDED: (INFO, "Goal succeeded"),
    CANCELED: (INFO, "Goal canceled"),
    ABORTED: (ERROR, "Goal failed"),
}


class Nav2Fleet(NavigatingFleet[SimNavigation]):
    """Robots that run Nav2 on the wire."""

    kind = "nav2"
    localise_service = "reinitialize_global_localization"
    mapping_service = "slam_toolbox/set_localization_mode"

    def __init__(
        self, robots: int, floors: int, seed: int = 0, quiet: bool = False, first: int = 0, step: int = 1
    ) -> None:
        super().__init__(SimNavigation, robots, floors, seed, quiet, first, step)
        if robots > 1:
            self.robots[next(reversed(self.robots))].percent = float("nan")
        self.route_servers = RouteServers()
        self.file_services = {**SAVES, SET_GRAPH: ("nav2_msgs/SetRouteGraph", self.route_servers.answer)}
        self._logged_statuses: dict[bytes, int] = {}
        self._logged_obstacles: set[str] = set()
        self._stopped = dict.fromkeys(self.robots, False)

    @cached_property
    def actions(self) -> Mapping[str, ActionServer]:
        return {
            server.name: server
            for navigation in self.navigation.values()
            for server in navigation.servers.values()
        }

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """Every topic; the collision monitor's is not latched."""
        yield from super().topics(loaded_at, dialect)
        for name, navigation in self.navigation.items():
            yield self.topic_on_change(name, "collision_monitor_state", MONITOR, dialect, latched=False)
            for server in navigation.servers.values():
                topic, alive = f"{server.verb}/_action/status", partial(_alive, server)
                yield self.topic_on_change(name, topic, STATUS, dialect, alive=alive)

    def stack_topics(self, navigation: SimNavigation, dialect: Dialect) -> Iterator[Topic]:
        """Its plan, and the feedback of its actions while they are carried out."""
        yield plan_topic(navigation.robot, dialect, "plan")
        for server in navigation.servers.values():
            yield robot_topic(
                navigation.robot,
                dialect,
                f"{server.verb}/_action/feedback",
                f"{server.type}_FeedbackMessage",
                partial(_feedback, navigation, server, headers(dialect)),
                fast=True,
                due=partial(_on_the_way, navigation, server),
            )

    def changes(
        self, name: str, navigation: SimNavigation, dialect: Dialect, now: float
    ) -> Iterator[tuple[str, Payload]]:
        robot = navigation.robot
        # The monitor looks at the robot's commanded twists: while it stands nothing changes.
        if robot.driving and (robot.obstacle > 0.0) != self._stopped[name]:
            self._stopped[name] = not self._stopped[name]
            value = messages.collision(self._stopped[name])
            yield f"/{name}/collision_monitor_state", raw_payload(dialect, MONITOR, now, value)
        for server in navigation.servers.values():
            while server.reports:
                value = messages.statuses(server.reports.popleft())
                yield f"{server.name}/_action/status", raw_payload(dialect, STATUS, now, value)

    def subscriptions(self) -> Subscriptions:
        """The goal_pose of each robot, where a pose becomes a goal, its initialpose and its twists."""
        return {
            **super().subscriptions(),
            **{
                f"/{name}/goal_pose": ("geometry_msgs/PoseStamped", partial(_take_pose, navigation))
                for name, navigation in self.navigation.items()
            },
        }

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        """Return for each robot whether Nav2 is active, the cancellation of goals, and set-up."""
        trigger = service_type(dialect, "std_srvs/Trigger")
        cancel = service_type(dialect, "action_msgs/CancelGoal")
        state = service_type(dialect, "lifecycle_msgs/GetState")
        return {
            **{f"/{name}/{ACTIVE}": trigger for name in self.robots},
            **{f"/{name}/{node}/{STATE}": state for name in self.robots for node in NODES},
            **{f"{action}/{CANCEL}": cancel for action in self.actions},
            **super().services(dialect),
        }

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        if service.endswith(ACTIVE):
            return {"success": self.navigation[service.split("/")[1]].active, "message": ""}
        if service.endswith(STATE):
            _, name, node, _ = service.split("/")
            label = self.navigation[name].state_of(node)
            return {"current_state": {"id": STATES.index(label), "label": label}}
        if not service.endswith(CANCEL):
            return super().answer(service, args)
        info = args["goal_info"]
        stamp = info["stamp"]["sec"] * messages.GIGA + info["stamp"]["nanosec"]
        server = self.actions[service.removesuffix(f"/{CANCEL}")]
        answer = server.cancel(bytes(info["goal_id"]["uuid"]), stamp)
        self._navigation_of(server).robot.left_for = TAKEN_OVER
        goals = [messages.goal_info(goal.id, goal.stamp) for goal in answer["goals_canceling"]]
        return answer | {"goals_canceling": goals}

    def feedback(self, server: ActionServer, goal: ServedGoal, dialect: Dialect) -> Message | None:
        navigation = self._navigation_of(server)
        if navigation.robot.silence or not navigation.publishes:
            return None
        _, at = messages.believed(navigation.robot, time.time())
        return messages.feedback(navigation, server.verb, goal, dialect.header(0, at, FRAME))

    def result(self, server: ActionServer, goal: ServedGoal) -> Message | None:
        navigation = self._navigation_of(server)
        return None if navigation.robot.silence else messages.result(goal, navigation.distro)

    def _navigation_of(self, server: ActionServer) -> SimNavigation:
        return self.navigation[server.name.split("/")[1]]

    def lines(self) -> Iterator[Line]:
        statuses: dict[bytes, int] = {}
        for name, navigation in self.navigation.items():
            lines = [*self._goal_lines(name, navigation, statuses), *self._obstacle_line(navigation.robot)]
            if not navigation.robot.silence:
                yield from lines
        self._logged_statuses = statuses

    def _goal_lines(self, name: str, navigation: SimNavigation, statuses: dict[bytes, int]) -> Iterator[Line]:
        while navigation.complaints:
            level, node, text = navigation.complaints.pop(0)
            yield level, f"/{name}/{node}", text
        for goal in navigation.servers[TO_POSE].goals.values():
            before, statuses[goal.id] = self._logged_statuses.get(goal.id), goal.status
            if before == goal.status:
                continue
            if goal.status == EXECUTING:
                at = goal.request["pose"]["pose"]["position"]
                message = f"Begin navigating from current location to ({at['x']:.2f}, {at['y']:.2f})"
                yield INFO, f"/{name}/bt_navigator", message
            elif goal.over:
                level, message = _ENDS[goal.status]
                code = goal.result.get("error_code")
                why = f" error_code:{code} error_msg:{goal.result['error_msg']}." if code else ""
                yield level, f"/{name}/bt_navigator", message + why

    def _obstacle_line(self, robot: NavigatingRobot) -> Iterator[Line]:
        blocked = robot.obstacle > 0.0
        if robot.driving and blocked != (robot.name in self._logged_obstacles):
            self._logged_obstacles ^= {robot.name}
            node = f"/{robot.name}/collision_monitor"
            if blocked:
                yield WARN, node, "Robot to stop due to PolygonStop polygon"
            else:
                yield INFO, node, "Robot to continue normal operation"

    def stack_health(self, name: str, navigation: SimNavigation) -> Iterator[Message]:
        """What its lifecycle manager publishes, by its full name."""
        yield {
            "level": HEALTHY,
            "name": f"/{name}/{MANAGER}: Nav2 Health",
            "message": f"Managed nodes are {'active' if navigation.active else 'inactive'}",
            "hardware_id": "Nav2",
            "values": [],
        }


def _take_pose(navigation: SimNavigation, message: Message) -> None:
    navigation.take(TO_POSE, {"pose": message, "behavior_tree": ""})


def _on_the_way(navigation: SimNavigation, server: ActionServer) -> bool:
    return navigation.publishes and bool(server.running)


def _feedback(navigation: SimNavigation, server: ActionServer, header: Header, now: float) -> Message:
    goal = server.running[-1]
    _, at = messages.believed(navigation.robot, now)
    values = messages.feedback(navigation, server.verb, goal, header(at))
    return {"goal_id": {"uuid": uuid_of(goal.id)}, "feedback": values}


def _alive(server: ActionServer) -> bool:
    return server.alive


class TakenGraph(NamedTuple):
    """The graph of a file: places of vertices by id, start and end of each edge."""

    path: str
    vertices: dict[int, tuple[float, float]]
    edges: tuple[tuple[int, int], ...]


class RouteServers:
    """The route servers of a fleet's robots. `graphs` are the ones that they took last, by robot."""

    def __init__(self) -> None:
        self.graphs: dict[str, TakenGraph] = {}

    def answer(self, robot: str, args: Mapping[str, Any]) -> Message:
        return {"success": self.load(robot, args["graph_filepath"])}

    def load(self, robot: str, path: str) -> bool:
        """Load a file, and tell whether it is a graph; a bad one leaves that before in use."""
        try:
            self.graphs[robot] = _read(path)
        except (OSError, ValueError, KeyError, TypeError, RecursionError):
            return False
        return True


def _read(path: str) -> TakenGraph:
    """Return the graph of a file. Raises OSError, ValueError, KeyError, TypeError, RecursionError."""
    if not Path(path).is_file():
        raise ValueError("no regular file")
    with Path(path).open("rb") as file:
        text = file.read(LARGEST + 1)
    if len(text) > LARGEST:
        raise ValueError("too large")
    features = json.loads(text)["features"]
    points = [one for one in features if one["geometry"]["type"] == "Point"]
    lines = [one["properties"] for one in features if one["geometry"]["type"] in LINES]
    vertices = {_id(one["properties"]["id"]): _place(one["geometry"]["coordinates"]) for one in points}
    edges = tuple((_id(one["startid"]), _id(one["endid"])) for one in lines)
    if not vertices or not edges or not {end for edge in edges for end in edge} <= vertices.keys():
        raise ValueError("no graph")
    return TakenGraph(path, vertices, edges)


def _id(value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or value < 0:
        raise ValueError("no id")
    return value


def _place(value: Any) -> tuple[float, float]:
    x, y, *_ = value
    return float(x), float(y)

"""A fleet with Nav2 as the bridge sees it: topics, actions, services."""

import json
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property, partial
from itertools import chain
from pathlib import Path
from typing import Any, NamedTuple

from fleet_tui.simulator.fleets import Line
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.logs import ERROR, HEALTHY, INFO, WARN
from fleet_tui.simulator.messages import Topic, raw_payload
from fleet_tui.simulator.nav2 import messages
from fleet_tui.simulator.nav2.navigation import NODES, TO_POSE, SimNavigation
from fleet_tui.simulator.nav2.world import Nav2World
from fleet_tui.simulator.navigating.diagnostics import health
from fleet_tui.simulator.navigating.messages import Header, headers
from fleet_tui.simulator.navigating.news import News
from fleet_tui.simulator.navigating.poses import FRAME
from fleet_tui.simulator.navigating.robot import TAKEN_OVER, NavigatingRobot
from fleet_tui.simulator.navigating.set_up import FileServices, SetUpDesk, by_hand
from fleet_tui.simulator.navigating.topics import body_topics, plan_topic, topic_maker
from fleet_tui.simulator.navigating.world import NavigatingWorld
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

Message = dict[str, Any]

SERVICES = "reinitialize_global_localization", "slam_toolbox/set_localization_mode"
"""Names of global localisation, and of the switch that ends mapping."""
SAVES: FileServices = {
    "map_saver/save_map": ("nav2_msgs/SaveMap", {"result": True}),
    "slam_toolbox/serialize_map": ("slam_toolbox/SerializePoseGraph", {"result": 0}),
}
MANAGER = "lifecycle_manager_navigation"
ACTIVE = f"{MANAGER}/is_active"
STATE = "get_state"
STATES = ["unknown", "unconfigured", "inactive", "active", "activating"]
CANCEL = "_action/cancel_goal"


_ENDS = {
    SUCCEEDED: (INFO, "Goal succeeded"),
    CANCELED: (INFO, "Goal canceled"),
    ABORTED: (ERROR, "Goal failed"),
}


SET_GRAPH = "route_server/set_route_graph"
TYPE = "nav2_msgs/SetRouteGraph"
LARGEST = 20_000_000
"""Bytes of a file that is read."""
LINES = ("LineString", "MultiLineString")


MONITOR = "nav2_msgs/CollisionMonitorState"
STATUS = "action_msgs/GoalStatusArray"


class Nav2Fleet(Nav2World):
    """The robots of a Nav2World on the wire."""

    kind = "nav2"

    def __init__(
        self, robots: int, floors: int, seed: int = 0, quiet: bool = False, first: int = 0, step: int = 1
    ) -> None:
        super().__init__(robots, floors, seed, quiet, first, time.time_ns, step)
        if robots > 1:
            self.robots[next(reversed(self.robots))].percent = float("nan")
        self.route_servers = RouteServers()
        self._set_up = SetUpDesk(self, *SERVICES, {**SAVES, SET_GRAPH: (TYPE, self.route_servers.answer)})
        self._news = Nav2News(self)
        self._changes = Nav2Changes(self)

    @cached_property
    def actions(self) -> Mapping[str, ActionServer]:
        """Every robot's action servers by name."""
        return {
            server.name: server
            for navigation in self.navigation.values()
            for server in navigation.servers.values()
        }

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """Every topic; the maps were loaded at this wall time."""
        yield from self._set_up.topics(loaded_at, dialect)
        yield from chain.from_iterable(steady_topics(each, dialect) for each in self.navigation.values())
        yield from self._news.topics(dialect)

    def subscriptions(self) -> Mapping[str, tuple[str, Callable[[Message], None]]]:
        """The goal_pose of each robot, where a pose becomes a goal, its initialpose and its twists."""
        return by_hand(self.robots) | {
            f"/{name}/goal_pose": ("geometry_msgs/PoseStamped", partial(_take_pose, navigation))
            for name, navigation in self.navigation.items()
        }

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        """Return for each robot whether Nav2 is active, the cancellation of goals, and set-up."""
        trigger, cancel = (
            service_type(dialect, name) for name in ("std_srvs/Trigger", "action_msgs/CancelGoal")
        )
        state = service_type(dialect, "lifecycle_msgs/GetState")
        return {f"/{name}/{ACTIVE}": trigger for name in self.robots} | {
            **{f"/{name}/{node}/{STATE}": state for name in self.robots for node in NODES},
            **{f"{action}/{CANCEL}": cancel for action in self.actions},
            **self._set_up.services(dialect),
        }

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        """The answer of a service; `args` complete and of the right types."""
        if service.endswith(ACTIVE):
            return {"success": self.navigation[service.split("/")[1]].active, "message": ""}
        if service.endswith(STATE):
            _, name, node, _ = service.split("/")
            label = self.navigation[name].state_of(node)
            return {"current_state": {"id": STATES.index(label), "label": label}}
        if (answer := self._set_up.answer(service, args)) is not None:
            return answer
        info = args["goal_info"]
        stamp = info["stamp"]["sec"] * messages.GIGA + info["stamp"]["nanosec"]
        server = self.actions[service.removesuffix(f"/{CANCEL}")]
        answer = server.cancel(bytes(info["goal_id"]["uuid"]), stamp)
        self.navigation[_robot_of(server)].robot.left_for = TAKEN_OVER
        goals = [messages.goal_info(goal.id, goal.stamp) for goal in answer["goals_canceling"]]
        return answer | {"goals_canceling": goals}

    def news(self, dialect: Dialect) -> Iterator[tuple[str, Payload]]:
        """Return all changes since the last call: positions, obstacles, goal states."""
        yield from self._news.take(dialect)
        yield from self._set_up.news(dialect)

    def feedback(self, server: ActionServer, goal: ServedGoal, dialect: Dialect) -> Message | None:
        """Return the feedback on a goal, None if the action sends none."""
        navigation = self.navigation[_robot_of(server)]
        if navigation.robot.silence or not navigation.publishes:
            return None
        return messages.feedback(
            navigation,
            server.verb,
            goal,
            dialect.header(0, messages.believed(navigation.robot, time.time())[1], FRAME),
        )

    def result(self, server: ActionServer, goal: ServedGoal) -> Message | None:
        """Return the result of an ended goal, None while the robot is silent."""
        navigation = self.navigation[_robot_of(server)]
        return None if navigation.robot.silence else messages.result(goal, navigation.distro)

    def lines(self) -> Iterable[Line]:
        """Return the log lines of Nav2's nodes for everything that happened since the last call."""
        return self._changes.lines()

    def health(self) -> Iterable[Message]:
        """Return battery and localisation of every robot that is not silent, and what its lifecycle manager
        publishes, by its full name."""
        for name, navigation in self.navigation.items():
            if not navigation.robot.silence:
                yield from health(navigation.robot)
                yield {
                    "level": HEALTHY,
                    "name": f"/{name}/{MANAGER}: Nav2 Health",
                    "message": f"Managed nodes are {'active' if navigation.active else 'inactive'}",
                    "hardware_id": "Nav2",
                    "values": [],
                }


def _robot_of(server: ActionServer) -> str:
    return server.name.split("/")[1]


def _take_pose(navigation: SimNavigation, message: Message) -> None:
    navigation.take(TO_POSE, {"pose": message, "behavior_tree": ""})


class Nav2Changes:
    """Detects the changes of robots between two calls."""

    def __init__(self, world: Nav2World) -> None:
        self._world = world
        self._statuses: dict[bytes, int] = {}
        self._blocked: set[str] = set()

    def lines(self) -> Iterator[Line]:
        statuses: dict[bytes, int] = {}
        for name, navigation in self._world.navigation.items():
            said = [*self._goals(name, navigation, statuses), *self._obstacle(navigation.robot)]
            if not navigation.robot.silence:
                yield from said
        self._statuses = statuses

    def _goals(self, name: str, navigation: SimNavigation, statuses: dict[bytes, int]) -> Iterator[Line]:
        while navigation.complaints:
            level, node, text = navigation.complaints.pop(0)
            yield level, f"/{name}/{node}", text
        for goal in navigation.servers[TO_POSE].goals.values():
            before, statuses[goal.id] = self._statuses.get(goal.id), goal.status
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

    def _obstacle(self, robot: NavigatingRobot) -> Iterator[Line]:
        blocked = robot.obstacle > 0.0
        if robot.driving and blocked != (robot.name in self._blocked):
            self._blocked ^= {robot.name}
            message = (
                "Robot to stop due to PolygonStop polygon"
                if blocked
                else "Robot to continue normal operation"
            )
            yield (WARN if blocked else INFO), f"/{robot.name}/collision_monitor", message


class TakenGraph(NamedTuple):
    """The graph of a file: places of vertices by id, start and end of each edge."""

    path: str
    vertices: dict[int, tuple[float, float]]
    edges: tuple[tuple[int, int], ...]


class RouteServers:
    """The route servers of a fleet's robots. `graphs` are the ones that they took last, by robot."""

    def __init__(self) -> None:
        self.graphs: dict[str, TakenGraph] = {}

    def answer(self, robot: str, args: Mapping[str, Any]) -> dict[str, Any]:
        """Carry out a call to a robot's server."""
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


def steady_topics(navigation: SimNavigation, dialect: Dialect) -> Iterator[Topic]:
    """The topics that one robot publishes continuously, or while it drives."""
    robot = navigation.robot
    yield from body_topics(robot, dialect)
    yield plan_topic(robot, dialect, "plan")
    for server in navigation.servers.values():
        yield topic_maker(robot, dialect)(
            f"{server.verb}/_action/feedback",
            f"{server.type}_FeedbackMessage",
            partial(_feedback, navigation, server, headers(dialect)),
            fast=True,
            due=partial(_on_the_way, navigation, server),
        )


def _on_the_way(navigation: SimNavigation, server: ActionServer) -> bool:
    return navigation.publishes and bool(server.running)


def _feedback(navigation: SimNavigation, server: ActionServer, header: Header, now: float) -> Message:
    goal = server.running[-1]
    values = messages.feedback(
        navigation, server.verb, goal, header(messages.believed(navigation.robot, now)[1])
    )
    return {"goal_id": {"uuid": uuid_of(goal.id)}, "feedback": values}


class Nav2News(News[SimNavigation]):
    """Topics on change: places, obstacles, the states of goals."""

    def __init__(self, world: NavigatingWorld[SimNavigation]) -> None:
        super().__init__(world)
        self._blocked = dict.fromkeys(world.robots, False)

    def topics(self, dialect: Dialect) -> Iterator[Topic]:
        """The topics; the collision monitor's is not latched."""
        yield from super().topics(dialect)
        monitor, status = dialect.message_type(MONITOR), dialect.message_type(STATUS)
        for name, navigation in self._world.navigation.items():
            yield self.topic(name, "collision_monitor_state", monitor, latched=False)
            for server in navigation.servers.values():
                yield self.topic(name, f"{server.verb}/_action/status", status, alive=partial(_alive, server))

    def of(
        self, name: str, navigation: SimNavigation, dialect: Dialect, now: float
    ) -> Iterator[tuple[str, Payload]]:
        """The obstacle and the goals of one robot."""
        robot = navigation.robot
        # The monitor looks at the robot's commanded twists: while it stands nothing changes.
        if robot.driving and (robot.obstacle > 0.0) != self._blocked[name]:
            self._blocked[name] = not self._blocked[name]
            value = messages.collision(self._blocked[name])
            yield f"/{name}/collision_monitor_state", raw_payload(dialect, MONITOR, now, value)
        for server in navigation.servers.values():
            while server.reports:
                value = messages.statuses(server.reports.popleft())
                yield f"{server.name}/_action/status", raw_payload(dialect, STATUS, now, value)


def _alive(server: ActionServer) -> bool:
    return server.alive

"""A fleet with Nav2 as the bridge sees it: topics, actions, services."""

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property, partial
from itertools import chain
from typing import Any

from fleet_tui.simulator.fleets import Line
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.nav2 import messages
from fleet_tui.simulator.nav2.logs import Nav2Changes
from fleet_tui.simulator.nav2.navigation import NODES, TO_POSE, SimNavigation
from fleet_tui.simulator.nav2.route_server import SET_GRAPH, TYPE, RouteServers
from fleet_tui.simulator.nav2.topics import Nav2News, steady_topics
from fleet_tui.simulator.nav2.world import Nav2World
from fleet_tui.simulator.navigating.diagnostics import health
from fleet_tui.simulator.navigating.poses import FRAME
from fleet_tui.simulator.navigating.robot import TAKEN_OVER
from fleet_tui.simulator.navigating.set_up import FileServices, SetUpDesk, by_hand
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.goals import ActionServer, ServedGoal
from fleet_tui.simulator.ros_types import ServiceType, service_type

Message = dict[str, Any]

SERVICES = "reinitialize_global_localization", "slam_toolbox/set_localization_mode"
"""Names of global localisation, and of the switch that ends mapping."""
SAVES: FileServices = {
    "map_saver/save_map": ("nav2_msgs/SaveMap", {"result": True}),
    "slam_toolbox/serialize_map": ("slam_toolbox/SerializePoseGraph", {"result": 0}),
}
ACTIVE = "lifecycle_manager_navigation/is_active"
STATE = "get_state"
STATES = ["unknown", "unconfigured", "inactive", "active", "activating"]
CANCEL = "_action/cancel_goal"


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
        """Return battery and localisation of every robot that is not silent."""
        return (entry for robot in self.robots.values() if not robot.silence for entry in health(robot))


def _robot_of(server: ActionServer) -> str:
    return server.name.split("/")[1]


def _take_pose(navigation: SimNavigation, message: Message) -> None:
    navigation.take(TO_POSE, {"pose": message, "behavior_tree": ""})

"""The topics of robots with Nav2: those published continuously, and those only on change."""

from collections.abc import Iterator
from functools import partial
from typing import Any

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic, raw_payload
from fleet_tui.simulator.nav2 import messages
from fleet_tui.simulator.nav2.navigation import SimNavigation
from fleet_tui.simulator.navigating.messages import Header, headers
from fleet_tui.simulator.navigating.news import News
from fleet_tui.simulator.navigating.topics import body_topics, plan_topic, topic_maker
from fleet_tui.simulator.navigating.world import NavigatingWorld
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.goals import ActionServer, uuid_of

Message = dict[str, Any]

MONITOR = "nav2_msgs/CollisionMonitorState"
STATUS = "action_msgs/GoalStatusArray"


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

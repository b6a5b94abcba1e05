"""A fleet with move_base as the bridge sees it: goals and results are topics."""

import time
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from itertools import chain, count
from typing import Any

from fleet_tui.simulator.fleets import Line
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic, raw_payload
from fleet_tui.simulator.move_base.navigation import MoveBaseWorld, SimMoveBase, feedback, result, statuses
from fleet_tui.simulator.navigating.diagnostics import health
from fleet_tui.simulator.navigating.messages import Header, headers
from fleet_tui.simulator.navigating.news import News
from fleet_tui.simulator.navigating.set_up import SetUpDesk, by_hand
from fleet_tui.simulator.navigating.topics import body_topics, plan_topic, topic_maker
from fleet_tui.simulator.navigating.world import NavigatingWorld
from fleet_tui.simulator.ros.actionlib import GoalReport
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.filling import ServiceType, service_type
from fleet_tui.simulator.ros.goals import ActionServer, ServedGoal

Message = dict[str, Any]

SAVES: Mapping[str, tuple[str, Message]] = {
    "slam_toolbox/save_map": ("slam_toolbox_msgs/SaveMap", {}),
    "slam_toolbox/serialize_map": ("slam_toolbox_msgs/SerializePoseGraph", {}),
}


NODE = "move_base"
GOAL = f"{NODE}/goal"
POSE = f"{NODE}_simple/goal"
CANCEL = f"{NODE}/cancel"
STATUS, RESULT, FEEDBACK = (f"{NODE}/{part}" for part in ("status", "result", "feedback"))
BEGUN = f"{NODE}/current_goal"
TYPES = {
    GOAL: "move_base_msgs/MoveBaseActionGoal",
    POSE: "geometry_msgs/PoseStamped",
    CANCEL: "actionlib_msgs/GoalID",
    STATUS: "actionlib_msgs/GoalStatusArray",
    RESULT: "move_base_msgs/MoveBaseActionResult",
    FEEDBACK: "move_base_msgs/MoveBaseActionFeedback",
    BEGUN: "geometry_msgs/PoseStamped",
}
BEAT = 0.2  # seconds between two status messages without a change
EARLY = 0.05  # seconds by which a status message may be early


class MoveBaseFleet(MoveBaseWorld):
    """The robots of a MoveBaseWorld on the wire."""

    kind = "move_base"
    actions: Mapping[str, ActionServer] = {}

    def __init__(
        self, robots: int, floors: int, seed: int = 0, quiet: bool = False, first: int = 0, step: int = 1
    ) -> None:
        super().__init__(robots, floors, seed, quiet, first, time.time_ns, step)
        self._set_up = SetUpDesk(self, "global_localization", "pause_mapping", SAVES)
        self._news = MoveBaseNews(self)

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """Every topic; the maps were loaded at this wall time."""
        yield from self._set_up.topics(loaded_at, dialect)
        yield from chain.from_iterable(steady_topics(each, dialect) for each in self.navigation.values())
        yield from self._news.topics(dialect)

    def subscriptions(self) -> Mapping[str, tuple[str, Callable[[Message], None]]]:
        """The goals, poses, twists and cancellations for each robot."""
        return by_hand(self.robots) | {
            f"/{name}/{part}": (TYPES[part], take)
            for name, navigation in self.navigation.items()
            for part, take in (
                (GOAL, navigation.receive_goal),
                (POSE, navigation.receive_pose),
                (CANCEL, navigation.receive_cancel),
            )
        }

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        """Return for each robot the service that clears its costmaps, which does nothing here."""
        return {
            f"/{name}/{NODE}/clear_costmaps": service_type(dialect, "std_srvs/Empty") for name in self.robots
        } | self._set_up.services(dialect)

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        """The answer of a service of set-up, nothing for any other."""
        return self._set_up.answer(service, args) or {}

    def news(self, dialect: Dialect) -> Iterator[tuple[str, Payload]]:
        """Return all changes since the last call, and the status at regular intervals."""
        yield from self._news.take(dialect)
        yield from self._set_up.news(dialect)

    def feedback(self, server: ActionServer, goal: ServedGoal, dialect: Dialect) -> Message | None:
        """Do nothing: such robots have no ROS 2 actions."""

    def result(self, server: ActionServer, goal: ServedGoal) -> Message | None:
        """Nothing."""

    def lines(self) -> Iterator[Line]:
        """Return the log lines of move_base for everything that happened since the last call."""
        for name, navigation in self.navigation.items():
            lines = list(navigation.lines)
            navigation.lines.clear()
            if not navigation.robot.silence:
                yield from ((level, f"/{name}/{NODE}", message) for level, message in lines)

    def health(self) -> Iterable[Message]:
        """Return battery and localisation of every robot that is not silent."""
        return (entry for robot in self.robots.values() if not robot.silence for entry in health(robot))


def steady_topics(navigation: SimMoveBase, dialect: Dialect) -> Iterator[Topic]:
    """The topics that one robot publishes continuously, or while it drives."""
    robot = navigation.robot
    yield from body_topics(robot, dialect)
    yield plan_topic(robot, dialect, f"{NODE}/NavfnROS/plan")
    yield topic_maker(robot, dialect)(
        FEEDBACK,
        TYPES[FEEDBACK],
        partial(_feedback, navigation, headers(dialect, ""), headers(dialect)),
        fast=True,
        due=lambda: navigation.publishes and _under_way(navigation),
    )


def _under_way(navigation: SimMoveBase) -> bool:
    current = navigation.server.current
    return current is not None and not current.over


def _feedback(navigation: SimMoveBase, header: Header, at: Header, now: float) -> Message:
    goal = navigation.server.current
    assert goal is not None
    return feedback(goal.report, navigation.robot, header(now), at(now))


class MoveBaseNews(News[SimMoveBase]):
    """Topics on change: places, the states of goals, goals that begin."""

    def __init__(self, world: NavigatingWorld[SimMoveBase]) -> None:
        super().__init__(world)
        self._beat = dict.fromkeys(world.robots, 0.0)
        self._counts: dict[str, count[int]] = defaultdict(lambda: count(1))

    def topics(self, dialect: Dialect) -> Iterator[Topic]:
        """The topics; of those of move_base the status alone is latched."""
        yield from super().topics(dialect)
        for name, navigation in self._world.navigation.items():
            for part in (STATUS, RESULT, BEGUN, GOAL):
                type_ = dialect.message_type(TYPES[part])
                yield self.topic(name, part, type_, part == STATUS, partial(_alive, navigation))

    def of(
        self, name: str, navigation: SimMoveBase, dialect: Dialect, now: float
    ) -> Iterator[tuple[str, Payload]]:
        """The goals of one robot, and its status at regular intervals."""
        for part, poses in ((GOAL, navigation.forwarded), (BEGUN, navigation.begun)):
            while poses:
                yield self._news(name, part, dialect, now, poses.popleft())
        said = navigation.server.said
        if navigation.alive and now >= self._beat[name] - EARLY:
            late = now - self._beat[name] > BEAT
            self._beat[name] = (now if late else self._beat[name]) + BEAT
            said.append(navigation.server.listed())
        while said:
            yield self._of_report(name, said.popleft(), dialect, now)

    def _of_report(
        self, name: str, said: GoalReport | list[GoalReport], dialect: Dialect, now: float
    ) -> tuple[str, Payload]:
        part = STATUS if isinstance(said, list) else RESULT
        header = dialect.header(next(self._counts[f"{name}/{part}"]), now, "")
        value = statuses(said, header) if isinstance(said, list) else result(said, header)
        return self._news(name, part, dialect, now, value)

    def _news(
        self, name: str, part: str, dialect: Dialect, now: float, value: Message
    ) -> tuple[str, Payload]:
        return f"/{name}/{part}", raw_payload(dialect, TYPES[part], now, value)


def _alive(navigation: SimMoveBase) -> bool:
    return navigation.alive

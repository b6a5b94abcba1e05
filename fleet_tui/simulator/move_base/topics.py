"""The topics of robots with move_base: those published continuously, and those only on change."""

from collections import defaultdict
from collections.abc import Iterator
from functools import partial
from itertools import count
from typing import Any

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic, raw_payload
from fleet_tui.simulator.move_base import messages
from fleet_tui.simulator.move_base.navigation import SimMoveBase
from fleet_tui.simulator.navigating.messages import Header, headers
from fleet_tui.simulator.navigating.news import News
from fleet_tui.simulator.navigating.topics import body_topics, plan_topic, topic_maker
from fleet_tui.simulator.navigating.world import NavigatingWorld
from fleet_tui.simulator.ros.actionlib import GoalReport
from fleet_tui.simulator.ros.dialect import Dialect

Message = dict[str, Any]

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
    return messages.feedback(goal.report, navigation.robot, header(now), at(now))


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
        value = messages.statuses(said, header) if isinstance(said, list) else messages.result(said, header)
        return self._news(name, part, dialect, now, value)

    def _news(
        self, name: str, part: str, dialect: Dialect, now: float, value: Message
    ) -> tuple[str, Payload]:
        return f"/{name}/{part}", raw_payload(dialect, TYPES[part], now, value)


def _alive(navigation: SimMoveBase) -> bool:
    return navigation.alive

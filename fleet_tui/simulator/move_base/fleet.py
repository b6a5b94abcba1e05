"""A fleet with move_base as the bridge sees it: goals and results are topics."""

from collections import defaultdict
from collections.abc import Iterator, Mapping
from functools import partial
from itertools import count
from typing import Any

from fleet_tui.simulator.fleets import Line, Subscriptions
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Header, Message, Topic, headers, raw_payload
from fleet_tui.simulator.move_base.navigation import SimMoveBase, feedback, result, statuses
from fleet_tui.simulator.navigating.fleet import FileServices, NavigatingFleet, plan_topic, robot_topic
from fleet_tui.simulator.ros.actionlib import GoalReport
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.filling import ServiceType, service_type

SAVES: FileServices = {
    "slam_toolbox/save_map": ("slam_toolbox_msgs/SaveMap", {}),
    "slam_toolbox/serialize_map": ("slam_toolbox_msgs/SerializePoseGraph", {}),
}
NODE = "move_base"
GOAL = f"{NODE}/goal"
POSE = f"{NODE}_simple/goal"
CANCEL = f"{NODE}/cancel"
STATUS = f"{NODE}/status"
RESULT = f"{NODE}/result"
FEEDBACK = f"{NODE}/feedback"
BEGUN = f"{NODE}/current_goal"
CLEAR = f"{NODE}/clear_costmaps"
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


class MoveBaseFleet(NavigatingFleet[SimMoveBase]):
    """Robots that run move_base on the wire."""

    kind = "move_base"
    localise_service = "global_localization"
    mapping_service = "pause_mapping"
    file_services = SAVES

    def __init__(
        self, robots: int, floors: int, seed: int = 0, quiet: bool = False, first: int = 0, step: int = 1
    ) -> None:
        super().__init__(SimMoveBase, robots, floors, seed, quiet, first, step)
        self._beat = dict.fromkeys(self.robots, 0.0)
        self._counts: dict[str, count[int]] = defaultdict(lambda: count(1))

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """Every topic; of those of move_base the status alone is latched."""
        yield from super().topics(loaded_at, dialect)
        for name, navigation in self.navigation.items():
            for part in (STATUS, RESULT, BEGUN, GOAL):
                alive = partial(_alive, navigation)
                yield self.topic_on_change(name, part, TYPES[part], dialect, part == STATUS, alive)

    def stack_topics(self, navigation: SimMoveBase, dialect: Dialect) -> Iterator[Topic]:
        """Its plan, and its feedback while it drives."""
        yield plan_topic(navigation.robot, dialect, f"{NODE}/NavfnROS/plan")
        yield robot_topic(
            navigation.robot,
            dialect,
            FEEDBACK,
            TYPES[FEEDBACK],
            partial(_feedback, navigation, headers(dialect, ""), headers(dialect)),
            fast=True,
            due=lambda: navigation.publishes and _under_way(navigation),
        )

    def subscriptions(self) -> Subscriptions:
        return {
            **super().subscriptions(),
            **{
                f"/{name}/{part}": (TYPES[part], take)
                for name, navigation in self.navigation.items()
                for part, take in (
                    (GOAL, navigation.receive_goal),
                    (POSE, navigation.receive_pose),
                    (CANCEL, navigation.receive_cancel),
                )
            },
        }

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        """Return for each robot the service that clears its costmaps, which does nothing here, and set-up."""
        empty = service_type(dialect, "std_srvs/Empty")
        return {**{f"/{name}/{CLEAR}": empty for name in self.robots}, **super().services(dialect)}

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        return {} if service.endswith(CLEAR) else super().answer(service, args)

    def changes(
        self, name: str, navigation: SimMoveBase, dialect: Dialect, now: float
    ) -> Iterator[tuple[str, Payload]]:
        """The goals of one robot, and its status at regular intervals."""
        for part, poses in ((GOAL, navigation.forwarded), (BEGUN, navigation.begun)):
            while poses:
                yield _news(name, part, dialect, now, poses.popleft())
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
        return _news(name, part, dialect, now, value)

    def lines(self) -> Iterator[Line]:
        for name, navigation in self.navigation.items():
            lines = list(navigation.lines)
            navigation.lines.clear()
            if not navigation.robot.silence:
                yield from ((level, f"/{name}/{NODE}", message) for level, message in lines)


def _news(name: str, part: str, dialect: Dialect, now: float, value: Message) -> tuple[str, Payload]:
    return f"/{name}/{part}", raw_payload(dialect, TYPES[part], now, value)


def _under_way(navigation: SimMoveBase) -> bool:
    current = navigation.server.current
    return current is not None and not current.over


def _feedback(navigation: SimMoveBase, header: Header, at: Header, now: float) -> Message:
    goal = navigation.server.current
    assert goal is not None
    return feedback(goal.report, navigation.robot, header(now), at(now))


def _alive(navigation: SimMoveBase) -> bool:
    return navigation.alive

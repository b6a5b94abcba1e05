"""A fleet with move_base as the bridge sees it: goals and results are topics."""

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import chain
from typing import Any

from fleet_tui.simulator.fleets import Line
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic
from fleet_tui.simulator.move_base.topics import CANCEL, GOAL, NODE, POSE, TYPES, MoveBaseNews, steady_topics
from fleet_tui.simulator.move_base.world import MoveBaseWorld
from fleet_tui.simulator.navigating.diagnostics import health
from fleet_tui.simulator.navigating.set_up import SetUpDesk, by_hand
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.goals import ActionServer, ServedGoal
from fleet_tui.simulator.ros_types import ServiceType, service_type

Message = dict[str, Any]

SAVES: Mapping[str, tuple[str, Message]] = {
    "slam_toolbox/save_map": ("slam_toolbox_msgs/SaveMap", {}),
    "slam_toolbox/serialize_map": ("slam_toolbox_msgs/SerializePoseGraph", {}),
}


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

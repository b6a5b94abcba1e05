"""A World as the bridge sees it."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import Any

from fleet_tui.simulator.faults import FAULTS
from fleet_tui.simulator.fleets import Line
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Message, Topic, topics_of
from fleet_tui.simulator.oh_ressources.logs import Changes, health
from fleet_tui.simulator.oh_ressources.set_up import SUBSCRIPTIONS
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.robot import SimRobot
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.goals import ActionServer, ServedGoal
from fleet_tui.simulator.ros_types import ServiceType, robot_services

DESK = "Application_layout"


class OhFleet:
    """The robots of a World on the wire. They have no actions."""

    faults = FAULTS

    def __init__(self, world: World) -> None:
        self.world, self.troubles = world, world.troubles
        self.actions: Mapping[str, ActionServer] = {}
        self._changes = Changes(world.robots)

    @property
    def robots(self) -> Mapping[str, SimRobot]:
        """The world's robots."""
        return self.world.robots

    def step(self, dt: float) -> None:
        """Advance the time by dt seconds."""
        self.world.step(dt)

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """Every topic of the world."""
        return topics_of(self.world, loaded_at, dialect)

    def subscriptions(self) -> Mapping[str, tuple[str, Callable[[Message], None]]]:
        """The topics of each robot on which its pose is set, and a goal beside its orders."""
        return {
            f"/{name}/{topic}": (type_, partial(take, robot))
            for name, robot in self.robots.items()
            for topic, (type_, take) in SUBSCRIPTIONS.items()
        }

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        """The services of every robot."""
        types = robot_services(dialect).items()
        return {f"/{robot}/{DESK}/{verb}": type_ for robot in self.robots for verb, type_ in types}

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        """The world's answer."""
        return self.world.answer(service, args)

    def feedback(self, server: ActionServer, goal: ServedGoal, dialect: Dialect) -> Message | None:
        """Nothing."""

    def result(self, server: ActionServer, goal: ServedGoal) -> Message | None:
        """Nothing."""

    def news(self, dialect: Dialect) -> Iterable[tuple[str, Payload]]:
        """Return nothing: all topics are published continuously."""
        return ()

    def lines(self) -> Iterable[Line]:
        """Return the log lines for everything that happened since the last call."""
        return self._changes.lines()

    def health(self) -> Iterable[Message]:
        """Return three entries for every robot that is not silent."""
        return (entry for robot in self.robots.values() if not robot.silence for entry in health(robot))

"""A World as the bridge sees it."""

import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import Any

from fleet_tui.simulator.fleets import Line
from fleet_tui.simulator.floorplan import Cells
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Message, Topic, headers_of, map_of, topics_of
from fleet_tui.simulator.oh_ressources.graphs import SentGraphs
from fleet_tui.simulator.oh_ressources.logs import Changes, health
from fleet_tui.simulator.oh_ressources.set_up import SUBSCRIPTIONS
from fleet_tui.simulator.oh_ressources.world import World
from fleet_tui.simulator.robot import SimRobot
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.goals import ActionServer, ServedGoal
from fleet_tui.simulator.ros_types import ServiceType, robot_services, service_type
from fleet_tui.simulator.senses.camera import camera_topic
from fleet_tui.simulator.senses.laser import scan_topic
from fleet_tui.simulator.senses.mapping import Surveys
from fleet_tui.simulator.senses.wheels import twists
from fleet_tui.simulator.warehouse import SimFloor

DESK = "Application_layout"
MAPPING = "set_mapping"
SAVE = "save_map"


def _cells_of(robot: SimRobot) -> Callable[[], Cells]:
    return lambda: robot.floor.cells


class OhFleet:
    """The robots of a World on the wire. They have no actions."""

    kind = "oh_ressources"

    def __init__(self, world: World) -> None:
        self.world = world
        self.troubles = world.troubles
        self.actions: Mapping[str, ActionServer] = {}
        self._graphs = SentGraphs(world)
        self._changes = Changes(world.robots)
        self._surveys = Surveys(world.robots, self._map_topics)
        self.troubles.append(self._surveys.step)

    @property
    def robots(self) -> Mapping[str, SimRobot]:
        """The world's robots."""
        return self.world.robots

    def step(self, dt: float) -> None:
        """Advance the time by dt seconds."""
        self.world.step(dt)

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterator[Topic]:
        """Every topic of the world."""
        yield from topics_of(self.world, loaded_at, dialect, self._surveys.cells)
        yield from self._surveys.topics(dialect)
        for robot in self.robots.values():
            yield scan_topic(robot, _cells_of(robot), headers_of(robot, dialect), dialect)
            yield camera_topic(robot, _cells_of(robot), headers_of(robot, dialect, "camera"), dialect)

    def _map_topics(self, floor: SimFloor) -> list[str]:
        return [f"/{robot}/{floor.name}/map" for robot in self.robots]

    def subscriptions(self) -> Mapping[str, tuple[str, Callable[[Message], None]]]:
        """The topics of each robot for its pose, a goal beside its orders, twists, and a graph."""
        return {
            f"/{name}/{topic}": (type_, partial(take, robot))
            for name, robot in self.robots.items()
            for topic, (type_, take) in SUBSCRIPTIONS.items()
        } | {**self._graphs.subscriptions(), **twists(self.robots)}

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        """The services of every robot."""
        types = robot_services(dialect).items()
        switch = service_type(dialect, "std_srvs/SetBool")
        offered = {f"/{robot}/{DESK}/{verb}": type_ for robot in self.robots for verb, type_ in types}
        save = service_type(dialect, "slam_toolbox_msgs/SaveMap")
        own = {MAPPING: switch, SAVE: save}
        return offered | {f"/{robot}/{part}": type_ for robot in self.robots for part, type_ in own.items()}

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        """The world's answer, or that of the switch of mapping, or of a map that is saved."""
        if service.endswith(f"/{SAVE}"):
            return {}
        if service.endswith(f"/{MAPPING}"):
            self._surveys.switch(service.split("/")[1], on=args["data"])
            return {"success": True, "message": ""}
        return self.world.answer(service, args)

    def feedback(self, server: ActionServer, goal: ServedGoal, dialect: Dialect) -> Message | None:
        """Nothing."""

    def result(self, server: ActionServer, goal: ServedGoal) -> Message | None:
        """Nothing."""

    def news(self, dialect: Dialect) -> Iterable[tuple[str, Payload]]:
        """Return modes, graphs and live maps that changed: all other topics are published continuously."""
        now = time.time()
        yield from self._graphs.news()
        yield from self._surveys.news(lambda floor: map_of(floor, now, dialect, self._surveys.cells))

    def lines(self) -> Iterable[Line]:
        """Return the log lines for everything that happened since the last call."""
        return self._changes.lines()

    def health(self) -> Iterable[Message]:
        """Return three entries for every robot that is not silent."""
        return (entry for robot in self.robots.values() if not robot.silence for entry in health(robot))

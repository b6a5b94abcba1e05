"""Simulated robots that navigate, advanced step by step: no I/O, random only by the seed."""

import random
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import Generic, Protocol, TypeVar

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.robot import LOW, STEP, robot_numbers
from fleet_tui.simulator.warehouse import build_building

Clock = Callable[[], int]
"""The time in nanoseconds since 1970."""


class Navigating(Protocol):
    """The navigation stack of one robot."""

    robot: NavigatingRobot

    @property
    def busy(self) -> bool:
        """Tell whether it has a goal."""

    def step(self, dt: float) -> None:
        """Bring its goals on, after the robot has lived for dt seconds."""

    def give(self, x: float, y: float, yaw: float = 0.0) -> object:
        """Send it a goal as another client would."""

    def cancel_all(self) -> object:
        """Cancel its goals as another client would."""


N = TypeVar("N", bound=Navigating)


class NavigatingWorld(ABC, Generic[N]):
    """`robots` robots on `floors` floors, the numbers in their names from `first` on, each `step`th.

    `quiet`: no goals of other clients, no obstacles, no silence. `clock`: the wall time, for the goals'
    stamps; where None it is the world's own. Every second robot is driven by another client, who leaves the
    others alone.
    """

    def __init__(
        self,
        robots: int,
        floors: int,
        seed: int = 0,
        quiet: bool = False,
        first: int = 0,
        clock: Clock | None = None,
        step: int = 1,
    ) -> None:
        self._rng = random.Random(seed)
        self._quiet = quiet
        self.building = build_building(floors)
        self.robots = {f"robot_{i}": self._new_robot(i) for i in robot_numbers(robots, first, step)}
        self.time = 0.0
        """Seconds since the start."""
        ids = random.Random(seed)
        self.navigation: Mapping[str, N] = {
            name: self.navigate(robot, ids, clock or (lambda: round(self.time * 1e9)))
            for name, robot in self.robots.items()
        }
        """The navigation stack of each robot."""
        self.troubles: list[Callable[[float], None]] = []
        """Called at every step with the seconds that pass."""
        self._owed = 0.0
        self._silence_in = self._rng.uniform(180.0, 240.0)
        self._rest = {name: self._rng.uniform(6.0, 15.0) for name in self.robots}

    @abstractmethod
    def navigate(self, robot: NavigatingRobot, ids: random.Random, clock: Clock) -> N:
        """Make the navigation stack of a robot."""

    def step(self, dt: float) -> None:
        """Let dt seconds pass, in steps of fixed length; a remainder waits for the next call."""
        self._owed += dt
        while self._owed > STEP - 1e-9:
            self._owed -= STEP
            self.time += STEP
            for name, robot in self.robots.items():
                robot.step()
                self.navigation[name].step(STEP)
            for trouble in self.troubles:
                trouble(STEP)
            if not self._quiet:
                self._employ()
                self._silence()

    def _new_robot(self, index: int) -> NavigatingRobot:
        """Robots start in turn on all floors, spread over the vertices."""
        turn, number = divmod(index, len(self.building.floors))
        floor = self.building.floors[number]
        vertices = tuple(floor.graph.vertices.values())
        # Without a common factor with the number of vertices, so that none is taken twice before all are.
        spot = vertices[(13 * turn + 3 * number) % len(vertices)]
        pose = Pose(spot.x, spot.y, self._rng.uniform(-3.0, 3.0))
        return NavigatingRobot(index, floor, pose, self._rng, self._quiet)

    def _employ(self) -> None:
        """Send every second idle robot a goal, as another client would; dock those with a low battery."""
        for name, robot in self.robots.items():
            navigation = self.navigation[name]
            if robot.driving or navigation.busy or robot.left_for:
                continue
            if robot.battery < LOW and not robot.docked:
                self._assign(navigation, is_low=True)
            self._rest[name] -= STEP
            if robot.index % 2 and self._rest[name] <= 0.0 and robot.battery > 2 * LOW:
                self._rest[name] = self._rng.uniform(10.0, 30.0)
                self._assign(navigation, is_low=False)

    def _silence(self) -> None:
        """Silence one robot briefly every 3 to 4 minutes, as during a Wi-Fi handover."""
        self._silence_in -= STEP
        if self._silence_in <= 0.0 and self.robots:
            self._silence_in = self._rng.uniform(180.0, 240.0)
            self._rng.choice(tuple(self.robots.values())).silence = self._rng.uniform(1.0, 3.0)

    def _assign(self, navigation: N, is_low: bool) -> None:
        """Send a robot that is low to its charger, another one to a labelled vertex."""
        floor = navigation.robot.floor
        if is_low:
            charger = floor.graph.vertices[floor.vertex_of("charger")]
            navigation.give(charger.x, charger.y)
        else:
            spot = floor.graph.vertices[self._rng.choice(tuple(floor.labels))]
            navigation.give(spot.x, spot.y, self._rng.uniform(-3.0, 3.0))

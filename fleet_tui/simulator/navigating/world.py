"""Simulated robots that navigate, whichever navigation stack they run. Pure."""

import random
from collections.abc import Callable, Mapping
from typing import Generic, Protocol, TypeVar

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.robot import LOW, STEP
from fleet_tui.simulator.world import SimWorld

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

    def employ(self, rng: random.Random) -> None:
        """Send it to a labelled vertex, or to several, as another client would."""

    def recharge(self) -> None:
        """Send it to its charger, as another client would."""


N = TypeVar("N", bound=Navigating)
NewStack = Callable[[NavigatingRobot, random.Random, Clock], N]
"""Makes the navigation stack of a robot, from random numbers for its ids, and a clock for its stamps."""


class NavigatingWorld(SimWorld[NavigatingRobot], Generic[N]):
    """Robots that run `stack`. Every second one is driven by another client, who leaves the others alone.
    `clock`: the wall time, where None it is the world's own."""

    def __init__(
        self,
        stack: NewStack[N],
        robots: int,
        floors: int,
        seed: int = 0,
        quiet: bool = False,
        first: int = 0,
        step: int = 1,
        clock: Clock | None = None,
    ) -> None:
        super().__init__(robots, floors, seed, quiet, first, step)
        ids = random.Random(seed)
        self.navigation: Mapping[str, N] = {
            name: stack(robot, ids, clock or (lambda: round(self.time * 1e9)))
            for name, robot in self.robots.items()
        }
        """The navigation stack of each robot."""
        self._silence_in = self._rng.uniform(180.0, 240.0)
        self._rest = {name: self._rng.uniform(6.0, 15.0) for name in self.robots}

    def _live(self) -> None:
        for name, robot in self.robots.items():
            robot.step()
            self.navigation[name].step(STEP)

    def _new_robot(self, turn: int, index: int) -> NavigatingRobot:
        floor, vertex = self._start_of(index)
        spot = floor.graph.vertices[vertex]
        pose = Pose(spot.x, spot.y, self._rng.uniform(-3.0, 3.0))
        return NavigatingRobot(index, floor, pose, self._rng, self._quiet)

    def _employ(self) -> None:
        for name, robot in self.robots.items():
            navigation = self.navigation[name]
            if robot.driving or navigation.busy or robot.left_for:
                continue
            if robot.battery < LOW and not robot.docked:
                navigation.recharge()
            self._rest[name] -= STEP
            if robot.index % 2 and self._rest[name] <= 0.0 and robot.battery > 2 * LOW:
                self._rest[name] = self._rng.uniform(10.0, 30.0)
                navigation.employ(self._rng)

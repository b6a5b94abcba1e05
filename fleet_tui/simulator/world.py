"""What all simulated worlds share: time that passes in steps. No clock, no I/O, random only by the seed."""

import math
import random
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Generic, Protocol, TypeVar

from fleet_tui.simulator.robot import STEP
from fleet_tui.simulator.senses.wheels import Wheels
from fleet_tui.simulator.warehouse import SimFloor, build_building


class Body(Protocol):
    """A robot of any kind."""

    name: str
    index: int
    silence: float
    """Seconds for which none of the robot's topics are published."""
    wheels: Wheels


B = TypeVar("B", bound=Body)


class SimWorld(ABC, Generic[B]):
    """`robots` robots on `floors` floors, the numbers in their names from `first` on, each `step`th.

    The same seed with the same calls at the same steps gives the same run. `quiet`: no orders of other
    clients, no obstacles, no silence, no low batteries.
    """

    _silence_in = math.inf
    """Seconds until the next robot falls silent."""

    def __init__(
        self, robots: int, floors: int, seed: int = 0, quiet: bool = False, first: int = 0, step: int = 1
    ) -> None:
        self._rng = random.Random(seed)
        self._quiet = quiet
        self.building = build_building(floors)
        numbers = range(first, first + robots * step, step)
        made = [self._new_robot(turn, number) for turn, number in enumerate(numbers)]
        self.robots: dict[str, B] = {robot.name: robot for robot in made}
        self.time = 0.0
        """Seconds since the start."""
        self.troubles: list[Callable[[float], None]] = []
        """Called at every step with the seconds that pass."""
        self._owed = 0.0

    def step(self, dt: float) -> None:
        """Let dt seconds pass, in steps of fixed length; a remainder waits for the next call."""
        self._owed += dt
        while self._owed > STEP - 1e-9:
            self._owed -= STEP
            self.time += STEP
            self._live()
            for trouble in self.troubles:
                trouble(STEP)
            if not self._quiet:
                self._employ()
                self._silence()

    def _start_of(self, index: int) -> tuple[SimFloor, int]:
        """Return the floor and the id of the vertex where a robot starts: in turn on all floors, spread over
        the vertices."""
        row, number = divmod(index, len(self.building.floors))
        floor = self.building.floors[number]
        vertices = tuple(floor.graph.vertices)
        # Without a common factor with the number of vertices, so that none is taken twice before all are.
        return floor, vertices[(13 * row + 3 * number) % len(vertices)]

    @abstractmethod
    def _new_robot(self, turn: int, index: int) -> B:
        """Make the robot with this number, whose turn it is among those of the world."""

    @abstractmethod
    def _live(self) -> None:
        """Let the robots, and what else is there, live for a step."""

    @abstractmethod
    def _employ(self) -> None:
        """Give idle robots work, as other clients would."""

    def _silence(self) -> None:
        """Silence one robot briefly every 3 to 4 minutes, as during a Wi-Fi handover."""
        self._silence_in -= STEP
        if self._silence_in <= 0.0 and self.robots:
            self._silence_in = self._rng.uniform(180.0, 240.0)
            self._rng.choice(tuple(self.robots.values())).silence = self._rng.uniform(1.0, 3.0)

"""A simulated hospital, advanced step by step: no I/O, random only by the seed."""

import random
from collections.abc import Callable

from fleet_tui.simulator.rmf.dispatcher import SimDispatcher
from fleet_tui.simulator.rmf.lifts import DOORS, SimDoor, SimLift
from fleet_tui.simulator.rmf.member import SimMember
from fleet_tui.simulator.rmf.naming import FLEETS
from fleet_tui.simulator.rmf.tasks import SimTask
from fleet_tui.simulator.robot import STEP, robot_numbers
from fleet_tui.simulator.warehouse import build_building


class RmfWorld:
    """`robots` robots in `fleets` on `floors` floors, their numbers from `first` on, each `step`th.

    `quiet`: no tasks of other clients, no obstacles. `millis`: the wall clock in milliseconds.
    """

    def __init__(
        self,
        robots: int,
        floors: int,
        seed: int = 0,
        quiet: bool = False,
        first: int = 0,
        step: int = 1,
        fleets: tuple[str, ...] = FLEETS,
        millis: Callable[[], int] = lambda: 0,
    ) -> None:
        self._rng = random.Random(seed)
        self._quiet = quiet
        self.fleets = fleets
        self.building = build_building(floors)
        members = (self._new_member(*one) for one in enumerate(robot_numbers(robots, first, step)))
        self.robots = {member.name: member for member in members}
        self.dispatcher = SimDispatcher(self.robots, millis)
        self.lift = SimLift(self.building)
        self.doors = [
            SimDoor(name, floor.name, spot) for floor in self.building.floors for name, spot in DOORS.items()
        ]
        self.closed_lanes: list[int] = []
        """The numbers of closed edges, alike for all fleets."""
        self.offline = set[str]()
        """Dispensers and ingestors that are offline."""
        self.troubles: list[Callable[[float], None]] = []
        self._owed = 0.0
        self._next = 3.0
        self._given = 0

    def _new_member(self, turn: int, index: int) -> SimMember:
        """Robots start in turn on all floors, spread over the vertices."""
        row, number = divmod(index, len(self.building.floors))
        vertices = tuple(self.building.floors[number].graph.vertices)
        vertex = vertices[(13 * row + 3 * number) % len(vertices)]
        return SimMember(turn, index, self.building, vertex, self._rng, self._quiet, self.fleets)

    def step(self, dt: float) -> None:
        """Let dt seconds pass, in steps of fixed length; a remainder waits for the next call."""
        self._owed += dt
        while self._owed > STEP - 1e-9:
            self._owed -= STEP
            for member in self.robots.values():
                member.live()
            self.dispatcher.step(STEP)
            self.lift.step(self.robots, self.building)
            for door in self.doors:
                door.step(self.robots, STEP)
            for trouble in self.troubles:
                trouble(STEP)
            if not self._quiet:
                self._employ()

    def _employ(self) -> None:
        """Give an idle robot a task now and then, as another client would."""
        self._next -= STEP
        if self._next > 0.0:
            return
        self._next = self._rng.uniform(10.0, 25.0)
        second = [*self.robots.values()][1::2]
        idle = [member for member in second if not member.tasks]
        if idle:
            member = self._rng.choice(idle)
            self._given += 1
            places = tuple(self._rng.sample(sorted(member.places), 2))
            member.assign(SimTask(f"patrol.web-{self._given}", places, "rmf-web"))

"""Simulated robots with Nav2 as a value that steps: no I/O; the seed is the only chance in it."""

import random
from collections.abc import Callable

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.nav2.navigation import DOCK, TO_POSE, WAYPOINTS, Navigation
from fleet_tui.simulator.nav2.poses import stamped
from fleet_tui.simulator.nav2.robot import Nav2Robot
from fleet_tui.simulator.robot import LOW, STEP
from fleet_tui.simulator.warehouse import build_building


class Nav2World:
    """`robots` robots on `floors` floors. `quiet`: no goals of other clients, no obstacles, no silence.

    `clock`: the wall time in nanoseconds since 1970, for the goals' stamps; where None it is the world's own.
    Every second robot is driven by another client, who leaves the others alone.
    """

    def __init__(
        self,
        robots: int,
        floors: int,
        seed: int = 0,
        quiet: bool = False,
        first: int = 0,
        clock: Callable[[], int] | None = None,
    ) -> None:
        self._rng = random.Random(seed)
        self._quiet = quiet
        self.building = build_building(floors)
        self.robots = {f"robot_{i}": self._new_robot(i) for i in range(first, first + robots)}
        self.time = 0.0
        """Seconds since the start."""
        ids = random.Random(seed)
        self.navigation = {
            name: Navigation(robot, ids, clock or (lambda: round(self.time * 1e9)))
            for name, robot in self.robots.items()
        }
        """The action servers of each robot."""
        self.troubles: list[Callable[[float], None]] = []
        """Called at every step with the seconds that pass."""
        self._owed = 0.0
        self._silence_in = self._rng.uniform(180.0, 240.0)
        self._rest = {name: self._rng.uniform(6.0, 15.0) for name in self.robots}

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

    def _new_robot(self, index: int) -> Nav2Robot:
        """Robots start in turn on all floors, spread over the vertices."""
        floor = self.building.floors[index % len(self.building.floors)]
        vertices = tuple(floor.graph.vertices.values())
        spot = vertices[(7 * (index // len(self.building.floors)) + 3 * index) % len(vertices)]
        pose = Pose(spot.x, spot.y, self._rng.uniform(-3.0, 3.0))
        return Nav2Robot(index, floor, pose, self._rng, self._quiet)

    def _employ(self) -> None:
        """Give every second robot a goal once it has rested, as another client does; dock who is low."""
        for name, robot in self.robots.items():
            navigation = self.navigation[name]
            if robot.driving or any(server.running for server in navigation.servers.values()):
                continue
            if robot.battery < LOW and not robot.docked:
                navigation.take(DOCK, {"use_dock_id": True, "dock_id": "charger"})
            self._rest[name] -= STEP
            if robot.index % 2 and self._rest[name] <= 0.0 and robot.battery > 2 * LOW:
                self._rest[name] = self._rng.uniform(10.0, 30.0)
                self._send(robot, navigation)

    def _send(self, robot: Nav2Robot, navigation: Navigation) -> None:
        """Send it to a labelled vertex, every third time by way of another."""
        graph = robot.floor.graph
        spots = [graph.vertices[id_] for id_ in self._rng.sample(tuple(robot.floor.labels), 2)]
        poses = [stamped(Pose(spot.x, spot.y, self._rng.uniform(-3.0, 3.0))) for spot in spots]
        if self._rng.random() < 0.3:
            navigation.take(WAYPOINTS, {"number_of_loops": 0, "goal_index": 0, "poses": poses})
        else:
            navigation.take(TO_POSE, {"pose": poses[0], "behavior_tree": ""})

    def _silence(self) -> None:
        """Every 3 to 4 minutes one robot of the fleet can't be heard for a while."""
        self._silence_in -= STEP
        if self._silence_in <= 0.0 and self.robots:
            self._silence_in = self._rng.uniform(180.0, 240.0)
            self._rng.choice(tuple(self.robots.values())).silence = self._rng.uniform(8.0, 20.0)

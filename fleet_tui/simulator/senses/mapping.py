"""Mapping: floors whose live map grows with the scans of robots that map."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial

import numpy as np

from fleet_tui.simulator.floorplan import ORIGIN, RESOLUTION, UNKNOWN, Cells
from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Message, Topic
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.senses.laser import Surveyor, ends
from fleet_tui.simulator.warehouse import SimFloor

EVERY = 1.0  # seconds of world time between two maps, and two scans that make one
MARGIN = 20  # cells kept around what is known
MODES = ("navigation", "mapping")


class Surveys:
    """The live maps of the floors of one fleet, and the robots that map. `topics_of` returns the map topics
    of a floor."""

    def __init__(self, robots: Mapping[str, Surveyor], topics_of: Callable[[SimFloor], list[str]]) -> None:
        self._robots = robots
        self._topics_of = topics_of
        self.mapping: set[str] = set()
        """The names of the robots that map."""
        self._known: dict[str, Cells] = {}
        self._changed: dict[str, SimFloor] = {}
        self._told = dict.fromkeys(robots, False)
        self._since = 0.0

    def switch(self, robot: str, on: bool) -> None:
        """Begin a new map of a robot's floor, or keep it as it is."""
        floor = self._robots[robot].floor
        if on and robot not in self.mapping:
            self._known[floor.name] = np.full_like(floor.cells, UNKNOWN)
            self.mapping.add(robot)
            self._since = EVERY
        elif not on:
            self.mapping.discard(robot)

    def step(self, dt: float) -> None:
        """Take a scan of each robot that maps, once in a while."""
        self._since += dt
        if not self.mapping or self._since < EVERY:
            return
        self._since = 0.0
        for name in self.mapping:
            robot = self._robots[name]
            floor = robot.floor
            known = self._known.setdefault(floor.name, np.full_like(floor.cells, UNKNOWN))
            rows, columns, first = ends(floor.cells, robot.pose)
            seen = np.arange(rows.shape[1]) <= first[:, np.newaxis]
            known[rows[seen], columns[seen]] = floor.cells[rows[seen], columns[seen]]
            self._changed[floor.name] = floor

    def cells(self, floor: SimFloor) -> tuple[Cells, tuple[float, float]]:
        """Return the present map of a floor, as large as what is known, and the place of its lower left
        corner."""
        known = self._known.get(floor.name)
        if known is None:
            return floor.cells, ORIGIN
        there = np.argwhere(known != UNKNOWN)
        if not len(there):
            return known[:1, :1], ORIGIN
        low = np.maximum(there.min(axis=0) - MARGIN, 0)
        high = there.max(axis=0) + 1 + MARGIN
        part = known[low[0] : high[0], low[1] : high[1]]
        return part, (ORIGIN[0] + low[1] * RESOLUTION, ORIGIN[1] + low[0] * RESOLUTION)

    def topics(self, dialect: Dialect) -> Iterator[Topic]:
        for name in self._robots:
            type_ = dialect.message_type("std_msgs/String")
            yield Topic(f"/{name}/mode", type_, partial(self._mode, name), latched=True)

    def _mode(self, robot: str, _now: float = 0.0) -> Payload:
        return Payload({"data": MODES[robot in self.mapping]})

    def news(self, grid: Callable[[SimFloor], Message]) -> Iterator[tuple[str, Payload]]:
        """Return the modes and maps that changed since the last call."""
        for name, before in self._told.items():
            if before is not (name in self.mapping):
                self._told[name] = not before
                yield f"/{name}/mode", self._mode(name)
        for floor in self._changed.values():
            payload = Payload(grid(floor))
            yield from ((topic, payload) for topic in self._topics_of(floor))
        self._changed = {}

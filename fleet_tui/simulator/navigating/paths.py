"""Ways to a pose: straight through free space, else along the floor's graph. Pure."""

import math
from itertools import pairwise

import numpy as np

from fleet_tui.model.geometry import Pose
from fleet_tui.simulator.floorplan import FREE, HEIGHT, ORIGIN, RESOLUTION, WIDTH
from fleet_tui.simulator.warehouse import SimFloor

Spot = tuple[float, float]

# error codes of Nav2's planner
OFF_THE_MAP = 204
OCCUPIED = 206
NO_PATH = 208


class NoPathError(Exception):
    """No path to a goal; `code` is Nav2's number for the reason."""

    def __init__(self, code: int, message: str) -> None:
        super().__init__(message)
        self.code = code


def plan(floor: SimFloor, start: Pose, goal: Pose) -> list[Spot]:
    """Return the corners of a path, both ends included. Raises NoPathError."""
    here, there = (start.x, start.y), (goal.x, goal.y)
    message = (
        f"GridBased plugin failed to plan from ({start.x:.2f}, {start.y:.2f}) to ({goal.x:.2f}, {goal.y:.2f})"
    )
    if not _on_map(there):
        raise NoPathError(
            OFF_THE_MAP, f"{message}: Goal Coordinates of({goal.x:f}, {goal.y:f}) was outside bounds"
        )
    if _cell(floor, there) != FREE:
        raise NoPathError(OCCUPIED, f"{message}: Goal occupied")
    if _clear(floor, here, there):
        return [here, there]
    first, last = _nearest(floor, here), _nearest(floor, there)
    way = floor.graph.path(first, last) if first is not None and last is not None else ()
    if not way:
        raise NoPathError(NO_PATH, f"{message}: no valid path found")
    vertices = [floor.graph.vertices[id_] for id_ in way]
    return [here, *((vertex.x, vertex.y) for vertex in vertices), there]


def length(way: list[Spot]) -> float:
    """Return the length of a path in metres."""
    return sum(math.dist(start, end) for start, end in pairwise(way))


def _on_map(spot: Spot) -> bool:
    # Not finite is not on the map either.
    x, y = (value - origin for value, origin in zip(spot, ORIGIN, strict=True))
    return 0.0 <= x < WIDTH * RESOLUTION and 0.0 <= y < HEIGHT * RESOLUTION


def _cell(floor: SimFloor, spot: Spot) -> int:
    column, row = (int((value - origin) / RESOLUTION) for value, origin in zip(spot, ORIGIN, strict=True))
    return int(floor.cells[row, column])


def _clear(floor: SimFloor, start: Spot, end: Spot) -> bool:
    """Tell whether every cell on the line is free."""
    steps = max(2, math.ceil(math.dist(start, end) / RESOLUTION) + 1)
    columns = ((np.linspace(start[0], end[0], steps) - ORIGIN[0]) / RESOLUTION).astype(int)
    rows = ((np.linspace(start[1], end[1], steps) - ORIGIN[1]) / RESOLUTION).astype(int)
    return bool((floor.cells[rows, columns] == FREE).all())


def _nearest(floor: SimFloor, spot: Spot) -> int | None:
    """The nearest vertex that is reached in a straight line."""
    near = sorted(floor.graph.vertices.values(), key=lambda vertex: math.dist(spot, (vertex.x, vertex.y)))
    return next((vertex.id for vertex in near if _clear(floor, spot, (vertex.x, vertex.y))), None)

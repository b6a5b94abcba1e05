"""A plausible warehouse with one plan per floor: the same floor number always gives the same floor. All
lengths are in metres, in the robots' frame. The elevator is at the same place on every floor."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import combinations

import numpy as np

from fleet_tui.model.graph import shortest_path
from fleet_tui.simulator.floorplan import Cells, Plan, draw

FLOOR_IDS = 100  # floor k numbers its vertices and edges from k * FLOOR_IDS

_GROUND = Plan(
    columns=(0.0, 8.0, 17.0, 26.0, 35.0),
    rows=(0.0, 7.0, 13.0, 20.0),
    blocks=("rrod", "rprp", "rrpo"),
    walls=((21.4, -2.5, 21.6, 22.5), (-1.5, 16.4, 13.0, 16.6)),
    closed=frozenset({(8, 9), (1, 6), (13, 18), (6, 7), (11, 12)}),
    labels={0: "Base", 19: "Consumidores", 12: "Store", 4: "Dispatch", 17: "Packing", 5: "Receiving"},
    elevator=(9, "Lift"),
    docking=(15, "Charger"),
)
_UPPER = Plan(
    columns=(0.0, 10.0, 19.0, 27.0, 35.0),
    rows=(0.0, 6.0, 14.0, 20.0),
    blocks=("orrp", "dorr", "pr.r"),
    walls=((-1.5, 9.9, 23.0, 10.1), (22.9, 10.0, 23.1, 22.5)),
    closed=frozenset({(8, 9), (2, 7), (12, 17), (5, 10), (8, 13), (15, 16)}),
    labels={2: "Kitchen", 18: "Pharmacy", 10: "Archive", 4: "Laundry", 16: "Workshop", 7: "Laboratory"},
    elevator=(9, "Elevator"),
    docking=(1, "Dock"),
)
ELEVATOR_AT = (36.0, 10.0)
MIDDLE = 10.0  # y about which every second pair of floors is mirrored; the elevator lies on it


@dataclass(frozen=True)
class SimVertex:
    """A place: x, y in metres."""

    id: int
    x: float
    y: float


@dataclass(frozen=True)
class SimEdge:
    """A connection between two vertices, both ways."""

    id: int
    start: int
    end: int


@dataclass(frozen=True)
class SimGraph:
    """Vertices by id and the edges between them."""

    vertices: Mapping[int, SimVertex]
    edges: tuple[SimEdge, ...]

    @cached_property
    def _ways(self) -> Mapping[int, list[tuple[int, float]]]:
        found: dict[int, list[tuple[int, float]]] = {id_: [] for id_ in self.vertices}
        for edge in self.edges:
            start, end = self.vertices[edge.start], self.vertices[edge.end]
            length = math.dist((start.x, start.y), (end.x, end.y))
            found[edge.start].append((edge.end, length))
            found[edge.end].append((edge.start, length))
        return found

    def nearest(self, x: float, y: float) -> int:
        """Return the id of the vertex nearest to a place."""
        return min(self.vertices.values(), key=lambda one: math.dist((one.x, one.y), (x, y))).id

    def path(self, start: int, end: int) -> tuple[int, ...]:
        """Return the shortest path as vertex ids, both ends included; empty if none exists."""
        return shortest_path(self._ways, start, end)


@dataclass(frozen=True, eq=False)
class SimFloor:
    """One floor: its occupancy, row 0 at the BOTTOM, and its graph with labels and wire types by id."""

    name: str
    cells: Cells
    graph: SimGraph
    labels: Mapping[int, str]
    types: Mapping[int, str]

    def vertex_of(self, type_: str) -> int:
        """The id of the first vertex of this wire type. Raises StopIteration if there is none."""
        return next(id_ for id_, other in self.types.items() if other == type_)

    @property
    def charger(self) -> SimVertex:
        return self.graph.vertices[self.vertex_of("charger")]

    def has(self, type_: str) -> bool:
        """Tell whether a vertex has this wire type: a drawn graph may have none."""
        return type_ in self.types.values()


@dataclass(eq=False)
class Building:
    """All floors, and the one graph on which robots plan: elevators join the floors."""

    floors: tuple[SimFloor, ...]

    def redraw(self, floor: SimFloor) -> None:
        """Replace the floor of this name. The ids of its vertices are on no other floor."""
        self.floors = tuple(floor if one.name == floor.name else one for one in self.floors)
        for known in ("graph", "_floor_by_vertex"):
            self.__dict__.pop(known, None)

    @cached_property
    def graph(self) -> SimGraph:
        """Every floor's vertices and edges, and a ride between any two elevators."""
        shafts = [floor.vertex_of("elevator") for floor in self.floors if floor.has("elevator")]
        rides = tuple(SimEdge(-1, start, end) for start, end in combinations(shafts, 2))
        vertices = {id_: vertex for floor in self.floors for id_, vertex in floor.graph.vertices.items()}
        return SimGraph(vertices, tuple(e for floor in self.floors for e in floor.graph.edges) + rides)

    def floor_of(self, vertex: int) -> SimFloor:
        return self._floor_by_vertex[vertex]

    @cached_property
    def _floor_by_vertex(self) -> Mapping[int, SimFloor]:
        return {id_: floor for floor in self.floors for id_ in floor.graph.vertices}


def build_building(floors: int) -> Building:
    """A building of `floors` floors, named floor_0, floor_1, ..."""
    return Building(tuple(build_floor(number) for number in range(floors)))


@cache
def build_floor(number: int) -> SimFloor:
    """The floor of this number, counting from 0."""
    plan = (_GROUND, _UPPER)[number % 2]
    base = number * FLOOR_IDS
    mirrored = number % 4 >= 2
    spots = tuple(_mirror(spot) if mirrored else spot for spot in _spots(plan))
    types = dict.fromkeys(plan.labels, "label")
    types |= {plan.elevator[0]: "elevator", plan.docking[0]: "charger"}
    suffix = "" if number < 2 else f" {number}"
    named = dict(sorted([*plan.labels.items(), plan.elevator, plan.docking]))
    vertices = {base + index: SimVertex(base + index, x, y) for index, (x, y) in enumerate(spots)}
    aisles = [pair for pair in _neighbours(plan) if pair not in plan.closed]
    cells = draw(plan, [(_spots(plan)[start], _spots(plan)[end]) for start, end in aisles], ELEVATOR_AT)
    edges = tuple(SimEdge(base + i, base + start, base + end) for i, (start, end) in enumerate(aisles))
    return SimFloor(
        f"floor_{number}",
        np.ascontiguousarray(cells[::-1]) if mirrored else cells,
        SimGraph(vertices, edges),
        {base + index: f"{label}{suffix}" for index, label in named.items()},
        {base + index: types.get(index, "way") for index in range(len(spots))},
    )


def _spots(plan: Plan) -> tuple[tuple[float, float], ...]:
    """Return the places of the vertices: at the crossings, row by row from the south west, but for the
    elevator."""
    spots = [(x, y) for y in plan.rows for x in plan.columns]
    spots[plan.elevator[0]] = ELEVATOR_AT
    return tuple(spots)


def _mirror(spot: tuple[float, float]) -> tuple[float, float]:
    return spot[0], 2.0 * MIDDLE - spot[1]


def _neighbours(plan: Plan) -> Iterator[tuple[int, int]]:
    """Pairs of neighbouring crossings as indexes, the smaller one first."""
    across, count = len(plan.columns), len(plan.columns) * len(plan.rows)
    for index in range(count):
        if (index + 1) % across:
            yield index, index + 1
        if index + across < count:
            yield index, index + across

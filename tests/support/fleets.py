"""A small fleet without a wire, and the recordings of a real bridge."""

import gzip
import json
from collections.abc import Iterable, Mapping
from functools import reduce
from itertools import pairwise
from pathlib import Path
from typing import Any

import msgspec

from fleet_tui.config.start import initial_state
from fleet_tui.model.commands import Command, PlaceOrder, Stage
from fleet_tui.model.events import (
    BatteryReported,
    CommandAdvanced,
    CommandIssued,
    Event,
    GraphReceived,
    LabelsReceived,
    LinkChanged,
    PoseReported,
    QueueReported,
    TimePassed,
)
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.geometry import Pose
from fleet_tui.model.graph import Edge, RouteGraph, Vertex
from fleet_tui.model.kind import Kind
from fleet_tui.model.link import Phase
from fleet_tui.model.order import Order, OrderQueue, at_vertices
from fleet_tui.robots.oh_ressources.reading import STATES
from fleet_tui.robots.profile import Profile
from fleet_tui.state.reducer import apply
from fleet_tui.text.language import Message
from fleet_tui.ui.view.tables.table import Run
from tests.support.watched_store import config_of

T0 = 1000.0
WALL = 1_700_000_000.0
LINK = "rosbridge"
R0, F0 = "robot_0", "floor_0"
WIRE = Path(__file__).parents[1] / "wire"


def fleet(robots: int = 1, floors: int = 1) -> FleetState:
    """Robots and floors of a config without a topic for pauses, nothing received yet, at T0."""
    config = config_of("ws://site:9090", robots, floors)
    return initial_state(msgspec.structs.replace(config, profile=Profile()), T0)


def reduced(state: FleetState, *facts: Event) -> FleetState:
    """The state after these facts."""
    return reduce(apply, facts, state)


def tick(at: float) -> TimePassed:
    """The writer's clock, with a wall clock that runs beside it."""
    return TimePassed(at, WALL + at)


def pose(at: float, x: float = 0.0, y: float = 0.0, stamp: float | None = None, **more: str) -> PoseReported:
    """A pose on the first floor, of the first robot unless told otherwise."""
    return PoseReported(more.get("robot", R0), at, Pose(x, y), more.get("frame", F0), stamp)


def battery(at: float, percent: float = 80.0, robot: str = R0) -> BatteryReported:
    return BatteryReported(robot, at, percent)


def place_order(robot: str, *vertices: str | int) -> PlaceOrder:
    """An order from one vertex to another, or of the cargo on board to one."""
    return PlaceOrder(robot, at_vertices(*map(str, vertices)))


def order(id_: int, start: int, end: int, letter: str) -> Order:
    """An order as the source's robots list it."""
    return Order(str(id_), at_vertices(str(start), str(end)), STATES.get(letter), letter, id_)


def order_queue(last: int, current: int, *orders: Order, request_id: int = 0) -> OrderQueue:
    """A queue as the source's robots tell it; `current` below 0: none."""
    return OrderQueue(last, str(current) if current >= 0 else "", orders, request_id)


def queue(at: float, *orders: tuple[int, int, int, str], current: int = -1, robot: str = R0) -> QueueReported:
    listed = tuple(order(*one) for one in orders)
    last = max((one.serial for one in listed), default=0)
    return QueueReported(robot, at, order_queue(last, current, *listed))


def graph(*ids: int | str, floor: str = F0, robot: str = R0) -> GraphReceived:
    """Vertices in a row, each joined to the next, a metre apart."""
    names = [str(id_) for id_ in ids]
    vertices = {id_: Vertex(id_, float(n), 0.0) for n, id_ in enumerate(names)}
    edges = tuple(Edge(str(n), *pair) for n, pair in enumerate(pairwise(names)))
    return GraphReceived(robot, floor, RouteGraph(vertices, edges))


def labels(named: Mapping[int, str] | Mapping[str, str], floor: str = F0, robot: str = R0) -> LabelsReceived:
    return LabelsReceived(robot, floor, {str(id_): label for id_, label in named.items()})


def link_up(at: float) -> LinkChanged:
    return LinkChanged(LINK, at, Phase.UP)


def link_lost(at: float, reason: str = "connection refused", next_try: float | None = None) -> LinkChanged:
    return LinkChanged(LINK, at, Phase.WAITING, Message(reason), next_try)


def commanded(
    id_: int, command: Command, *stages: Stage, at: float = T0, detail: str = ""
) -> tuple[CommandIssued | CommandAdvanced, ...]:
    """A command, and how the link brought it on; `detail` come with every stage."""
    return CommandIssued(id_, command, at, WALL), *(
        CommandAdvanced(id_, one, at, Message(detail)) for one in stages
    )


def recording(name: str) -> list[dict[str, Any]]:
    """The frames of a recording, oldest first."""
    path = WIRE / name
    text = gzip.decompress(path.read_bytes()).decode() if path.suffix == ".gz" else path.read_text()
    return [json.loads(line) for line in text.splitlines()]


def text_of(runs: Iterable[Run]) -> str:
    """The text of runs."""
    return "".join(text for text, _ in runs)


def of_kinds(state: FleetState, *kinds: Kind) -> FleetState:
    """The same fleet, its robots in their sequence of these kinds."""
    names = zip(state.robots.items(), kinds, strict=True)
    robots = {name: msgspec.structs.replace(robot, kind=kind) for (name, robot), kind in names}
    return msgspec.structs.replace(state, robots=robots)

"""A small fleet without a wire, and the recordings of a real bridge."""

import gzip
import json
from collections.abc import Iterable
from functools import reduce
from itertools import pairwise
from pathlib import Path
from typing import Any

import msgspec

from fleet_tui.adapters.profile import Profile
from fleet_tui.config.start import initial_state
from fleet_tui.model.apply import apply
from fleet_tui.model.commands import Command, Stage
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
from fleet_tui.model.link import Phase
from fleet_tui.model.order import Order, OrderQueue
from fleet_tui.view.table import Run
from tests.watched import config_of

T0 = 1000.0
WALL = 1_700_000_000.0
LINK = "rosbridge"
R0, F0 = "robot_0", "floor_0"
WIRE = Path(__file__).parent / "wire"


def fleet(robots: int = 1, floors: int = 1) -> FleetState:
    """Robots and floors of a config without a topic for pauses, nothing heard yet, at T0."""
    config = config_of("ws://site:9090", robots, floors)
    return initial_state(msgspec.structs.replace(config, profile=Profile()), T0)


def told(state: FleetState, *facts: Event) -> FleetState:
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


def queue(at: float, *orders: tuple[int, int, int, str], current: int = -1, robot: str = R0) -> QueueReported:
    listed = tuple(Order(*order) for order in orders)
    return QueueReported(robot, at, OrderQueue(max((o.id for o in listed), default=0), current, listed))


def graph(*ids: int, floor: str = F0, robot: str = R0) -> GraphReceived:
    """Vertices in a row, each joined to the next, a metre apart."""
    vertices = {id_: Vertex(id_, float(n), 0.0) for n, id_ in enumerate(ids)}
    edges = tuple(Edge(n, *pair) for n, pair in enumerate(pairwise(ids)))
    return GraphReceived(robot, floor, RouteGraph(vertices, edges))


def labels(named: dict[int, str], floor: str = F0, robot: str = R0) -> LabelsReceived:
    return LabelsReceived(robot, floor, named)


def link_up(at: float) -> LinkChanged:
    return LinkChanged(LINK, at, Phase.UP)


def link_lost(at: float, reason: str = "nothing listens there", next_try: float | None = None) -> LinkChanged:
    return LinkChanged(LINK, at, Phase.WAITING, reason, next_try)


def commanded(
    id_: int, command: Command, *stages: Stage, at: float = T0, words: str = ""
) -> tuple[CommandIssued | CommandAdvanced, ...]:
    """A command, and how the link brought it on; `words` come with every stage."""
    return CommandIssued(id_, command, at, WALL), *(CommandAdvanced(id_, one, at, words) for one in stages)


def recording(name: str) -> list[dict[str, Any]]:
    """The frames of a recording, oldest first."""
    path = WIRE / name
    text = gzip.decompress(path.read_bytes()).decode() if path.suffix == ".gz" else path.read_text()
    return [json.loads(line) for line in text.splitlines()]


def text_of(runs: Iterable[Run]) -> str:
    """What runs read as."""
    return "".join(text for text, _ in runs)

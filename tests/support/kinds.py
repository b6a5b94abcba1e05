"""Kinds of robots made up: what one never reports or accepts is neither expected, shown nor asked for."""

import math

from fleet_tui.keys.keymap import keymap
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.kind import CANCEL, CLEAR, ORDER, ORDER_TO, PAUSE, RESUME, Kind
from tests.support.fleets import R0, T0, fleet, graph, labels, link_up, of_kinds, pose, reduced, tick

MUTE = Kind("mute", ("pose",))
"""Tells where it is, and takes no command."""
GOALS = Kind("goals", ("pose", "battery", "queue", "graph", "labels"), (ORDER, ORDER_TO, CANCEL, CLEAR))
FULL = fleet().robots[R0].kind
BARE = Kind("bare", ("pose",), (ORDER_TO,))
LATE = Kind("late", ("pose", "battery", "queue"), (ORDER, CANCEL), {"queue": math.inf})
KEEPING = Kind(
    "goals",
    ("pose", "queue"),
    (ORDER, ORDER_TO, CANCEL, CLEAR, PAUSE, RESUME),
    reports_ends=True,
    keeps_goals=True,
    holds=True,
)
"""Drives one goal at a time: this console keeps its queue."""
KEYS, _ = keymap({})


def received(*kinds: Kind) -> FleetState:
    """Robots of these kinds, of which the first one alone knows a graph."""
    state = of_kinds(fleet(len(kinds)), *kinds)
    poses = [pose(T0, robot=name) for name in state.robots]
    return reduced(state, link_up(T0), *poses, graph(1, 2), labels({1: "Base"}), tick(T0))


def moved(*kinds: Kind, at: float = T0 + 1.0) -> FleetState:
    """Robots of these kinds, all of which know a graph and were just heard."""
    state = of_kinds(fleet(len(kinds)), *kinds)
    known = [fact for name in state.robots for fact in (graph(1, 2, robot=name), pose(at, robot=name))]
    return reduced(state, link_up(T0), *known, tick(at))

"""Memory of the last states of vehicles: their nodes and order are told again only when they change."""

from typing import Any

from fleet_tui.adapters.vda5050.fields import Fields
from fleet_tui.adapters.vda5050.state import OrderNodes, nodes_of
from fleet_tui.model.navigation import Goal

TOLD_EVERY = 5.0
"""Seconds after which an unchanged order is told again, so that it does not grow old."""


class StateMemory:
    """What the last state of each vehicle said."""

    def __init__(self) -> None:
        self._nodes: dict[str, tuple[Any, Any, OrderNodes]] = {}
        self._orders: dict[str, tuple[tuple[Goal, ...], float]] = {}

    def nodes(self, robot: str, state: Fields) -> tuple[OrderNodes, bool]:
        """Return the nodes that are left, and whether they have changed."""
        raw = state.raw("nodeStates"), state.raw("edgeStates")
        known = self._nodes.get(robot)
        if known is not None and known[:2] == raw:
            return known[2], False
        faults = len(state.faults)
        found = nodes_of(state)
        if len(state.faults) == faults:  # else each such message is named
            self._nodes[robot] = *raw, found
        return found, True

    def is_news(self, robot: str, orders: tuple[Goal, ...], at: float) -> bool:
        """Tell whether the order of a vehicle must be told: it changed, or was told long ago (monotonic)."""
        known = self._orders.get(robot)
        if known is not None and known[0] == orders and 0.0 <= at - known[1] < TOLD_EVERY:
            return False
        self._orders[robot] = orders, at
        return True

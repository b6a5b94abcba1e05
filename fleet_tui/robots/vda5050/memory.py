"""Memory of the last states of vehicles: their nodes and order are told again only when they change."""

import math
from collections.abc import Mapping
from typing import Any

from msgspec.structs import replace

from fleet_tui.model.geometry import Pose
from fleet_tui.model.navigation import Goal
from fleet_tui.model.vehicles.vehicle import Vehicle
from fleet_tui.robots.vda5050.fields import Fields
from fleet_tui.robots.vda5050.state import ENDED, OrderNodes, is_running, nodes_of

RESTARTS = 3
WITHIN = 60.0
"""Numbers of messages that go back so often in so many seconds are those of two senders."""
STANDS_FROM = 5.0
"""Seconds of messages with one timestamp after which the clock of their vehicle stands still."""
TOGETHER = 0.3
APART = 1.0
CONTRADICTIONS = 3
"""A visualization so many seconds after a state, and so many metres from it, contradicts it: after so many in
a row it is not believed, as there are vehicles whose visualization never moves."""
INSTANT_KEPT = 1000
TOLD_EVERY = 5.0
"""Seconds after which an unchanged order is told again, so that it does not grow old."""


class StateMemory:
    """The last state of each vehicle."""

    def __init__(self) -> None:
        self._nodes: dict[str, tuple[tuple[Any, ...], OrderNodes]] = {}
        self._actions: dict[str, tuple[str, frozenset[str], frozenset[str]]] = {}
        """The order of each vehicle, the actions before it, and those of the last state."""
        self._named: dict[str, Vehicle] = {}
        """The last state of each vehicle, with the order that it names, or has driven last."""
        self._instant: dict[str, str] = {}
        self._numbers: dict[str, float | None] = {}
        self._back: dict[str, list[float]] = {}
        """When the numbers of a vehicle's states went back (monotonic)."""
        self._stamps: dict[tuple[str, str], tuple[str, float | None, float]] = {}
        """By robot and topic name: the last timestamp, with number and second of its first message."""
        self._places: dict[str, tuple[Pose, float]] = {}
        """The position in the last state of each vehicle, and its arrival."""
        self._apart: dict[str, int] = {}
        """The visualizations in a row that contradicted the state before them."""
        self._orders: dict[str, tuple[tuple[Goal, ...], float]] = {}

    def has_second_sender(self, robot: str, number: float | None, at: float) -> bool:
        """Tell whether the numbers of a vehicle's states go back again and again: once is a restart."""
        last, self._numbers[robot] = self._numbers.get(robot), number
        if last is None or number is None or number >= last:
            return False
        back = [one for one in self._back.get(robot, ()) if 0.0 <= at - one < WITHIN]
        self._back[robot] = [*back, at][-RESTARTS:]
        return len(self._back[robot]) == RESTARTS

    def clock_stands(self, robot: str, name: str, stamp: str, number: float | None, at: float) -> bool:
        """Tell whether the messages of a vehicle go on, and their timestamps do not."""
        known = self._stamps.get((robot, name))
        if known is None or known[0] != stamp or number is None or known[1] is None or number < known[1]:
            self._stamps[robot, name] = stamp, number, at
            return False
        return number > known[1] and at - known[2] >= STANDS_FROM

    def state_at(self, robot: str, pose: Pose, at: float) -> None:
        """Remember the position in a state, which its visualization may contradict."""
        self._places[robot] = pose, at

    def apart(self, robot: str, pose: Pose, at: float) -> float:
        """Return the metres between the positions of a visualization and of the state before it, once several
        in a row were too far apart for a vehicle that drives; 0 while they are one."""
        known = self._places.get(robot)
        if known is None:
            return 0.0
        metres = math.dist((pose.x, pose.y), (known[0].x, known[0].y))
        if 0.0 <= at - known[1] <= TOGETHER:
            self._apart[robot] = self._apart.get(robot, 0) + 1 if metres > APART else 0
        return metres if self._apart.get(robot, 0) >= CONTRADICTIONS else 0.0

    def nodes(self, robot: str, state: Fields) -> tuple[OrderNodes, bool]:
        """Return the nodes that are left, and whether they have changed."""
        names = "orderId", "nodeStates", "edgeStates", "lastNodeId", "lastNodeSequenceId"
        raw = tuple(state.raw(name) for name in names)
        known = self._nodes.get(robot)
        if known is not None and known[0] == raw:
            return known[1], False
        faults = len(state.faults)
        earlier = known[1].listed if known is not None and known[0][0] == raw[0] else frozenset()
        found = nodes_of(state, earlier)
        if len(state.faults) == faults:  # else each such message is named
            self._nodes[robot] = raw, found
        return found, True

    @property
    def instant_actions(self) -> Mapping[str, str]:
        """The types of instant actions that master controls sent, by id."""
        return self._instant

    def add_instant(self, id_: str, type_: str) -> None:
        """Remember an instant action that a master control sent."""
        self._instant[id_] = type_
        if len(self._instant) > INSTANT_KEPT:
            del self._instant[next(iter(self._instant))]

    def with_driven_order(self, robot: str, vehicle: Vehicle) -> Vehicle:
        """Return a state with the order that its vehicle has driven to the end, if it names none any more: it
        ought to name that until it takes the next one."""
        before = self._named.get(robot)
        if not vehicle.order_id and before is not None and _has_driven(before, vehicle):
            vehicle = replace(vehicle, order_id=before.order_id)
        self._named[robot] = vehicle
        return vehicle

    def earlier_actions(self, robot: str, vehicle: Vehicle) -> frozenset[str]:
        """Return the ids of the actions that were in the states before the vehicle took its order: some keep
        them for long, and they say nothing of it. Nor do cancellations that are over in the first of all
        states while its order is driven."""
        if (known := self._actions.get(robot)) is not None:
            order_id, earlier, last = known
        else:
            over = frozenset(one.id for one in vehicle.actions if one.is_cancelled)
            order_id, earlier, last = vehicle.order_id, over if is_running(vehicle) else frozenset(), over
        if vehicle.order_id != order_id:
            earlier = last
        ids = frozenset(one.id for one in vehicle.actions if one.id)
        self._actions[robot] = vehicle.order_id, earlier, ids
        return earlier

    def is_news(self, robot: str, orders: tuple[Goal, ...], at: float) -> bool:
        """Tell whether the order of a vehicle must be told: it changed, or was told long ago (monotonic)."""
        known = self._orders.get(robot)
        if known is not None and known[0] == orders and 0.0 <= at - known[1] < TOLD_EVERY:
            return False
        self._orders[robot] = orders, at
        return True


def _has_driven(before: Vehicle, vehicle: Vehicle) -> bool:
    """Tell whether all that was left of an order is done in a later state: one node, and its actions."""
    goal = before.nodes_left[-1] if before.nodes_left else before.last_node
    ended = {one.id for one in vehicle.actions if one.status in ENDED}
    return (
        len(before.nodes_left) <= 1
        and not before.horizon
        and vehicle.last_node == goal != ""
        and not (vehicle.nodes_left or vehicle.horizon)
        and all(one.is_beside or one.status in ENDED or one.id in ended for one in before.actions)
    )

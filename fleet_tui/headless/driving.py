"""An order on its way, from the queue until it was driven."""

import math
from dataclasses import dataclass, replace

from fleet_tui.headless.outcome import DONE, NOT_DONE, Outcome
from fleet_tui.headless.session import WaitingStore
from fleet_tui.model.commands import CommandRecord, PlaceOrder, PlaceOrderWithCargo
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import STATUS_WORDS, Order
from fleet_tui.model.robot import Robot

ARRIVES = 2.0
"""Metres from its last vertex within which a robot was, if it drove the order and did not just lose it."""


@dataclass
class Drive:
    """What was seen of an order: whether it was begun, how near to its end the robot came."""

    record: CommandRecord
    queued: Outcome
    begun: bool = False
    nearest: float | None = None
    found: Outcome | None = None
    status: str = ""

    def follow(self, store: WaitingStore, seconds: float) -> Outcome:
        """Wait until the order was driven, or was not; `seconds` at most."""
        command = self.record.command
        if self.record.order_id is None or not isinstance(command, PlaceOrder | PlaceOrderWithCargo):
            return self.queued
        store.wait(lambda state: self._look(state, command), seconds)
        if self.found is not None:
            return self.found
        status = STATUS_WORDS.get(self.status, self.status or "in the queue")
        words = f"order {self.record.order_id} is {status}, and was not driven yet when the time was up"
        return replace(self.queued, outcome="not done", words=words, code=NOT_DONE)

    def _look(self, state: FleetState, command: PlaceOrder | PlaceOrderWithCargo) -> bool:
        robot, order_id = state.robots[command.robot], self.record.order_id
        assert order_id is not None
        order = next((one for one in robot.orders.orders if one.id == order_id), None)
        if order is not None and order.status not in "DC":
            self._drives(robot, order)
        else:
            wrong = self._wrong(robot, order_id, command.end, order)
            words = f"order {order_id} {wrong or 'was driven'}"
            outcome, code = ("not done", NOT_DONE) if wrong else ("done", DONE)
            self.found = replace(
                self.queued,
                outcome=outcome,
                words=words,
                code=code,
                seconds=round(state.now - self.record.issued_at, 3),
            )
        return self.found is not None

    def _drives(self, robot: Robot, order: Order) -> None:
        self.status = order.status
        self.begun = self.begun or order.status == "W" or robot.orders.current_order_id == order.id
        chart = robot.charts.get(robot.floor or "")
        vertex = chart.graph.vertices.get(order.end) if chart and chart.graph else None
        if self.begun and robot.pose is not None and chart and chart.graph:
            pose = robot.pose.value
            away = math.dist((pose.x, pose.y), (vertex.x, vertex.y)) if vertex else math.inf
            self.nearest = away if self.nearest is None else min(self.nearest, away)

    def _wrong(self, robot: Robot, order_id: int, end: int, order: Order | None) -> str:
        """Why it was not driven, empty where it was."""
        if order is not None:
            return "was cancelled" if order.status == "C" else ""
        if robot.orders.last_order_id < order_id:
            return f"is lost: {robot.name} began to count anew"
        if not self.begun:
            return "left the queue before it was begun"
        if self.nearest is not None and self.nearest > ARRIVES:
            return f"left the queue before {robot.name} came to {robot.name_of(end) or end}"
        return ""

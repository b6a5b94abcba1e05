"""One simulated vehicle: its orders, instant actions and drive. Pure: no clock, no network."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

SPEED = 1.2
TURN = 1.5
DRAIN = 0.02
CHARGE = 0.5
"""Metres and radians a second, and per cent of charge a second while it drives, and at a charger."""
STRAIGHT = 0.2
"""Radians off its way up to which it drives."""
REACH = 1.5
"""Metres from an order's first node within which a vehicle can begin it."""
STATES_KEPT = 10
"""Number of finished actions that stay in the state."""

Node = dict[str, Any]


class SimVehicle:
    """A vehicle that drives the released nodes of one order at a time. Its attributes may be changed."""

    def __init__(self, name: str, place: tuple[float, float], map_id: str, node: str) -> None:
        self.name = name
        self.map_id = map_id
        self.x, self.y = place
        self.theta = 0.0
        self.last_node = node
        self.last_sequence = 0
        self.order_id = ""
        self.update_id = 0
        self.nodes: list[Node] = []
        """Nodes still to be reached, released or not."""
        self.actions: list[dict[str, str]] = []
        self.errors: list[dict[str, Any]] = []
        self.battery = 80.0
        self.paused = self.driving = self.loaded = self.charging = False
        self.mode = "AUTOMATIC"
        self.e_stop = "NONE"
        self.field = False
        self.localised = True
        self.silent = False
        self.rejects = False
        self.slow = False
        self.is_news = True
        """Something changed that a state must tell at once."""

    @property
    def is_running(self) -> bool:
        return bool(self.nodes)

    def step(self, dt: float) -> None:
        self._finish_cancelling()
        if self.charging:
            self.battery = min(100.0, self.battery + CHARGE * dt)
        held = self.paused or self.field or self.e_stop != "NONE" or self.mode != "AUTOMATIC"
        held = held or any(one["errorLevel"] == "FATAL" for one in self.errors)
        target = self.nodes[0] if self.nodes and self.nodes[0]["released"] else None
        was, self.driving = self.driving, target is not None and not held
        self.is_news = self.is_news or was != self.driving
        if target is None or held:
            return
        self.battery = max(0.0, self.battery - DRAIN * dt)
        place = target.get("nodePosition") or {"x": self.x, "y": self.y}
        dx, dy = place["x"] - self.x, place["y"] - self.y
        far, step = math.hypot(dx, dy), SPEED * dt
        if far > step:
            turn = math.remainder(math.atan2(dy, dx) - self.theta, math.tau)
            self.theta += max(-TURN * dt, min(TURN * dt, turn))
            if abs(turn) > STRAIGHT:
                return
            self.x = self.x + dx / far * step
            self.y = self.y + dy / far * step
            return
        self.x = place["x"]
        self.y = place["y"]
        self.last_node = target["nodeId"]
        self.last_sequence = target["sequenceId"]
        self.nodes.pop(0)
        for action in target.get("actions") or ():
            self._report(action, "FINISHED")
            type_ = action.get("actionType")
            self.loaded = type_ == "pick" or (self.loaded and type_ != "drop")
            self.charging = self.charging or type_ == "startCharging"
        self.is_news = True

    def take_order(self, order: Mapping[str, Any]) -> None:
        """Accept an order, or report the reason of its rejection among the errors."""
        id_, nodes = str(order["orderId"]), list(order["nodes"])
        if id_ == self.order_id and order.get("orderUpdateId", 0) <= self.update_id:
            return
        self.is_news = True
        if reason := self._reason_against(id_, nodes):
            self.errors.append(_error(*reason, {"orderId": id_, "headerId": str(order.get("headerId", ""))}))
            return
        self.errors = [one for one in self.errors if one["errorLevel"] != "WARNING"]
        self.update_id = int(order.get("orderUpdateId", 0))
        if id_ == self.order_id:  # it begins with the last node of those released before
            kept = [node for node in self.nodes if node["sequenceId"] < nodes[0]["sequenceId"]]
            self.nodes = kept + [node for node in nodes if node["sequenceId"] > self.last_sequence]
            return
        self.order_id = id_
        self.nodes = nodes[1:]
        self.actions = []
        self.last_node = nodes[0]["nodeId"]
        self.last_sequence = nodes[0]["sequenceId"]

    def _reason_against(self, id_: str, nodes: Sequence[Node]) -> tuple[str, str] | None:
        if self.rejects:
            return "orderError", "this vehicle rejects every order"
        if not nodes:
            return "validationError", "an order without nodes"
        if self.charging:
            return "orderError", "it charges: stop that first"
        if self.is_running and id_ != self.order_id:
            return "orderUpdateError", f"order {self.order_id} is being driven"
        place = nodes[0].get("nodePosition")
        near = place is None or math.dist((place["x"], place["y"]), (self.x, self.y)) <= REACH
        if nodes[0]["nodeId"] != self.last_node and not near:
            return "noRouteError", "the first node is too far away"
        return None

    def take_action(self, action: Mapping[str, Any]) -> None:
        self.is_news = True
        match action.get("actionType"):
            case "startPause" | "stopPause" as type_:
                self.paused = type_ == "startPause"
                self._report(action, "FINISHED")
            case "stopCharging" if self.charging:
                self.charging = False
                self._report(action, "FINISHED")
            case "cancelOrder" if self.is_running:
                self._report(action, "RUNNING" if self.slow else "FINISHED")
                self.nodes = self.nodes[:1] if self.slow else []
            case "cancelOrder":
                self._report(action, "FAILED")
                self.errors.append(
                    _error("noOrderToCancel", "no order", {"actionId": str(action["actionId"])})
                )
            case "stateRequest" | "factsheetRequest":
                self._report(action, "FINISHED")
            case _:
                self._report(action, "FAILED")

    def _finish_cancelling(self) -> None:
        """End a slow cancellation at the next node."""
        for state in self.actions:
            if state["actionStatus"] == "RUNNING" and not self.nodes:
                state["actionStatus"], self.is_news = "FINISHED", True

    def _report(self, action: Mapping[str, Any], status: str) -> None:
        state = {"actionId": str(action.get("actionId", "")), "actionType": str(action.get("actionType", ""))}
        self.actions = [*self.actions[1 - STATES_KEPT :], {**state, "actionStatus": status}]


def _error(type_: str, text: str, references: Mapping[str, str]) -> dict[str, Any]:
    return {
        "errorType": type_,
        "errorLevel": "WARNING",
        "errorDescription": text,
        "errorReferences": [
            {"referenceKey": key, "referenceValue": value} for key, value in references.items()
        ],
    }

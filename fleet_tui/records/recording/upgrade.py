"""Upgrades records of older versions, before they become structs.

Up to version 1 ids of vertices and orders were numbers, an order had a start, an end and the robot's letter,
an order for the cargo on board was a separate command, and vertices had no type.
"""

from collections.abc import Callable
from typing import Any

from fleet_tui.records.audit.reader import text_id, upgrade_audit

Fields = dict[str, Any]

STATES = {"Q": "queued", "W": "in process", "D": "done", "C": "cancelled"}
"""The letters of version 1."""


def upgrade_record(record: Fields) -> Fields:
    """Upgrade a record of version 1. For the state of a keyframe see `upgrade_state`. Raises KeyError,
    TypeError or AttributeError for an invalid record."""
    match record["kind"]:
        case "told":
            upgraded = _EVENTS.get(record["event"]["type"])
            return record if upgraded is None else record | {"event": upgraded(record["event"])}
        case "mark":
            return record | {"record": upgrade_audit(record["record"])}
    return record


def upgrade_state(state: Fields) -> Fields:
    """Upgrade the state of a keyframe. Raises as `upgrade_record`."""
    robots = {name: _robot(robot) for name, robot in state["robots"].items()}
    return state | {"robots": robots, "commands": [_command_record(one) for one in state["commands"]]}


def _by_id(values: Fields, upgraded: Callable[[Any], Any] = lambda value: value) -> Fields:
    return {str(id_): upgraded(value) for id_, value in values.items()}


def _stops(*vertices: object) -> list[Fields]:
    return [{"vertex": text_id(vertex)} for vertex in vertices]


def _order(order: Fields) -> Fields:
    return {
        "id": text_id(order["id"]),
        "stops": _stops(order["start"], order["end"]),
        "state": STATES.get(order["status"]),
        "word": order["status"],
        "serial": order["id"],
    }


def _queue(queue: Fields) -> Fields:
    ids = [order["id"] for order in queue["orders"]]
    current = queue["current_order_id"]
    return {
        "last_serial": queue["last_order_id"],
        "current_id": text_id(current) if current in ids else "",
        "orders": [_order(order) for order in queue["orders"]],
        "request_id": queue["request_id"],
    }


def _with_order(value: Fields) -> Fields:
    return value | {"order": _order(value["order"])}


def _graph(graph: Fields) -> Fields:
    edges = [{name: text_id(edge[name]) for name in ("id", "start", "end")} for edge in graph["edges"]]
    return graph | {"vertices": _by_id(graph["vertices"], _vertex), "edges": edges}


def _vertex(vertex: Fields) -> Fields:
    return vertex | {"id": text_id(vertex["id"])}


def _robot_map(chart: Fields) -> Fields:
    graph = _graph(chart["graph"]) if chart["graph"] is not None else None
    return chart | {"graph": graph, "labels": _by_id(chart["labels"])}


def _robot(robot: Fields) -> Fields:
    queue = robot["queue"]
    return robot | {
        "charts": {floor: _robot_map(chart) for floor, chart in robot["charts"].items()},
        "queue": queue and queue | {"value": _queue(queue["value"])},
        "traces": _by_id(robot["traces"], _with_order),
        "gone": [_with_order(one) for one in robot["gone"]],
    }


def _command(command: Fields) -> Fields:
    match command["type"]:
        case "PlaceOrder":
            stops = _stops(command["start"], command["end"])
            return {"type": "PlaceOrder", "robot": command["robot"], "stops": stops}
        case "PlaceOrderWithCargo":
            return {"type": "PlaceOrder", "robot": command["robot"], "stops": _stops(command["end"])}
        case "CancelOrder":
            return command | {"order_id": text_id(command["order_id"])}
    return command


def _command_record(record: Fields) -> Fields:
    before, order_id = dict(record["before"]), record["order_id"]
    before["last_serial"] = before.pop("last_order_id")
    return record | {
        "command": _command(record["command"]),
        "before": before,
        "order_id": text_id(order_id),
        "order_serial": order_id,
    }


# Those whose form changed; in JSON the ids that are keys were text before.
_EVENTS: dict[str, Callable[[Fields], Fields]] = {
    "CommandIssued": lambda event: event | {"command": _command(event["command"])},
    "QueueReported": lambda event: event | {"queue": _queue(event["queue"])},
    "GraphReceived": lambda event: event | {"graph": _graph(event["graph"])},
}

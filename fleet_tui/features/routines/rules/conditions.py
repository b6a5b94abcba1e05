"""Conditions of routines, from the newest state of the fleet."""

import math
from typing import assert_never

from fleet_tui.commands.language.words import vertex_of
from fleet_tui.features.routines.blocks import BatteryCondition, Condition, IdleCondition, PlaceCondition
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.orders.local_queue import all_orders
from fleet_tui.text.errors import CommandError

AT = 1.0
"""Metres from a place within which a robot is at it."""


def condition_holds(state: FleetState, robot: Robot, condition: Condition) -> bool | None:
    """Tell whether a condition holds, None if no fresh report tells it."""
    match condition:
        case BatteryCondition(above, percent):
            if robot.battery is None or not state.is_fresh(robot, "battery"):
                return None
            value = robot.battery.value
            return value > percent if above else value < percent
        case IdleCondition():
            if not robot.kind.lists_orders or not state.is_fresh(robot, "queue"):
                return None
            return all(order.is_over for order in all_orders(state, robot))
        case PlaceCondition(place):
            return _is_at(state, robot, place)
        case _:
            assert_never(condition)


def _is_at(state: FleetState, robot: Robot, place: str) -> bool | None:
    if robot.pose is None or robot.floor is None or not state.is_fresh(robot, "pose"):
        return None
    try:
        vertex, floor = vertex_of(robot, place)
    except CommandError:
        return None
    graph = robot.maps[robot.floor].graph if robot.floor in robot.maps else None
    if graph is None:
        return None
    if floor not in ("", robot.floor) or vertex not in graph.vertices:
        return False
    at, pose = graph.vertices[vertex], robot.pose.value
    return math.dist((at.x, at.y), (pose.x, pose.y)) <= AT

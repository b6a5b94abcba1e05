"""Orders of a routine: the request of an instruction, and the outcome of the order."""

import math
from collections.abc import Sequence

from fleet_tui.commands.language.lookup import starts_here
from fleet_tui.commands.language.words import vertex_of
from fleet_tui.features.routines.blocks import CarryBlock, GoBlock
from fleet_tui.features.routines.lane import OrderEnded, OrderWithheld
from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage
from fleet_tui.model.order import at_vertices
from fleet_tui.model.order_life import latest
from fleet_tui.model.problem import Problem
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message, joined


def order_of(robot: Robot, block: GoBlock | CarryBlock) -> Request | None:
    """Return the request of an instruction, None if the robot is there already. Raises CommandError."""
    places = (block.place,) if isinstance(block, GoBlock) else (block.start, block.end)
    found = [vertex_of(robot, place) for place in places]
    vertices = [vertex for vertex, _ in found]
    if isinstance(block, GoBlock) and not starts_here(robot):
        vertices.insert(0, _start(robot))
    if len(vertices) == 2 and vertices[0] == vertices[1] and isinstance(block, GoBlock):
        return None
    order = PlaceOrder(robot.name, at_vertices(*vertices))
    return Request((order,), tuple((vertex, floor) for vertex, floor in found if floor))


def _start(robot: Robot) -> str:
    """Return the vertex from which a robot will go: the end of its last order, else the nearest one. Raises
    CommandError."""
    last = robot.orders.open[-1].end if robot.orders.open else None
    if last is not None and last.vertex:
        return last.vertex
    robot_map = robot.maps.get(robot.floor or "")
    graph = robot_map.graph if robot_map else None
    if graph is None or not graph.vertices or robot.pose is None:
        raise CommandError(
            Message("{name} needs a start, and its place on the graph is unknown", name=robot.name)
        )
    here = robot.pose.value.x, robot.pose.value.y
    return min(graph.vertices.values(), key=lambda one: math.dist((one.x, one.y), here)).id


def outcome_of(record: CommandRecord) -> OrderEnded | None:
    """Return the outcome of an order that this console gave, None while it is open."""
    if not record.is_decided or record.has_open_order:
        return None
    words = (
        Message("{stage}: {detail}", stage=Message(record.stage.value), detail=record.detail)
        if record.detail
        else Message(record.stage.value)
    )
    return OrderEnded(record.stage is Stage.DONE, words)


def earlier_outcome(robot: Robot, order_id: str) -> OrderEnded | None:
    """Return the outcome of an order of an earlier run, None while the robot still lists it, or nothing was
    heard of it."""
    gone = latest(robot.gone, order_id, -math.inf)
    if gone is not None:
        return OrderEnded(
            gone.stage is Stage.DONE,
            Message("{what}: {reason}", what=Message(gone.stage.value), reason=gone.reason),
        )
    if robot.queue is None or any(one.id == order_id and not one.is_over for one in robot.orders.orders):
        return None
    listed = next((one for one in robot.orders.orders if one.id == order_id), None)
    if listed is not None:
        return OrderEnded(
            False,
            Message(
                "order {order_id}: {state_text} while no console followed it",
                order_id=order_id,
                state_text=listed.state_text,
            ),
        )
    return OrderEnded(
        False, Message("order {order_id} left the queue while no console followed it", order_id=order_id)
    )


_FOR_A_PERSON = frozenset({"no link", "read-only", "not armed"})
"""Errors that a person can remove: the order is right."""


def objection(problems: Sequence[Problem]) -> OrderEnded | OrderWithheld | None:
    """Return the effect of the objections to an order, errors first; None if it may be sent. A warning is for
    a person to decide."""
    if not problems:
        return None
    text = Message("not sent: {problem}", problem=joined("; ", (problem.text for problem in problems)))
    can_fail = problems[0].blocks and problems[0].check not in _FOR_A_PERSON
    return OrderEnded(False, text) if can_fail else OrderWithheld(text)

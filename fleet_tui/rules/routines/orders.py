"""Orders of a routine: the request of an instruction, and the outcome of the order."""

import math

from msgspec import Struct

from fleet_tui.errors import CommandError
from fleet_tui.model import kind
from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage
from fleet_tui.model.order import at_vertices
from fleet_tui.model.order_life import latest
from fleet_tui.model.request import Request
from fleet_tui.model.robot import Robot
from fleet_tui.model.routines.blocks import CarryBlock, GoBlock
from fleet_tui.model.routines.lane import OrderEnded
from fleet_tui.rules.language.words import vertex_of


def order_of(robot: Robot, block: GoBlock | CarryBlock) -> Request | None:
    """Return the request of an instruction, None if the robot is there already. Raises CommandError."""
    places = (block.place,) if isinstance(block, GoBlock) else (block.start, block.end)
    found = [vertex_of(robot, place) for place in places]
    vertices = [vertex for vertex, _ in found]
    if isinstance(block, GoBlock) and needs_start(robot):
        vertices.insert(0, nearest_vertex(robot))
    if len(vertices) == 2 and vertices[0] == vertices[1] and isinstance(block, GoBlock):
        return None
    order = PlaceOrder(robot.name, at_vertices(*vertices))
    return Request((order,), {vertex: floor for vertex, floor in found if floor})


def needs_start(robot: Robot) -> bool:
    """Tell whether an order to a place alone is impossible: such robots take one only with cargo on board."""
    if kind.ORDER_TO not in robot.kind.accepts:
        return True
    return "cargo" in robot.kind.reports and not robot.has_cargo


def nearest_vertex(robot: Robot) -> str:
    """Return the vertex of its floor that is nearest to a robot. Raises CommandError."""
    here_map = robot.maps.get(robot.floor or "")
    graph = here_map.graph if here_map else None
    if graph is None or not graph.vertices or robot.pose is None:
        raise CommandError(f"{robot.name} needs a start, and its place on the graph is unknown")
    here = robot.pose.value.x, robot.pose.value.y
    return min(graph.vertices.values(), key=lambda one: math.dist((one.x, one.y), here)).id


class GivenOrder(Struct, frozen=True):
    """An order that was given: `command` is that very object in its record, None for an order of an earlier
    run; `order_id` in the robot's queue, as far as known."""

    command: PlaceOrder | None
    order_id: str = ""


def outcome_of(record: CommandRecord) -> OrderEnded | None:
    """Return the outcome of an order that this console gave, None while it is open."""
    if not record.is_decided or record.has_open_order:
        return None
    words = f"{record.stage.value}: {record.detail}" if record.detail else record.stage.value
    return OrderEnded(record.stage is Stage.DONE, words)


def earlier_outcome(robot: Robot, order_id: str) -> OrderEnded | None:
    """Return the outcome of an order of an earlier run, None while the robot still lists it, or nothing was
    heard of it."""
    gone = latest(robot.gone, order_id, -math.inf)
    if gone is not None:
        return OrderEnded(gone.stage is Stage.DONE, f"{gone.stage.value}: {gone.reason}")
    if robot.queue is None or any(one.id == order_id and not one.is_over for one in robot.orders.orders):
        return None
    listed = next((one for one in robot.orders.orders if one.id == order_id), None)
    if listed is not None:
        return OrderEnded(False, f"order {order_id}: {listed.state_text} while no console followed it")
    return OrderEnded(False, f"order {order_id} left the queue while no console followed it")

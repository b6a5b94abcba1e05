"""Search for the order in a robot's queue that a command placed."""

from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order, OrderQueue
from fleet_tui.model.robot import Robot
from fleet_tui.orders.goals import is_given_as

CLOCKS_AGREE = 1.0
"""Seconds by which a robot's clock, by the arrival of its messages, may differ from ours."""


def queue_since(robot: Robot, record: CommandRecord) -> OrderQueue | None:
    """Return the queue, if it was reported after the command had been sent."""
    if robot.kind.reports_ends:
        # It is sent on change: the last one is valid, however old, and a missing one means empty.
        return robot.orders
    sent = record.time_of(Stage.SENT)
    if robot.queue is None or sent is None or robot.queue.at <= sent:
        return None
    return robot.queue.value


def _is_of_another_life(other: CommandRecord, record: CommandRecord, last: int) -> bool:
    """Tell whether the robot restarted its count between two commands: a serial seen before the second one
    was given was above the last one known at that time."""
    claimed = other.time_of(Stage.LATE) or other.time_of(Stage.CONFIRMED)
    decided = claimed is not None and claimed <= record.issued_at
    return other.order_serial is not None and decided and other.order_serial > last


def find_order(state: FleetState, robot: Robot, record: CommandRecord, by_echo: bool = True) -> Order | None:
    """Find the order in the queue that a command placed: by the name that this console gave it, else by its
    content. `by_echo`: not if the queue attributes it to another request."""
    if record.name:
        named = (order for order in robot.orders.orders if record.name in (order.name, order.id))
        return next(named, None)
    return _find_alike(state, robot, record, by_echo)


def _find_alike(state: FleetState, robot: Robot, record: CommandRecord, by_echo: bool) -> Order | None:
    """Find a new order with the same stops that has no other origin."""
    queue, command, last = queue_since(robot, record), record.command, record.before.last_serial
    if queue is None or last is None or not isinstance(command, PlaceOrder):
        return None
    if queue.last_serial < record.before.counted:
        last = 0  # the robot was restarted before it took the order: its serials start over
    taken = {
        other.order_id
        for other in state.commands
        if other.command.robot == robot.name and not _is_of_another_life(other, record, last)
    }
    found = [
        order
        for order in queue.orders
        if order.serial > last
        and order.id not in taken
        and could_be(command, order)
        and (not robot.kind.keeps_goals or is_given_as(robot.goals, order.id, command.stops))
        and _is_since(record, order)
    ]
    if len(found) > 1 and not any(order.stops for order in found):
        return None  # the origin of each is unknown
    if not by_echo:
        return _oldest(found)
    own = (0, record.id, record.before.request_id)
    found = [one for one in found if one.id not in robot.traces or robot.traces[one.id].request_id in own]
    return _by_echo(found, queue, record)


def could_be(command: PlaceOrder, order: Order) -> bool:
    """Tell whether an order matches this command. One for the cargo on board begins anywhere."""
    if not order.stops:
        # A goal: its robot does not report its target.
        return not order.label
    return order.stops[-1:] == command.stops if command.with_cargo else order.stops == command.stops


def _is_since(record: CommandRecord, order: Order) -> bool:
    """Tell whether a robot took an order after a command had left, by clocks that are compared roughly."""
    sent = record.time_of(Stage.SENT)
    return order.taken_at is None or sent is None or order.taken_at > sent - CLOCKS_AGREE


def _oldest(orders: list[Order]) -> Order | None:
    return min(orders, key=lambda order: order.serial, default=None)


def _by_echo(found: list[Order], queue: OrderQueue, record: CommandRecord) -> Order | None:
    """Choose among equal orders. The queue echoes the request of its newest order, if at all: if the echo
    changed since the command was given, the newest order belongs to that request."""
    newest = [order for order in found if order.serial == queue.last_serial]
    if queue.request_id == record.id and newest:
        return newest[0]
    if queue.request_id not in (0, record.id, record.before.request_id):
        found = [order for order in found if order not in newest]
    return _oldest(found)

"""Orders that this console keeps for robots that drive one goal at a time, and when the next one may
leave."""

from collections.abc import Iterator

from msgspec.structs import replace

from fleet_tui.model.commands import (
    ClearOrders,
    Command,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    Queued,
    Stage,
)
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.navigation_events import QueueHeld
from fleet_tui.model.order import Order, Stop
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SendGoal, StartCharging
from fleet_tui.orders.goals import own_ids
from fleet_tui.orders.masters import asked_about, own_mode
from fleet_tui.text.language import EMPTY, Message

PREFIX = "k"
"""Prefix of the ids of orders that are kept here: a robot's goals have hexadecimal ones."""
ANOTHER_CLIENT = Message("another client is driving")
HELD_BY_OTHERS = (ANOTHER_CLIENT, "someone else drives")
"""The second is that of older recordings."""

_WELL = frozenset({Stage.DONE, Stage.CONFIRMED})
"""Ends of an order, and of the start of a charge."""
GOING = frozenset({Stage.CHECKED, Stage.SENT, Stage.ACCEPTED, Stage.NO_ANSWER, Stage.UNKNOWN})
"""Stages of an order that has left, and that its robot may have taken."""


def orders_of(state: FleetState, robot: Robot) -> list[CommandRecord]:
    """Return the orders that this console gave to a robot, in driving order: a stopped one that is kept
    precedes those never begun."""
    found = [
        one for one in state.commands if one.command.robot == robot.name and isinstance(one.command, Queued)
    ]
    return sorted(found, key=turn_of)


def turn_of(record: CommandRecord) -> float:
    """Return the sort key of an order that this console gave: that of its issue, unless it was moved."""
    return record.issued_at if record.turn is None else record.turn


def waiting(state: FleetState, robot: Robot) -> list[CommandRecord]:
    """Return the orders that wait here, the next one first."""
    return [one for one in orders_of(state, robot) if one.stage is Stage.WAITING]


def orders_to_save(state: FleetState, robot: Robot) -> Iterator[tuple[CommandRecord, tuple[Stop, ...]]]:
    """Return the orders with stops unknown to the robot, with the stops that are left, and the charges that
    wait, which have none."""
    for one in orders_of(state, robot):
        stops = one.command.stops if isinstance(one.command, PlaceOrder) else ()
        if one.stage is Stage.WAITING:
            yield one, stops[one.leg :]
        elif one.has_further_leg(robot.kind) and (one.has_open_order or one.stage in GOING):
            yield one, stops[one.leg + 1 :]


def waiting_orders_of(state: FleetState, robot: Robot) -> tuple[Order, ...]:
    """Return the orders that wait here, as shown in a queue."""
    return tuple(_waiting_order(one) for one in waiting(state, robot))


def _waiting_order(record: CommandRecord) -> Order:
    command = record.command
    stops = command.stops if isinstance(command, PlaceOrder) else ()
    label = command.text if isinstance(command, StartCharging) else ""
    return Order(record.order_id or "", stops, None, record.stage.value, 0, label=label)


def bids_of(state: FleetState, robot: Robot) -> tuple[Order, ...]:
    """Return the orders to any robot for which fleets still bid, at the robot that they were given from."""
    return tuple(
        Order(one.name, one.command.stops, None, Message("fleets bid"), 0)
        for one in state.commands
        if one.command.robot == robot.name and isinstance(one.command, PlaceOrder) and is_bid(one)
    )


def is_bid(record: CommandRecord) -> bool:
    """Tell whether a dispatcher has taken an order to any robot, and has not chosen one yet."""
    command = record.command
    return isinstance(command, PlaceOrder) and command.to_any and record.stage is Stage.ACCEPTED


def all_orders(state: FleetState, robot: Robot) -> tuple[Order, ...]:
    """Return the orders of a robot in driving sequence: its own, then those for which fleets bid, or that
    wait here."""
    own = robot.orders.in_sequence() + bids_of(state, robot)
    return own + waiting_orders_of(state, robot) if robot.kind.keeps_goals else own


def clearable(state: FleetState, robot: Robot) -> tuple[Order, ...]:
    """Return the orders that a clear cancels: all, but of goals only those that this console gave."""
    listed = tuple(order for order in all_orders(state, robot) if not order.is_over)
    if not robot.kind.clears_own:
        return listed
    ours = {*own_ids(robot.goals), *(order.id for order in waiting_orders_of(state, robot))}
    return tuple(order for order in listed if order.id in ours)


def next_id(state: FleetState, robot: Robot) -> str:
    """Return an id for a new waiting order."""
    taken = [one.order_id or "" for one in orders_of(state, robot)]
    numbers = [int(id_[1:]) for id_ in taken if id_.startswith(PREFIX) and id_[1:].isdigit()]
    return f"{PREFIX}{max(numbers, default=0) + 1}"


def foreign(state: FleetState, robot: Robot) -> list[Order]:
    """Return the active orders from other clients, as far as this console knows its own."""
    known = {one.order_id for one in orders_of(state, robot)}
    unknown = any(one.stage in GOING for one in orders_of(state, robot))
    return [] if unknown else [order for order in robot.orders.open if order.id not in known]


def is_busy(state: FleetState, robot: Robot, command_id: int) -> bool:
    """Tell whether the order of a command, if sent now, would replace another one, overtake it, or let a
    paused robot drive."""
    return (
        bool(robot.orders.open)
        or (robot.kind.holds and robot.paused_by_us)
        or any(
            one.stage is Stage.WAITING or one.stage in GOING or one.has_open_order
            for one in orders_of(state, robot)
            if one.id < command_id  # later ones of the same request follow it
        )
    )


def failed_before(state: FleetState, robot: Robot, command_id: int) -> Message:
    """Return how an order that was given together with a command, before it, has failed already; empty if
    none has."""
    orders = orders_of(state, robot)
    given_at = next((one.issued_at for one in orders if one.id == command_id), None)
    together = (one for one in orders if one.issued_at == given_at and one.id < command_id)
    failed = (one for one in together if one.is_decided and one.stage not in _WELL)
    return next(
        (Message("order before it: {stage}", stage=Message(one.stage.value)) for one in failed), EMPTY
    )


def next_to_send(state: FleetState, robot: Robot) -> CommandRecord | None:
    """Return the order that may be sent now, if any: the one before is done, and there is no objection."""
    kept = waiting(state, robot)
    if not kept or robot.held or state.is_paused(robot) or not state.is_online(robot):
        return None
    if state.links[robot.link].phase is not Phase.UP or robot.orders.open:
        return None
    others = (one for one in orders_of(state, robot) if one.stage is not Stage.WAITING)
    if any(one.stage in GOING or one.has_open_order for one in others):
        return None
    # An event between two ticks may hold the queue from the next one on.
    return None if next(_reasons(state, robot), "") else kept[0]


def withdrawn(state: FleetState, command_id: int, since: float) -> Message:
    """Return the reason not to send a goal any more that was given a moment ago, at `since` (monotonic);
    empty if it may be sent, and for any other command."""
    record = next((one for one in state.commands if one.id == command_id), None)
    if record and not _drives(state, record.command):
        return EMPTY
    if record is None or record.stage not in (Stage.CHECKED, Stage.WAITING):
        return Message("cancelled before it was sent")
    if record.stage is Stage.CHECKED:  # never queued: a pause may be given while this is still written down
        since = record.issued_at
    for other in state.commands:
        meant = other.command.robot == record.command.robot and other.issued_at > since
        if meant and other.stage not in (Stage.REFUSED, Stage.NOT_SENT):
            if isinstance(other.command, PauseRobot):
                return Message("robot paused before it was sent")
            if isinstance(other.command, ClearOrders):
                return Message("robot's orders cleared before it was sent")
    return EMPTY


def _drives(state: FleetState, command: Command) -> bool:
    """Tell whether a command is a goal, which a pause must overtake."""
    is_order = isinstance(command, PlaceOrder)
    return isinstance(command, SendGoal) or (is_order and state.robots[command.robot].kind.keeps_goals)


def hold_all(state: FleetState, reason: Message) -> Iterator[QueueHeld]:
    """Return the events that hold every queue with stops left to send."""
    return (QueueHeld(robot.name, reason) for robot in state.robots.values() if _has_more(state, robot))


def _has_more(state: FleetState, robot: Robot) -> bool:
    """Tell whether there is something left to send to a robot, even the next stop of its current order."""
    return bool(waiting(state, robot)) or any(orders_to_save(state, robot))


def with_held_queues(state: FleetState) -> FleetState:
    """Hold the queue of each robot after an event that the operator must know of first."""
    changed = {
        robot.name: now
        for robot in state.robots.values()
        if robot.kind.keeps_goals and (now := _with_held_queue(state, robot)) is not robot
    }
    return replace(state, robots={**state.robots, **changed}) if changed else state


def _with_held_queue(state: FleetState, robot: Robot) -> Robot:
    held, accepted = _held(state, robot), robot.accepted
    if accepted:  # one that went and comes again is another one
        present = asked_about(state, robot)
        accepted = tuple(text for text in accepted if text in present)
    if (held, accepted) == (robot.held, robot.accepted):
        return robot
    return replace(robot, held=held, accepted=accepted)


def _held(state: FleetState, robot: Robot) -> Message:
    """Return the reason to hold its queue from now on: the first one counts, as long as there is something to
    send."""
    if not _has_more(state, robot):
        return EMPTY
    return robot.held or next(_reasons(state, robot), EMPTY)


def _reasons(state: FleetState, robot: Robot) -> Iterator[Message]:
    if foreign(state, robot):
        yield ANOTHER_CLIENT
    link, last = state.links[robot.link], robot.last_received
    if link.phase is not Phase.UP:
        yield Message("the link was lost")
    elif last is not None and last >= link.since and not state.is_online(robot):  # else it was not heard yet
        yield Message("{name} was offline", name=robot.name)
    for one in waiting(state, robot)[:1]:
        # On another floor the same ids are other places.
        if one.before.floor and robot.floor and one.before.floor != robot.floor:
            yield Message(
                "order {order_id} is for {floor}, {name} is on {robot_floor}",
                order_id=one.order_id,
                floor=one.before.floor,
                name=robot.name,
                robot_floor=robot.floor,
            )
        # Nobody was asked about an emergency stop or a fatal error since: a new order would be.
        against = (problem.text for problem in own_mode(state, robot, one.command))
        yield from (text for text in against if text not in robot.accepted)
    sent = [one for one in orders_of(state, robot) if one.stage is not Stage.WAITING]
    before = max(sent, key=lambda one: one.time_of(Stage.SENT) or one.issued_at, default=None)
    if before is None or not before.is_decided or before.has_open_order or before.at <= robot.released_at:
        return
    if before.stage not in _WELL:
        stage = Message(before.stage.value)
        if before.order_id:
            yield Message("order {order_id}: {stage}", order_id=before.order_id, stage=stage)
        else:
            yield Message("previous order: {stage}", stage=stage)

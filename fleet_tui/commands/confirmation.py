"""Confirmation of commands by telemetry.

An answer is only the robot's claim; the queue and the pose decide.
"""

from typing import assert_never

from msgspec.structs import replace

from fleet_tui.commands.order_search import find_order, queue_since
from fleet_tui.commands.set_up.confirmation import instead_of_set_up, set_up_seen
from fleet_tui.model.commands import (
    NEXT,
    UNANSWERED,
    Baseline,
    CancelOrder,
    ClearOrders,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
    Step,
)
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import Phase
from fleet_tui.model.order import PENDING, Order, OrderState
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.orders.goals import own_ids
from fleet_tui.orders.local_queue import is_bid
from fleet_tui.situation.pauses import WAITS, instead_of_pause, pause_seen
from fleet_tui.situation.reported_motion import is_moving
from fleet_tui.text.language import Message, joined, verbatim

BIDDING = 15.0
"""Seconds for which fleets may bid for an order to any robot, before one has it."""

REASON_FIRST = 1.0
"""Seconds that a goal has beyond its time: its link, which waits as long for an answer, may know more."""

IN_QUEUE = "seen in the queue as order "
"""The reason of an order that is confirmed; its id follows."""


def before(robot: Robot, now: float) -> Baseline:
    """Return the robot's reports up to `now`, when a command is given."""
    queue = robot.orders
    known = robot.queue is not None or robot.kind.reports_ends
    last = max([queue.last_serial, *(order.serial for order in queue.orders)]) if known else None
    return Baseline(last, is_moving(robot, now), queue.request_id, queue.last_serial, robot.floor or "")


def is_repeated(state: FleetState, record: CommandRecord) -> bool:
    """Tell whether the same command was sent since and is still open: reports now belong to that one."""
    return any(
        other.command == record.command
        and other.issued_at > record.issued_at
        and not other.is_decided
        and other.stage is not Stage.WAITING
        for other in state.commands
    )


def _still_there(robot: Robot, record: CommandRecord) -> list[str] | None:
    """Return those of the orders to remove that are still in the queue; None before the first queue."""
    queue, last = queue_since(robot, record), record.before.last_serial
    if queue is None:
        return None
    match record.command:
        case CancelOrder(_, order_id):
            left = [
                one for one in queue.orders if one.id == order_id and one.state is not OrderState.CANCELLED
            ]
        case ClearOrders():
            left = [
                one for one in queue.orders if one.state in PENDING and (last is None or one.serial <= last)
            ]
            if robot.kind.clears_own:  # those of others are not affected
                left = [one for one in left if one.id in own_ids(robot.goals)]
        case PlaceOrder() | PauseRobot() | ResumeRobot() | SetUpCommand():
            left = []
        case _:
            assert_never(record.command)
    return [Message("order {id} is {state_text}", id=order.id, state_text=order.state_text) for order in left]


def _is_bid_for(state: FleetState, record: CommandRecord) -> bool:
    """Tell whether fleets still bid for the order to cancel."""
    command = record.command
    return isinstance(command, CancelOrder) and any(
        is_bid(one) and one.name == command.order_id for one in state.commands
    )


def _is_driven(state: FleetState, record: CommandRecord) -> bool:
    """Tell whether a goal that a clear cancels by its name is active, or may still be listed."""
    return isinstance(record.command, ClearOrders) and any(
        one.name and (one.stage in WAITS | {Stage.SENT} or one.has_open_order)
        for one in state.commands
        if one.command.robot == record.command.robot and one.issued_at <= record.issued_at
        if isinstance(one.command, PlaceOrder)
    )


def _order_of(
    state: FleetState, robot: Robot, record: CommandRecord, by_echo: bool
) -> tuple[CommandRecord, Order | None]:
    """Return the order that a command placed; one to any robot becomes that of the robot that has it."""
    if not isinstance(record.command, PlaceOrder) or not record.command.to_any:
        return record, find_order(state, robot, record, by_echo)
    for other in state.robots.values():
        if other.link == robot.link and (order := find_order(state, other, record)) is not None:
            return replace(record, command=replace(record.command, robot=other.name)), order
    return record, None


def _seen(state: FleetState, robot: Robot, record: CommandRecord, by_echo: bool) -> CommandRecord:
    """Return the record, confirmed if telemetry shows that the command was carried out."""
    match record.command:
        case PlaceOrder():
            record, order = _order_of(state, robot, record, by_echo)
            if order is None:
                return record
            if order.state is OrderState.REFUSED and Stage.REFUSED in NEXT[record.stage]:
                return record.advanced(Step(Stage.REFUSED, state.now, verbatim(order.said)))
            if record.stage is Stage.SENT:  # a goal, whose acceptance has no other answer
                record = record.advanced(Step(Stage.ACCEPTED, state.now))
            step = Step(
                Stage.CONFIRMED, state.now, Message("seen in the queue as order {name}", name=order.id)
            )
            return record.recognised(order, step)
        case CancelOrder() | ClearOrders():
            if _is_bid_for(state, record) or _still_there(robot, record) != [] or _is_driven(state, record):
                return record
            return record.advanced(Step(Stage.CONFIRMED, state.now, Message("no longer in the queue")))
        case PauseRobot():
            found = pause_seen(state, robot, record, wanted=True)
        case ResumeRobot():
            found = pause_seen(state, robot, record, wanted=False)
        case SetUpCommand():
            found = set_up_seen(state, robot, record, record.command)
        case _:
            assert_never(record.command)
    return record if found is None else record.advanced(found)


def _instead(state: FleetState, robot: Robot, record: CommandRecord) -> Message:
    """Return the evidence of telemetry if a command can't be seen to have been carried out."""
    offline = queue_since(robot, record) is None
    match record.command:
        case PauseRobot() | ResumeRobot():
            return instead_of_pause(state, robot, record)
        case SetUpCommand():
            return instead_of_set_up(robot, record, record.command)
        case PlaceOrder() | CancelOrder() | ClearOrders() if offline:
            return Message("no queue received since")
        case PlaceOrder() if robot.kind.reports_ends:
            new = [one for one in robot.orders.orders if one.serial > (record.before.last_serial or 0)]
            several = len(new) > 1 and not record.name
            return Message("ambiguous: several new goals") if several else Message("no new goal seen")
        case PlaceOrder():
            unknown = record.before.last_serial is None
            return (
                Message("queue unknown before the command") if unknown else Message("order not in the queue")
            )
        case CancelOrder() | ClearOrders():
            return joined(", ", (_still_there(robot, record) or [])[:3]) or Message(
                "no evidence in telemetry"
            )
        case _:
            assert_never(record.command)


def _deadline(state: FleetState, robot: Robot, record: CommandRecord) -> float | None:
    """Return the time limit for telemetry to show it; None while there is no link."""
    link = state.links[robot.link]
    if link.phase is not Phase.UP:
        return None
    within = record.command.within if isinstance(record.command, SetUpCommand) else 0.0
    if isinstance(record.command, PlaceOrder) and record.command.to_any:
        within = BIDDING
    spare = REASON_FIRST if record.stage is Stage.SENT else 0.0
    return max(record.at, link.since) + max(state.limits.confirm_after, within) + spare + state.behind


def _is_goal_under_way(robot: Robot, record: CommandRecord) -> bool:
    is_goal = robot.kind.keeps_goals and isinstance(record.command, PlaceOrder)
    return is_goal and record.stage is Stage.SENT


def confirm(state: FleetState, record: CommandRecord) -> CommandRecord:
    """Return the record after a check of its robot's reports."""
    robot = state.robots.get(record.command.robot)
    if robot is None or not (record.stage in WAITS or _is_goal_under_way(robot, record)):
        return record
    deadline = _deadline(state, robot, record)
    is_last_look = deadline is not None and state.now >= deadline
    # The echo is not always reliable: an order attributed to another request is accepted in the end.
    looked = _seen(state, robot, record, by_echo=not is_last_look)
    if looked.is_decided or not is_last_look:
        return looked
    if record.stage is Stage.SENT:
        record = record.advanced(Step(Stage.NO_ANSWER, state.now))
    said = UNANSWERED if record.detail == UNANSWERED else Message(record.stage.value)
    if record.detail and record.stage is not Stage.ACCEPTED:
        said = Message("{said}: {detail}", said=said, detail=record.detail)
    detail = Message("{said}; {instead}", said=said, instead=_instead(state, robot, record))
    return record.advanced(Step(Stage.NOT_CONFIRMED, state.now, detail))

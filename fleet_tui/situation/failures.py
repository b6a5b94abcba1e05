"""Commands that failed, as conditions of the alarm list.

A failure is a moment and does not hold: it counts as news for a while, then its alarm has returned, and stays
until it is acknowledged.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import assert_never

from fleet_tui.model import commands
from fleet_tui.model.alarm import Condition, Key, Priority, class_of
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import route_text
from fleet_tui.model.order_life import UNSAID
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.situation.batches import batches
from fleet_tui.situation.causes import cause_of_end, remedy_of
from fleet_tui.situation.facts import STILL_MOVING
from fleet_tui.situation.robots import drives_on as find_drives_on
from fleet_tui.text.details import detail_text
from fleet_tui.text.language import EMPTY, N_, Message

FAILED_FOR = 30.0
"""Seconds for which a command that failed counts as news."""
_OVER = {
    commands.Stage.NOT_CONFIRMED: N_("was not confirmed"),
    commands.Stage.LATE: N_("was carried out late"),
    **{stage: end.over for stage, end in commands.ORDER_ENDS.items()},
}
_CAUSED = frozenset({commands.Stage.REFUSED, commands.Stage.FAILED, commands.Stage.NOT_CONFIRMED})
"""Failures of which the cause is first: the request is known to the operator."""
CARRIED_OUT = Message("Do not repeat the command: the robot has carried it out")
MAY_FOLLOW = Message("Check the robot and its queue before you repeat the order: it may still be carried out")
DRIVES_ON = Message("It still has the order: pause it, or stop it at the robot, then cancel again")
REJECTED = Message("Check that its navigation is active: `fleet-tui doctor` asks it")
MANY = 5
"""Failed commands to at least this many robots given together are one alarm."""


def _has_own_alarm(state: FleetState, record: commands.CommandRecord) -> bool:
    """Tell whether a pause was not confirmed because its robot moves on: that is an alarm by itself."""
    key = (record.command.robot, STILL_MOVING.name)
    if (
        not isinstance(record.command, commands.PauseRobot)
        or record.stage is not commands.Stage.NOT_CONFIRMED
    ):
        return False
    return any(alarm.key == key and alarm.first_text == STILL_MOVING.word for alarm in state.alarms)


def has_failed(record: commands.CommandRecord) -> bool:
    """Tell whether a command of this console needs a person: it failed, or continued unexpectedly."""
    return record.stage in commands.FAILURES and record.stage is not commands.Stage.NOT_SENT


def _request_text(robot: Robot, command: commands.Command) -> Message:
    match command:
        case commands.PlaceOrder(_, stops):
            return command.text(robot.kind, route_text(stops, lambda vertex: robot.name_of(vertex) or vertex))
        case commands.CancelOrder(_, order_id):
            return Message("cancel order {order_id}", order_id=order_id)
        case commands.ClearOrders():
            return Message("clear all orders")
        case commands.PauseRobot():
            return Message("pause")
        case commands.ResumeRobot():
            return Message("resume")
        case SetUpCommand():
            return command.text
        case _:
            assert_never(command)


def failed_commands(state: FleetState) -> Iterator[Condition]:
    """Return commands that failed a short while ago: an alarm for each robot, or for each link on which one
    request to many robots failed."""
    failures = (record for record in state.commands if has_failed(record))
    news = (record for record in failures if state.now - record.at < FAILED_FOR)
    fresh = [record for record in news if not _has_own_alarm(state, record)]
    if not fresh:
        return
    given = {record.id: len(batch) for batch in batches(state.commands) for record in batch}
    failed: dict[Key, list[commands.CommandRecord]] = defaultdict(list)
    for record in fresh:
        robot = state.robots.get(record.command.robot)
        if robot is not None:
            many = given[record.id] >= MANY
            failed[(robot.link, "many commands") if many else (robot.name, "command")].append(record)
    for key, records in failed.items():
        yield _failed(state, key, records)


def taken_back(state: FleetState) -> set[Key]:
    """Return the keys of the alarms on ends of orders that all were corrected to what needs no person."""
    alarms = [alarm for alarm in state.alarms if class_of(alarm.condition.kind) == "command"]
    if not alarms:
        return set()
    corrected = {
        f"{record.id} {stage.value}"
        for record in state.commands
        if record.stage not in commands.FAILURES
        for stage in commands.CORRECTABLE
    }
    return {alarm.key for alarm in alarms if alarm.condition.parts and alarm.condition.parts <= corrected}


def _cause(robot: Robot, last: commands.CommandRecord) -> Message:
    """Return why an order of this console failed, empty if nothing tells."""
    detail = last.reason
    gone = next((one for one in reversed(robot.gone) if one.order.id == last.order_id), None)
    if gone is not None and detail in ("", UNSAID):
        return cause_of_end(robot, gone)
    return EMPTY if detail == UNSAID else detail


def failure_remedy(state: FleetState, robot: Robot, last: commands.CommandRecord) -> Message:
    """Return what to do about a command that failed, empty for the action of its class."""
    is_order = isinstance(last.command, commands.PlaceOrder)
    removes = isinstance(last.command, commands.CancelOrder | commands.ClearOrders)
    if last.stage is commands.Stage.LATE:
        return CARRIED_OUT
    if removes and robot.orders.current is not None:
        return DRIVES_ON
    if is_order and last.stage is commands.Stage.NOT_CONFIRMED:
        return MAY_FOLLOW
    if is_order and (fact := find_drives_on(state, robot)) is not None:
        return fact.action
    drives = isinstance(last.command, commands.PlaceOrder | commands.ResumeRobot)
    if drives and robot.kind.keeps_goals and last.stage is commands.Stage.REFUSED:
        return REJECTED
    remedy = remedy_of(_cause(robot, last)) if last.stage is commands.Stage.FAILED else EMPTY
    end = commands.ORDER_ENDS.get(last.stage)
    return remedy or (end.remedy if end is not None else EMPTY)


def _texts(robot: Robot, last: commands.CommandRecord, request: Message) -> tuple[Message, Message]:
    """Return the text of a failure while it is news, and after."""
    detail = last.reason
    if last.stage is commands.Stage.FAILED and isinstance(last.command, commands.PlaceOrder):
        # In the form of an order of another client.
        cause = _cause(robot, last) or Message("no reason reported")
        return Message("{request} failed: {cause}", request=request, cause=cause), Message(
            "{request} failed", request=request
        )
    told = request + detail_text(last.detail)
    if last.stage in _CAUSED and last.detail:
        told = Message("{detail} ({request})", detail=detail, request=request)
    # The failure and its cause are first: they must not be cut at the right end.
    over = Message(_OVER.get(last.stage, "failed"))
    return (
        Message("{stage}: {reason}", stage=Message(last.stage.value), reason=told),
        Message("{stage}: {reason}", stage=over, reason=request),
    )


def _failed(state: FleetState, key: Key, records: Sequence[commands.CommandRecord]) -> Condition:
    last = records[-1]
    request = _request_text(state.robots[last.command.robot], last.command)
    robots = {record.command.robot for record in records}
    if len(robots) > 1:
        request += Message(" of {robots} robots", robots=len(robots))
    # The only one of many is named first: the alarm is the link's.
    whose = f"{last.command.robot} " if len(robots) == 1 and key[0] not in robots else ""
    high = any(isinstance(record.command, commands.PauseRobot) for record in records)
    robot = state.robots[last.command.robot]
    told, over = _texts(robot, last, request)
    return Condition(
        *key,
        Priority.HIGH if high else Priority.MEDIUM,
        Message("{whose}{told}", whose=whose, told=told),
        Message("{whose}{over}", whose=whose, over=over),
        # A failure that changes into another one is news.
        parts=frozenset(f"{record.id} {record.stage.value}" for record in records),
        remedy=failure_remedy(state, robot, last),
    )

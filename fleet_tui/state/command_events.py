"""Events of commands: the effect of each on the state."""

from collections.abc import Iterator, Sequence
from itertools import islice
from typing import assert_never

from msgspec.structs import replace

from fleet_tui.commands.confirmation import before, confirm
from fleet_tui.commands.follow_up import follow_up
from fleet_tui.commands.queue_moves import moved
from fleet_tui.model import events, navigation_events
from fleet_tui.model.commands import (
    Baseline,
    CancelOrder,
    ClearOrders,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    Queued,
    ResumeRobot,
    Stage,
    Step,
)
from fleet_tui.model.fleet import FleetState, with_robot
from fleet_tui.model.fleets.events import DispatchFact, DispatchFailed, RequestAnswered
from fleet_tui.model.set_up.commands import SetMapping, SetPose, SetUpCommand
from fleet_tui.orders.local_queue import next_id
from fleet_tui.orders.masters import asked_about
from fleet_tui.state.goal_reports import know_stops
from fleet_tui.text.language import EMPTY, verbatim
from fleet_tui.text.limits import truncate


def take_dispatch(state: FleetState, event: DispatchFact) -> FleetState:
    """Return the state after an answer, which may be to another console's request."""
    name = event.task if isinstance(event, DispatchFailed) else event.request
    if not name or not any(one.name == name for one in state.commands):
        return state
    commands = tuple(_advanced(one, event) if one.name == name else one for one in state.commands)
    return replace(state, commands=commands)


def _advanced(record: CommandRecord, event: DispatchFact) -> CommandRecord:
    if isinstance(event, DispatchFailed):
        stage = Stage.CANCELLED if event.is_cancelled else Stage.REFUSED
        return record.advanced(Step(stage, event.at, verbatim(truncate(event.reason))))
    record = record.advanced(Step(event.stage, event.at, verbatim(truncate(event.detail))))
    # From now on the task is known by its own id: not every version passes on the name of its requester.
    return (
        replace(record, name=event.task) if event.task and isinstance(record.command, PlaceOrder) else record
    )


COMMANDS_KEPT = 200


def confirm_commands(state: FleetState) -> FleetState:
    """Confirm commands in sequence: each order in a queue belongs to one command only."""
    for record in state.commands:
        looked = follow_up(state, record) if record.is_decided else confirm(state, record)
        if looked is not record:
            state = _after_step(_with_record(state, looked), looked)
        if looked.leg > record.leg:
            state = _at_stop(state, record)
    return state


def _at_stop(state: FleetState, record: CommandRecord) -> FleetState:
    """Record the stop of its goal, which led to that one only and is done there."""
    robot, command = state.robots[record.command.robot], record.command
    assert isinstance(command, PlaceOrder) and record.order_id is not None
    stop = command.stops[record.leg : record.leg + 1]
    return with_robot(state, know_stops(robot, record.order_id, stop, is_ours=True))


def _with_record(state: FleetState, record: CommandRecord) -> FleetState:
    commands = tuple(record if one.id == record.id else one for one in state.commands)
    return replace(state, commands=commands)


def _after_step(state: FleetState, record: CommandRecord) -> FleetState:
    """Record our own pause: without a topic for it, nothing else is known."""
    robot = state.robots.get(record.command.robot)
    if robot is not None and record.stage is Stage.SENT and isinstance(record.command, PauseRobot):
        # A topic among what was sent is that of the lock.
        return with_robot(state, replace(robot, locked_by_us=robot.locked_by_us or record.name != ""))
    if robot is not None and record.stage is Stage.SENT and isinstance(record.command, SetPose):
        return with_robot(state, replace(robot, pose_set_at=record.steps[-1].at))
    if robot is None or record.stage not in (Stage.ACCEPTED, Stage.CONFIRMED, Stage.LATE):
        return state
    match record.command:
        case PauseRobot():
            # Until it is seen to stop, its place is that of the next pose: of many robots the last one may be
            # from metres before.
            at = robot.pose.value if robot.pose and record.stage is Stage.CONFIRMED else None
            since = robot.paused_since if robot.paused_by_us else record.issued_at
            return with_robot(state, replace(robot, paused_by_us=True, paused_since=since, paused_at=at))
        case ResumeRobot():
            released = replace(
                robot,
                paused_by_us=False,
                paused_at=None,
                locked_by_us=False,
                held=EMPTY,
                released_at=state.now,
                accepted=asked_about(state, robot),
            )
            return with_robot(state, released)
        case PlaceOrder(_, stops) if record.order_id is not None:
            return with_robot(state, know_stops(robot, record.order_id, stops, is_ours=True))
        case SetMapping(_, on):
            return with_robot(state, replace(robot, mapping_by_us=on))
        case PlaceOrder() | CancelOrder() | ClearOrders() | SetUpCommand():
            return state
        case _:
            assert_never(record.command)


def advance_command(state: FleetState, event: events.CommandAdvanced) -> FleetState:
    """Advance a command. It ends once: later events for it change nothing."""
    found = next((record for record in state.commands if record.id == event.id), None)
    if found is None or (event.stage is Stage.WAITING and not isinstance(found.command, Queued)):
        return state
    record = found.advanced(
        Step(_late_or(event.stage, state, found), event.at, verbatim(truncate(event.detail)))
    )
    if record is found:
        return state
    robot = state.robots.get(record.command.robot)
    if record.stage is Stage.WAITING and found.stage is not Stage.WAITING and robot is not None:
        record = replace(record, order_id=next_id(state, robot))
    elif found.stage is Stage.WAITING and robot is not None and record.stage is Stage.SENT:
        record = replace(
            record, order_id=None, order_serial=None, answer=None, before=before(robot, event.at)
        )
    if record.stage is Stage.SENT and robot is not None and event.name:
        record = replace(record, name=event.name)
        if isinstance(record.command, PlaceOrder):
            state = with_robot(state, replace(robot, named=event.name))
    return _after_step(_with_record(state, record), record)


def take_answer(
    state: FleetState, event: navigation_events.GoalAnswered | RequestAnswered | DispatchFailed
) -> FleetState:
    """Record a robot's answer on the end of a goal, or a dispatcher's answer to a request."""
    if not isinstance(event, navigation_events.GoalAnswered):
        return take_dispatch(state, event)
    found = next((record for record in state.commands if record.id == event.id), None)
    if found is None:
        return state
    answer = Step(event.stage, event.at, verbatim(truncate(event.detail)))
    return _with_record(state, replace(found, answer=answer))


def _late_or(stage: Stage, state: FleetState, record: CommandRecord) -> Stage:
    """Return the stage that an answer leads to. Without a topic for pauses, a late answer is the only sign
    that the command was carried out."""
    robot = state.robots.get(record.command.robot)
    late = stage is Stage.ACCEPTED and record.stage is Stage.NOT_CONFIRMED
    untold = robot is not None and not robot.says_paused
    return Stage.LATE if late and untold and isinstance(record.command, PauseRobot | ResumeRobot) else stage


def _is_in_queue(state: FleetState, record: CommandRecord) -> bool:
    """Tell whether the order it placed is still queued: until then its origin must be known."""
    robot = state.robots.get(record.command.robot)
    return robot is not None and any(order.id == record.order_id for order in robot.orders.orders)


def issue_command(state: FleetState, event: events.CommandIssued) -> FleetState:
    """Begin the record of a command."""
    if any(record.id == event.id for record in state.commands):
        return state
    robot = state.robots.get(event.command.robot)
    known = Baseline() if robot is None else before(robot, event.at)
    record = CommandRecord(
        event.id,
        event.command,
        event.at,
        event.wall,
        (Step(Stage.CHECKED, event.at),),
        replace(known, floor=event.floor or known.floor),
    )
    if robot is not None and isinstance(event.command, PlaceOrder):
        state = with_robot(state, replace(robot, accepted=asked_about(state, robot)))
    commands = (*state.commands, record)
    # Open commands, and orders in a queue, stay, however many there are.
    surplus = len(commands) - COMMANDS_KEPT
    if surplus > 0:
        old = set(islice(_droppable(state, commands), surplus))
        commands = tuple(one for one in commands if one.id not in old) if old else commands
    return replace(state, commands=commands)


def _droppable(state: FleetState, commands: Sequence[CommandRecord]) -> Iterator[int]:
    """Return the ids of decided commands, the oldest first. A request to many robots stays whole until the
    last one is decided: its summary counts them all."""
    begun = {one.issued_at for one in commands if not one.is_decided}
    for one in commands:
        is_part = isinstance(one.command, PauseRobot | ResumeRobot) and one.issued_at in begun
        if one.is_decided and not is_part and not _is_in_queue(state, one):
            yield one.id


def change_queue(state: FleetState, event: navigation_events.QueueChange) -> FleetState:
    """Hold the orders that wait here, or move one of them."""
    robot = state.robots.get(event.robot)
    if robot is None:
        return state
    match event:
        case navigation_events.QueueHeld():
            return with_robot(state, replace(robot, held=truncate(event.reason)))
        case navigation_events.OrderMoved():
            for record in moved(state, robot, event.order_id, event.before, event.at):
                state = _with_record(state, record)
            return state
        case _:
            assert_never(event)

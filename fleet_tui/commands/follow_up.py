"""Follow-up of decided commands: orders until they end, and late effects."""

from typing import assert_never

from msgspec.structs import replace

from fleet_tui.commands.confirmation import is_repeated
from fleet_tui.commands.order_search import find_order
from fleet_tui.model.commands import (
    CORRECTABLE,
    NEXT,
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
from fleet_tui.model.order_life import STARTED_OVER, UNSAID, GoneOrder, latest, listed_end
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.orders.ends import BY_THIS_CONSOLE, MAY_HAVE_REMOVED, end_of, removals, removes
from fleet_tui.orders.local_queue import next_id
from fleet_tui.orders.newest import last_command
from fleet_tui.situation.causes import cause_of_end
from fleet_tui.situation.pauses import is_overtaken
from fleet_tui.text.language import Message
from fleet_tui.text.units import age

ANSWER_WITHIN = 1.0
"""Seconds for the robot's own report on the end of a goal, which is separate from its status."""
LATE_ORDER = 600.0
LATE_OTHER = 60.0
"""Seconds after `not confirmed` in which an effect still counts as the command carried out late."""

_UNSEEN = Stage.LOST, Stage.DONE
"""Detail of a goal without a final status that the robot reported as done."""
_TAKEN = frozenset({Stage.CONFIRMED, Stage.UNVERIFIABLE, Stage.LATE})


def follow_up(state: FleetState, record: CommandRecord) -> CommandRecord:
    """Advance a decided command by its robot's reports since."""
    robot = state.robots.get(record.command.robot)
    if robot is None:
        return record
    if record.stage is Stage.NOT_CONFIRMED:
        return _carried_out_late(state, robot, record)
    match record.command:
        case PauseRobot():
            return _lost_pause(state, robot, record)
        case PlaceOrder():
            return (_ended if record.has_open_order else _corrected)(state, robot, record)
        case CancelOrder() | ClearOrders() | ResumeRobot() | SetUpCommand():
            return record
        case _:
            assert_never(record.command)


def _lost_pause(state: FleetState, robot: Robot, record: CommandRecord) -> CommandRecord:
    """Return the record, as lost if a restart ended its pause and no later command replaced it."""
    if robot.pause_lost_at is None or robot.pause_lost_at < record.issued_at or record.stage not in _TAKEN:
        return record
    if last_command(state, robot, PauseRobot, ResumeRobot) is not record:
        return record
    return record.advanced(
        Step(Stage.LOST, state.now, Message("{reason}: no longer paused", reason=STARTED_OVER))
    )


def _ended(state: FleetState, robot: Robot, record: CommandRecord) -> CommandRecord:
    assert record.order_id is not None
    # Not since it was confirmed: a queue may be processed after a tick later than its arrival.
    gone = latest(robot.gone, record.order_id, record.issued_at) or _listed(robot, record, record.at)
    if gone is None:
        return record
    answers = robot.kind.keeps_goals and not record.name
    if answers and record.answer is None and state.now - gone.at < ANSWER_WITHIN:
        return record  # its own answer has the reason
    if _is_held(state, record, gone):
        return _waiting(state, robot, record, Message("stopped, goal kept here"))
    stage, reason, is_open = end_of(state, robot, gone, record)
    if stage is Stage.DONE and record.has_further_leg(robot.kind):
        if removals(state, robot, gone, record):
            # The rest is kept here: having sent the request suffices, whatever the robot did with it.
            return _advanced_to(state, record, Stage.CANCELLED, BY_THIS_CONSOLE)
        record = replace(record, leg=record.leg + 1)
        return _waiting(state, robot, record, Message("stop reached, next goal follows"))
    answer = record.answer
    if answer is not None and (stage in (Stage.DONE, Stage.FAILED) or (stage, answer.stage) == _UNSEEN):
        # Skipped stops are only in its answer.
        stage, reason = answer.stage, answer.detail or reason
    elif answers and stage is Stage.DONE and _is_of_several_stops(record):
        reason = Message("succeeded, result missing: stops may have been missed")
    elif is_open:
        return record  # another console may have removed it
    if stage is Stage.FAILED and robot.kind.keeps_goals:
        # The id of a goal says nothing to a person who looks for the cause.
        return record.advanced(Step(stage, state.now, _cause(robot, gone, reason)))
    return _advanced_to(state, record, stage, reason)


def _cause(robot: Robot, gone: GoneOrder, reason: Message) -> Message:
    """Return the reason of a failure: where none came with it, that of the robot's log."""
    return (cause_of_end(robot, gone) or reason) if reason == UNSAID else reason


def _advanced_to(state: FleetState, record: CommandRecord, stage: Stage, reason: Message) -> CommandRecord:
    return record.advanced(
        Step(stage, state.now, Message("order {order_id}: {reason}", order_id=record.order_id, reason=reason))
    )


def _corrected(state: FleetState, robot: Robot, record: CommandRecord) -> CommandRecord:
    """Return the record of an order whose end was not the robot's word with the one that is reported since,
    or that another console caused."""
    if record.stage not in CORRECTABLE or STARTED_OVER in record.detail:
        return record
    known = [one for one in robot.gone if one.order.id == record.order_id and one.at >= record.issued_at]
    again = robot.traces.get(record.order_id or "") if Stage.CONFIRMED in NEXT[record.stage] else None
    if again is not None and again.order.serial == record.order_serial:
        return _advanced_to(
            state,
            record,
            Stage.CONFIRMED,
            Message("listed again; corrects: {stage}", stage=Message(record.stage.value)),
        )
    listed = _listed(robot, record, state.now)
    gone = listed or (known[-1] if known else None)
    if gone is None or not (robot.kind.reports_ends or gone.order.serial == record.order_serial):
        return record
    stage, reason, _ = end_of(state, robot, gone, record)
    answer = record.answer
    if answer is not None and stage is Stage.DONE:
        stage, reason = answer.stage, answer.detail or reason  # as when it ended
    if stage not in NEXT[record.stage] or (stage is Stage.DONE and record.has_further_leg(robot.kind)):
        return record  # nothing better is known, or that was only one of its stops
    return _advanced_to(
        state,
        record,
        stage,
        Message("{reason}; corrects: {stage}", reason=reason, stage=Message(record.stage.value)),
    )


def _waiting(state: FleetState, robot: Robot, record: CommandRecord, why: Message) -> CommandRecord:
    assert record.order_id is not None
    kept = record.advanced(
        Step(
            Stage.WAITING,
            state.now,
            Message("order {order_id}: {reason}", order_id=record.order_id, reason=why),
        )
    )
    goals = (*record.earlier_goals, record.order_id)
    return replace(kept, order_id=next_id(state, robot), order_serial=None, earlier_goals=goals)


def _is_of_several_stops(record: CommandRecord) -> bool:
    return isinstance(record.command, PlaceOrder) and len(record.command.stops) > 1


def _listed(robot: Robot, record: CommandRecord, at: float) -> GoneOrder | None:
    """Return the end of an order that was over when it was first seen, or seen again, at a monotonic
    second."""
    over = (order for order in robot.orders.orders if order.id == record.order_id and order.is_over)
    return next((listed_end(order, at) for order in over), None)


def _is_held(state: FleetState, record: CommandRecord, gone: GoneOrder) -> bool:
    """Tell whether a goal was cancelled to pause its robot."""
    robot, sent = state.robots[record.command.robot], record.time_of(Stage.SENT) or record.issued_at
    return (
        robot.kind.holds
        and gone.stage is Stage.CANCELLED
        and not removals(state, robot, gone, record) & MAY_HAVE_REMOVED
        and any(
            isinstance(other.command, PauseRobot)
            and other.command.robot == robot.name
            and sent <= other.issued_at <= gone.at
            and other.stage in MAY_HAVE_REMOVED
            for other in state.commands
        )
    )


def _carried_out_late(state: FleetState, robot: Robot, record: CommandRecord) -> CommandRecord:
    match record.command:
        case PlaceOrder():
            waits = state.now - record.at < LATE_ORDER and not is_repeated(state, record)
            order = find_order(state, robot, record) if waits else None
            if order is None:
                return record
            return record.recognised(order, _late(state, record, Message("order {id}", id=order.id)))
        case CancelOrder() | ClearOrders():
            happened = any(
                one.at > record.at
                and one.stage in (Stage.CANCELLED, Stage.LEFT, Stage.LOST)
                and one.reason != STARTED_OVER
                and removes(record, one.order)
                and not removals(state, robot, one, record) & MAY_HAVE_REMOVED
                for one in robot.gone
            )
        case PauseRobot():
            happened = _reports_pause(state, robot, record, True)
        case ResumeRobot():
            happened = _reports_pause(state, robot, record, False)
        case SetUpCommand():
            return record  # what is reported later need not be its effect
        case _:
            assert_never(record.command)
    if not happened or state.now - record.at > LATE_OTHER:
        return record
    return record.advanced(_late(state, record, Message("reported by the robot")))


def _reports_pause(state: FleetState, robot: Robot, record: CommandRecord, wanted: bool) -> bool:
    paused = robot.paused
    reported = paused is not None and paused.at > record.at and paused.value is wanted
    return reported and not is_overtaken(state, record) and not _is_repeated(state, record)


def _is_repeated(state: FleetState, record: CommandRecord) -> bool:
    """Tell whether the same command was sent since and reached the robot, as far as is known: the effect
    belongs to that one."""
    return any(
        other.command == record.command
        and other.issued_at > record.issued_at
        and other.stage not in (Stage.REFUSED, Stage.NOT_SENT)
        for other in state.commands
    )


def _late(state: FleetState, record: CommandRecord, shown: Message) -> Step:
    return Step(
        Stage.LATE,
        state.now,
        Message("{shown}, {age} after the command", shown=shown, age=age(state.now - record.issued_at)),
    )

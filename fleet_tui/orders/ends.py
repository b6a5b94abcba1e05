"""How an order ended: the reports of its robot, with what this and other consoles did to it."""

from typing import NamedTuple, assert_never

from fleet_tui.model.commands import (
    ORDER_ENDS,
    CancelOrder,
    ClearOrders,
    CommandRecord,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.desk.desk import CommandElsewhere
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order
from fleet_tui.model.order_life import STARTED_OVER, GoneOrder
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.text.language import Message

EVIDENCE_WITHIN = 1.0
"""Seconds within which another console's command is known here: the end of its order may be seen before."""
TAKES_EFFECT_WITHIN = 3.0
"""Seconds from another console's cancel or clear to the end of what it removed, at most."""
ANSWERED_WITHIN = 1.5
"""Seconds from the end of a goal in which its command ends, with the robot's own answer or without."""
ARRIVES_WITHIN = 5.0
"""Seconds from a command of a console on another machine to its news here: network folders keep listings."""
REMOVED_WITHIN = 60.0
"""Seconds before the end of another client's order in which a cancel or clear counts as its cause."""
REMOVED = frozenset({Stage.ACCEPTED, Stage.CONFIRMED, Stage.LATE})
"""Stages of a cancel or clear that took an order away, also one whose robot stood at its end."""
MAY_HAVE_REMOVED = REMOVED | {Stage.SENT, Stage.NO_ANSWER, Stage.UNKNOWN, Stage.NOT_CONFIRMED}
BY_THIS_CONSOLE = Message("by this console")


class ExplainedEnd(NamedTuple):
    """One of ORDER_ENDS and its reason; `is_open`: for a moment yet, evidence for another one may come."""

    stage: Stage
    reason: Message
    is_open: bool = False


def end_of(
    state: FleetState, robot: Robot, gone: GoneOrder, record: CommandRecord | None = None
) -> ExplainedEnd:
    """Explain the end of an order; `record` is the command of this console that placed it."""
    if gone.reason == STARTED_OVER or (gone.is_reported and gone.stage not in (Stage.CANCELLED, Stage.LOST)):
        return ExplainedEnd(gone.stage, gone.reason)
    causes = REMOVED if gone.stage is Stage.DONE else MAY_HAVE_REMOVED
    if removals(state, robot, gone, record) & causes:
        return ExplainedEnd(Stage.CANCELLED, BY_THIS_CONSOLE)
    if (removal := _elsewhere(state, robot, gone, record)) is not None and removal.stage in causes:
        return ExplainedEnd(Stage.CANCELLED_ELSEWHERE, removal.text)
    if gone.stage is Stage.CANCELLED and record is not None:
        return ExplainedEnd(Stage.CANCELLED_ELSEWHERE, gone.reason, state.now - gone.at < EVIDENCE_WITHIN)
    is_open = ORDER_ENDS[gone.stage].is_inferred and state.now - gone.at < EVIDENCE_WITHIN
    return ExplainedEnd(gone.stage, gone.reason, is_open)


def seen_end(state: FleetState, robot: Robot, gone: GoneOrder) -> ExplainedEnd:
    """Explain the end of an order of any client: one of this console as its command tells it."""
    record = placed_by(state, robot, gone.order)
    if record is not None and record.stage in ORDER_ENDS:
        return ExplainedEnd(record.stage, record.reason)
    end = end_of(state, robot, gone, record)
    if (elsewhere := given_elsewhere(state, robot, gone.order)) and elsewhere.stage not in ORDER_ENDS:
        # Its console knows whether that was the end, unless it is gone: then a first goal is none.
        is_open = robot.kind.gives_stops and " -> " in elsewhere.way and len(elsewhere.goals) == 1
        return end._replace(is_open=is_open or state.now - gone.at < EVIDENCE_WITHIN)
    # Its command waits for the robot's own answer, which may tell of stops that were missed.
    waits = record is not None and robot.kind.keeps_goals and state.now - gone.at < ANSWERED_WITHIN
    return end._replace(is_open=end.is_open or waits)


def ended_orders(state: FleetState, robot: Robot) -> list[GoneOrder]:
    """Return the orders that ended, the newest last. A goal that led to a stop on the way, or that a pause of
    its console ended, is a part of an order that goes on."""
    parts = {id_ for one in state.commands if one.command.robot == robot.name for id_ in one.earlier_goals}
    parts.update(id_ for one in state.desk.elsewhere if one.robot == robot.name for id_ in one.parts)
    return [gone for gone in robot.gone if gone.order.id not in parts]


def placed_by(state: FleetState, robot: Robot, order: Order) -> CommandRecord | None:
    """Return the command of this console that placed an order, None for another client's."""
    found = (
        record
        for record in reversed(state.commands)
        if record.command.robot == robot.name
        and record.order_id == order.id
        and record.order_serial == order.serial
    )
    return next(found, None)


def given_elsewhere(state: FleetState, robot: Robot, order: Order) -> CommandElsewhere | None:
    """Return the command of another console that gave an order goal by goal, None if it is not known."""
    return next(
        (one for one in state.desk.elsewhere if one.robot == robot.name and order.id in one.goals), None
    )


def removals(
    state: FleetState, robot: Robot, gone: GoneOrder, record: CommandRecord | None = None
) -> set[Stage]:
    """Return the stages of this console's commands that were to remove an order since it was placed. A clear
    cancels the goals of this console, also those not listed yet."""
    since = gone.at - REMOVED_WITHIN if record is None else record.issued_at
    return {
        other.stage
        for other in state.commands
        if other.command.robot == robot.name
        and other is not record
        and since <= other.issued_at <= gone.at
        and (removes(other, gone.order) or _clears_named(other, record))
    }


def removes(record: CommandRecord, order: Order) -> bool:
    """Tell whether a command is to remove an order."""
    match record.command:
        case CancelOrder(_, cancelled):
            return cancelled == order.id
        case ClearOrders():
            last = record.before.last_serial
            return last is None or order.serial <= last
        case PlaceOrder() | PauseRobot() | ResumeRobot() | SetUpCommand():
            return False
        case _:
            assert_never(record.command)


def _clears_named(other: CommandRecord, record: CommandRecord | None) -> bool:
    return record is not None and record.name != "" and isinstance(other.command, ClearOrders)


def _elsewhere(
    state: FleetState, robot: Robot, gone: GoneOrder, record: CommandRecord | None
) -> CommandElsewhere | None:
    """Return what another console did to remove an order since it was placed, the last before its end."""
    lately = gone.at - REMOVED_WITHIN
    since = lately if record is None else record.issued_at
    found = (
        removal
        for removal in reversed(state.desk.elsewhere)
        if removal.robot == robot.name
        and removal.removes
        and removal.order_id in ("", gone.order.id)
        and since <= removal.at <= gone.at + (ARRIVES_WITHIN if removal.is_arrival else EVIDENCE_WITHIN)
        # One that was taken may take its time; of another nobody knows whether it did anything.
        and (removal.stage in REMOVED or removal.at >= lately)
        and _was_listed(gone, removal.at)
    )
    return next(found, None)


def _was_listed(gone: GoneOrder, removed_at: float) -> bool:
    """Tell whether an order was in the queue when another console removed what was there. It may have been
    listed a moment after, while that was on its way, and then was gone at once."""
    if gone.listed_at is None or removed_at >= gone.listed_at:
        return True
    return gone.listed_at - removed_at <= EVIDENCE_WITHIN and gone.at - removed_at <= TAKES_EFFECT_WITHIN

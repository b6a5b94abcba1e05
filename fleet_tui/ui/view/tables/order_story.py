"""The origin of an order in a queue, as far as this console knows."""

from collections.abc import Callable
from itertools import groupby

from fleet_tui.commands.order_search import could_be
from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.order import Order
from fleet_tui.text.language import tr

NEVER_THERE = frozenset({Stage.CHECKED, Stage.WAITING, Stage.NOT_SENT, Stage.REFUSED})


def _outcome(record: CommandRecord) -> str:
    """Return the stages of a command."""
    stages = [tr(step.stage.value) for step in record.steps if step.stage not in (Stage.CHECKED, Stage.SENT)]
    # A waiting order that was moved waits on.
    return ", ".join([stage for stage, _ in groupby(stages)] or [tr("sent")])


def _may_be(record: CommandRecord, order: Order) -> bool:
    """Tell whether a command whose order was never recognised could have placed this one."""
    if record.order_id is not None or record.stage in NEVER_THERE:
        return False
    last = record.before.last_serial
    if last is not None and order.serial <= last:
        return False
    return isinstance(record.command, PlaceOrder) and could_be(record.command, order)


def origin(state: FleetState, robot: str, order: Order, clock: Callable[[float], str]) -> str:
    """Return `given here at 12:04:31, accepted, confirmed`, or that this console did not give it."""
    ours = [record for record in state.commands if record.command.robot == robot]
    for record in ours:
        if record.order_id == order.id and isinstance(record.command, PlaceOrder):
            return tr("sent here at {wall}, {outcome}", wall=clock(record.wall), outcome=_outcome(record))
    for record in ours:
        if _may_be(record, order):
            return tr(
                "possibly sent here at {wall}, {outcome}", wall=clock(record.wall), outcome=_outcome(record)
            )
    return tr("not sent by this console")

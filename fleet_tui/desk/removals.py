"""Cancels and clears of this console for the others, and of the others for the state."""

import time
from collections.abc import Iterator
from typing import TypedDict

from fleet_tui.desk.facts import SharedRemoval
from fleet_tui.model.commands import CancelOrder, ClearOrders, Stage
from fleet_tui.model.desk.desk import Removal
from fleet_tui.model.desk.events import OrdersRemoved
from fleet_tui.model.fleet import FleetState


class RemovalFields(TypedDict):
    """What a fact about a removal has beside the usual."""

    robot: str
    order: str
    request: int
    stage: Stage


def own_removals(before: FleetState, after: FleetState) -> Iterator[RemovalFields]:
    """Return the fields of a fact for each step that a cancel or clear of this console made once it left."""
    if before.commands is after.commands:
        return
    known = {record.id: record for record in before.commands}
    for record in after.commands:
        old = known.get(record.id)
        if old is record or not isinstance(record.command, CancelOrder | ClearOrders):
            continue
        order = record.command.order_id if isinstance(record.command, CancelOrder) else ""
        for step in record.steps[len(old.steps) if old else 0 :]:
            if step.stage is not Stage.CHECKED:
                yield {
                    "robot": record.command.robot,
                    "order": order,
                    "request": record.id,
                    "stage": step.stage,
                }


def removal_event(fact: SharedRemoval, by: str) -> OrdersRemoved:
    """Return the event of a fact that was just told: clocks of machines differ, its arrival counts."""
    host, _, process = fact.console.rpartition("-")[0].rpartition("-")
    key, at = f"{fact.console} {fact.request}", time.monotonic()
    return OrdersRemoved(Removal(key, fact.robot, fact.order, by, f"{host}:{process}", at, fact.stage))

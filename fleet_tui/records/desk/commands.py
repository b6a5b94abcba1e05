"""Commands of this console for the others, and of the others for the state."""

import time
from collections.abc import Iterator
from typing import TypedDict

from fleet_tui.model.commands import NOT_LEFT, CancelOrder, Stage, command_name
from fleet_tui.model.desk.desk import CommandElsewhere
from fleet_tui.model.desk.events import CommandedElsewhere
from fleet_tui.model.fleet import FleetState
from fleet_tui.records.desk.facts import SharedCommand


class CommandFields(TypedDict):
    """What a fact about a command has beside the usual."""

    robot: str
    what: str
    order: str
    request: int
    stage: Stage


def own_steps(before: FleetState, after: FleetState) -> Iterator[CommandFields]:
    """Return the fields of a fact for each step that a command of this console made from its sending until it
    was decided."""
    if before.commands is after.commands:
        return
    known = {record.id: record for record in before.commands}
    for record in after.commands:
        old = known.get(record.id)
        if old is record or (old is not None and old.is_decided):
            continue
        command, robot = record.command, after.robots.get(record.command.robot)
        for step in record.steps[len(old.steps) if old else 0 :]:
            if robot is not None and step.stage not in NOT_LEFT:
                yield {
                    "robot": command.robot,
                    "what": command_name(command, robot.kind),
                    "order": command.order_id if isinstance(command, CancelOrder) else "",
                    "request": record.id,
                    "stage": step.stage,
                }


def elsewhere_event(fact: SharedCommand, by: str) -> CommandedElsewhere:
    """Return the event of a fact that was just told: clocks of machines differ, its arrival counts."""
    host, _, process = fact.console.rpartition("-")[0].rpartition("-")
    key, at = f"{fact.console} {fact.request}", time.monotonic()
    console = f"{host}:{process}"
    return CommandedElsewhere(
        CommandElsewhere(key, fact.robot, fact.order, by, console, at, fact.stage, fact.what, True)
    )

"""Answers of dispatchers to this console's requests."""

from msgspec.structs import replace

from fleet_tui.model.commands import CommandRecord, PlaceOrder, Stage, Step
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.fleets.events import DispatchFact, DispatchFailed
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
        return record.advanced(Step(stage, event.at, truncate(event.reason)))
    record = record.advanced(Step(event.stage, event.at, truncate(event.detail)))
    # From now on the task is known by its own id: not every version passes on the name of its requester.
    return (
        replace(record, name=event.task) if event.task and isinstance(record.command, PlaceOrder) else record
    )

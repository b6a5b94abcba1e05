"""Events of operators, here and at the other consoles of the desk, applied to the fleet state."""

from typing import assert_never

from msgspec.structs import replace

from fleet_tui.model.alarm import acknowledge, shelve, unshelve
from fleet_tui.model.desk import events
from fleet_tui.model.desk.desk import ClosedEdge, Colleague, CommandElsewhere, Desk
from fleet_tui.model.fleet import FleetState

MOST_CLOSED = 1000
"""Closed edges of all floors; of more the oldest are forgotten."""

ELSEWHERE_KEPT = 200
"""Commands of other consoles that are kept to explain the ends of orders."""
OTHERS_FOR = 60.0
"""Seconds for which those are kept that remove no orders."""


def apply_operator(state: FleetState, event: events.OperatorEvent) -> FleetState:
    """Return the state after an operator did something."""
    return _answer(state, event) if isinstance(event, events.AlarmAnswer) else _change(state, event)


def _answer(state: FleetState, event: events.AlarmAnswer) -> FleetState:
    match event:
        case events.AlarmAcknowledged():
            alarms = acknowledge(state.alarms, event.source, event.kind)
        case events.AlarmShelved():
            alarms = shelve(state.alarms, (event.source, event.kind), event.until)
        case events.AlarmUnshelved():
            alarms = unshelve(state.alarms, (event.source, event.kind))
        case _:
            assert_never(event)
    return _acted(replace(state, alarms=alarms), event.by)


def _acted(state: FleetState, by: str) -> FleetState:
    return state if state.desk.acted == by else replace(state, desk=replace(state.desk, acted=by))


def _change(state: FleetState, event: events.DeskChange) -> FleetState:
    desk = state.desk
    match event:
        case events.DeskJoined():
            desk = replace(desk, me=event.name)
        case events.ColleaguesSeen():
            desk = replace(desk, others=tuple(_of_this_fleet(state, one) for one in event.others))
        case events.RobotClaimed():
            desk = replace(desk, claims=(*_without(desk, event.robot), event.robot))
        case events.RobotReleased():
            desk = replace(desk, claims=_without(desk, event.robot))
        case events.EdgeClosed():
            edge = ClosedEdge(event.ends, event.by or desk.me, event.wall)
            closed = (*_but(desk, event.ends), edge)[-MOST_CLOSED:]
            desk = replace(desk, closed=closed, acted=event.by)
        case events.EdgeOpened():
            desk = replace(desk, closed=_but(desk, event.ends), acted=event.by)
        case events.CommandedElsewhere():
            desk = replace(desk, elsewhere=_with_command(state, event.command))
        case _:
            assert_never(event)
    return replace(state, desk=desk)


def _of_this_fleet(state: FleetState, other: Colleague) -> Colleague:
    """Drop the claims of robots that are not there: of another configuration, or of one that was changed."""
    return replace(other, claims=tuple(name for name in other.claims if name in state.robots))


def _with_command(state: FleetState, command: CommandElsewhere) -> tuple[CommandElsewhere, ...]:
    """Keep the time at which a command was sent, whatever became of it, and the goals of an order."""
    known = state.desk.elsewhere
    before = next((one for one in known if one.key == command.key), command)
    goals = tuple(dict.fromkeys((*before.goals, *command.goals)))
    goes_on = command.goes_on if command.goals else before.goes_on
    command = replace(command, at=min(before.at, command.at), goals=goals, goes_on=goes_on)
    kept = [
        one
        for one in known
        if one.key != command.key and (one.removes or one.goals or state.now - one.at < OTHERS_FOR)
    ]
    return (*kept, command)[-ELSEWHERE_KEPT:]


def _without(desk: Desk, robot: str) -> tuple[str, ...]:
    return tuple(name for name in desk.claims if name != robot)


def _but(desk: Desk, ends: tuple[str, str, str]) -> tuple[ClosedEdge, ...]:
    return tuple(edge for edge in desk.closed if edge.ends != ends)

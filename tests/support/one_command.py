"""A robot whose queue is known, and the one command that was given to it."""

from fleet_tui.model.commands import CommandRecord, Stage
from fleet_tui.model.events import Event
from fleet_tui.model.fleet import FleetState
from tests.support.fleets import R0, T0, fleet, link_up, place_order, queue, reduced, tick

ORDER = place_order(R0, 1, 2)


SENT, ACCEPTED, UNKNOWN, NO_ANSWER = Stage.SENT, Stage.ACCEPTED, Stage.UNKNOWN, Stage.NO_ANSWER


PATIENCE = fleet().limits.confirm_after


def up(*facts: Event) -> FleetState:
    """A fleet with a link, and a queue in which order 4 is the last."""
    return reduced(fleet(), link_up(T0 - 100), queue(T0 - 1, (4, 8, 9, "W"), current=4), tick(T0), *facts)


def only(state: FleetState) -> CommandRecord:
    (record,) = state.commands
    return record

"""Moves of orders that wait in this console, among those that were not begun yet."""

from collections.abc import Iterator

from msgspec.structs import replace

from fleet_tui.model.commands import CommandRecord, Stage, Step
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.robot import Robot
from fleet_tui.orders.local_queue import turn_of, waiting
from fleet_tui.text.language import Message

Move = tuple[Message, str]
"""The name of a move, and the id of the order before which it puts one, empty for the end."""


def _movable(state: FleetState, robot: Robot) -> list[CommandRecord]:
    """Return the waiting orders of which nothing was sent: one that a pause stopped is driven on first."""
    return [one for one in waiting(state, robot) if one.time_of(Stage.SENT) is None]


def moves(state: FleetState, robot: Robot, order_id: str) -> Iterator[Move]:
    """Return the possible moves of an order; none for one that does not wait here."""
    ids = [one.order_id or "" for one in _movable(state, robot)]
    if order_id not in ids:
        return
    place = ids.index(order_id)
    if place > 0:
        yield Message("Move up"), ids[place - 1]
    if place > 1:
        yield Message("Move to the front"), ids[0]
    if place < len(ids) - 1:
        yield Message("Move down"), next(iter(ids[place + 2 :]), "")


def moved(state: FleetState, robot: Robot, order_id: str, before: str, at: float) -> Iterator[CommandRecord]:
    """Return the records that change when an order moves before another one, at the end if `before` is empty;
    none if one of both no longer waits. `at` is monotonic."""
    found = {one.order_id or "": one for one in _movable(state, robot)}
    if order_id == before or not {order_id, before or order_id} <= found.keys():
        return
    ids = [id_ for id_ in found if id_ != order_id]
    ids.insert(ids.index(before) if before else len(ids), order_id)
    # The same turns in another sequence: nothing else changes its place.
    for id_, turn in zip(ids, map(turn_of, found.values()), strict=True):
        if id_ == order_id:
            where = (
                Message("moved before order {before}", before=before)
                if before
                else Message("moved to the end")
            )
            yield replace(found[id_].advanced(Step(Stage.WAITING, at, where)), turn=turn)
        elif turn_of(found[id_]) != turn:
            yield replace(found[id_], turn=turn)

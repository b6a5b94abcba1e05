"""Answers of vehicles: their states after a command, by the id that its message had."""

from typing import assert_never

from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
    Stage,
)
from fleet_tui.model.set_up.commands import SetUpCommand, StartCharging
from fleet_tui.model.vehicles.vehicle import Vehicle, VehicleError
from fleet_tui.robots.vda5050.state import is_running
from fleet_tui.robots.vda5050.topics import INSTANT_ACTIONS, ORDER
from fleet_tui.text.language import EMPTY, Message, verbatim

NO_ORDER = "noOrderToCancel"
"""Type of an error that some vehicles report without a reference, and without a failed action."""
FINISHED = "FINISHED"
FAILED = "FAILED"


def answer(command: Command, id_: str, number: int, vehicle: Vehicle) -> tuple[Stage, Message] | None:
    """Return the stage that a command reached by a state after it, with the vehicle's text: SENT while it is
    being carried out, None if the state says nothing of it. `id_` is that of its order or action, `number`
    the header id of its message."""
    if isinstance(command, PlaceOrder) and vehicle.order_id == id_:
        return Stage.ACCEPTED, EMPTY  # errors that name it are of its way
    status = next((one for one in vehicle.actions if one.id == id_), None)
    if rejection := _rejection(command, id_, number, vehicle):
        return Stage.REFUSED, verbatim(rejection)
    is_done = status is not None and status.status == FINISHED
    match command:
        case CancelOrder() | ClearOrders():
            if is_done and not is_running(vehicle, is_cancelled=True):
                return Stage.ACCEPTED, EMPTY
        case PauseRobot() | ResumeRobot() | StartCharging():
            reported = vehicle.charging if isinstance(command, StartCharging) else vehicle.paused
            wanted = not isinstance(command, ResumeRobot)
            if reported is wanted or (is_done and reported is not None):
                return Stage.ACCEPTED, EMPTY
            if is_done:  # it has no word for its effect but this
                return Stage.CONFIRMED, Message("action finished")
        case PlaceOrder() | SetUpCommand():
            return None
        case _:
            assert_never(command)
    return (Stage.SENT, EMPTY) if status is not None else None


def failure_of(id_: str, vehicle: Vehicle) -> str:
    """Return the vehicle's text with which it rejects or fails an action, empty if it does not."""
    named = (error_text(error) for error in vehicle.errors if error.concerns(id_))
    failed = (
        one.text or Message("action failed")
        for one in vehicle.actions
        if one.id == id_ and one.status == FAILED
    )
    return next(named, "") or next(failed, "")


def _rejection(command: Command, id_: str, number: int, vehicle: Vehicle) -> str:
    """Return the vehicle's text with which it rejects a command, empty if it does not."""
    for error in vehicle.errors:
        if _concerns(error, command, id_, number, vehicle):
            return error_text(error)
    return failure_of(id_, vehicle)


def _concerns(error: VehicleError, command: Command, id_: str, number: int, vehicle: Vehicle) -> bool:
    """Tell whether an error rejects this command: it may have been there before, so only references count."""
    if error.concerns(id_):
        return True
    keys, is_order = dict(error.references), isinstance(command, PlaceOrder)
    if keys.get("headerId") == str(number):  # orders and instant actions are counted apart
        if is_order:
            return "orderId" not in keys and keys.get("topic", ORDER) == ORDER
        return keys.get("topic") == INSTANT_ACTIONS
    is_cancel = isinstance(command, CancelOrder | ClearOrders)
    # It is an old one while an order runs, as there is something to cancel, and once this one is carried out.
    is_done = any(one.id == id_ and one.status == FINISHED for one in vehicle.actions)
    return is_cancel and error.type == NO_ORDER and not (keys or is_done or is_running(vehicle))


def error_text(error: VehicleError) -> str:
    """Return an error with its description and its hint."""
    return ": ".join(part for part in (error.type, error.text or error.hint) if part)

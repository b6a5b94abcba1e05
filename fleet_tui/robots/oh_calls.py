"""Commands as the calls of these robots: their ids are 32-bit numbers, and 0 stands for all orders."""

import re
from functools import partial
from typing import assert_never

from fleet_tui.config.profile import Profile
from fleet_tui.errors import CommandError
from fleet_tui.model.commands import (
    CancelOrder,
    ClearOrders,
    Command,
    PauseRobot,
    PlaceOrder,
    ResumeRobot,
)
from fleet_tui.model.order import Stop
from fleet_tui.robots.interface import Call

INT32_MAX = 2**31 - 1


def call(profile: Profile, command: Command, request_id: int) -> Call:
    """The service call of a command. Raises CommandError for one that must not leave."""
    service = partial(profile.service, robot=command.robot)
    args: dict[str, object]
    match command:
        case PlaceOrder(robot, (end,)):
            args = {"request_id": request_id, "agent": robot, "end_point": _vertex(end)}
            return Call(service("order_with_cargo"), _named(args, profile.names("cargo_call")))
        case PlaceOrder(_, (start, end)):
            args = {"request_id": request_id, "initial_point": _vertex(start), "end_point": _vertex(end)}
            return Call(service("order"), _named(args, profile.names("order_call")))
        case PlaceOrder(_, stops):
            raise CommandError(f"an order of these robots has one stop or two, not {len(stops)}")
        case CancelOrder(robot, order_id):
            number = _int32(order_id, "order id")
            if number <= 0:
                raise CommandError(f"order id {number} means all orders to the robot: use clear for that")
            args = {"robot": robot, "ind": number}
            return Call(service("cancel"), _named(args, profile.names("cancel_call")))
        case ClearOrders(robot):
            return Call(service("clear"), _named({"robot": robot, "ind": 0}, profile.names("cancel_call")))
        case PauseRobot():
            return Call(service("pause"), {})
        case ResumeRobot():
            return Call(service("resume"), {})
        case _:
            assert_never(command)


def _vertex(stop: Stop) -> int:
    if stop.pose is not None:
        raise CommandError("these robots drive to vertices, not to poses")
    return _int32(stop.vertex, "vertex")


def _int32(id_: str, what: str) -> int:
    """The number that an id is on the wire. Raises CommandError where it is none."""
    if not re.fullmatch(r"-?[0-9]{1,100}", id_, re.ASCII):
        raise CommandError(f"{what} {id_!r} is no number: these robots have no other ids")
    return int(id_)


def _named(args: dict[str, object], names: dict[str, str]) -> dict[str, object]:
    for name, value in args.items():
        if isinstance(value, int) and not -INT32_MAX - 1 <= value <= INT32_MAX:
            raise CommandError(f"{name} {value} does not fit the robot's 32 bits")
    return {names.get(name, name): value for name, value in args.items()}

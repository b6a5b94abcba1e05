"""Commands as the calls of these robots: their ids are 32-bit numbers, and 0 means all orders."""

import re
from collections.abc import Mapping
from typing import assert_never

from fleet_tui.model import commands
from fleet_tui.model.order import Stop
from fleet_tui.robots.adapter import ServiceCall
from fleet_tui.robots.ros.fields import put
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.errors import CommandError
from fleet_tui.text.language import Message

INT32_MAX = 2**31 - 1
Called = (
    commands.PlaceOrder
    | commands.CancelOrder
    | commands.ClearOrders
    | commands.PauseRobot
    | commands.ResumeRobot
)
"""Commands to the queue of orders."""


def call_of(names: Names, command: Called, request_id: int) -> ServiceCall:
    """Return the service call of a command. Raises CommandError for one that must not be sent."""
    args: dict[str, object]

    def call(key: str, given: Mapping[str, object]) -> ServiceCall:
        return ServiceCall(names.service(key, command.robot), names.service_type(key), given)

    match command:
        case commands.PlaceOrder(robot, (end,)):
            args = {"request_id": request_id, "agent": robot, "end_point": _vertex(end)}
            return call("order_with_cargo", named(names, "cargo_call", args))
        case commands.PlaceOrder(_, (start, end)):
            args = {"request_id": request_id, "initial_point": _vertex(start), "end_point": _vertex(end)}
            return call("order", named(names, "order_call", args))
        case commands.PlaceOrder(_, stops):
            raise CommandError(
                Message("orders to these robots have one or two stops, not {stops}", stops=len(stops))
            )
        case commands.CancelOrder(robot, order_id):
            number = int32(order_id, "order id")
            if number <= 0:
                raise CommandError(
                    Message(
                        "order id {number} means all orders to the robot: use clear instead", number=number
                    )
                )
            args = {"robot": robot, "ind": number}
            return call("cancel", named(names, "cancel_call", args))
        case commands.ClearOrders(robot):
            return call("clear", named(names, "cancel_call", {"robot": robot, "ind": 0}))
        case commands.PauseRobot():
            return call("pause", {})
        case commands.ResumeRobot():
            return call("resume", {})
        case _:
            assert_never(command)


def _vertex(stop: Stop) -> int:
    if stop.pose is not None:
        raise CommandError(Message("these robots drive to vertices, not to poses"))
    return int32(stop.vertex, "vertex")


def int32(id_: str, what: str) -> int:
    """Return the number that an id is on the wire. Raises CommandError if it is not a number."""
    if not re.fullmatch(r"-?[0-9]{1,100}", id_, re.ASCII):
        raise CommandError(
            Message("{what} {name} is not a number: these robots use numeric ids", what=what, name=f"{id_!r}")
        )
    return int(id_)


def named(names: Names, message: str, args: Mapping[str, object]) -> dict[str, object]:
    """Return the fields of a message under a site's names. Raises CommandError for a number of more than 32
    bits."""
    found = dict[str, object]()
    for name, value in args.items():
        if isinstance(value, int) and not -INT32_MAX - 1 <= value <= INT32_MAX:
            raise CommandError(
                Message("{name} {number} exceeds the robot's 32 bits", name=name, number=value)
            )
        put(found, names.path(message, name), value)
    return found

"""The services' request types, and how the bridge fills a request from JSON: in its very words."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

PYTHON_TYPES = {"int32": int, "string": str}
ZEROS: Mapping[str, Any] = {"int32": 0, "string": ""}
INT32 = range(-(2**31), 2**31)


@dataclass(frozen=True)
class ServiceType:
    """A service type with the fields of its request: name -> `int32` or `string`."""

    name: str
    fields: Mapping[str, str]


_ORDER = {"request_id": "int32", "initial_point": "int32", "end_point": "int32"}
_WITH_CARGO = {"request_id": "int32", "agent": "string", "end_point": "int32"}
_CHOICE = {"robot": "string", "ind": "int32"}

ROBOT_SERVICES = {
    "Execute_order": ServiceType("OH_ressources/Execute_manual_order", _ORDER),
    "Execute_order_with_cargo": ServiceType("OH_ressources/Execute_manual_order_with_cargo", _WITH_CARGO),
    "Cancel_order": ServiceType("OH_ressources/Cancel_order", _CHOICE),
    "Clear_orders": ServiceType("OH_ressources/Clear_orders", _CHOICE),
    "Pause": ServiceType("std_srvs/Trigger", {}),
    "Resume": ServiceType("std_srvs/Trigger", {}),
}


class ServiceError(Exception):
    """A call that fails: its text is the answer's `values`, with `result` false."""


class NodeDiedError(ServiceError):
    """The node dies during the call."""

    def __init__(self) -> None:
        super().__init__(
            "transport error completing service call: unable to receive data from sender,"
            " check sender's logs for details"
        )


def fill(type_: ServiceType, args: object) -> dict[str, Any]:
    """A complete request from a call's `args`: an object, a list in the order of the fields, or anything
    else, which counts as nothing. What is missing becomes zero. Raises ServiceError."""
    given = dict(zip(type_.fields, args, strict=False)) if isinstance(args, list) else args
    request = {name: ZEROS[rostype] for name, rostype in type_.fields.items()}
    for name, value in given.items() if isinstance(given, dict) else ():
        _check(type_, name, value)
        request[name] = value
    return request


def _check(type_: ServiceType, name: str, value: object) -> None:
    rostype = type_.fields.get(name)
    if rostype is None:
        raise ServiceError(f"Message type {type_.name}Request does not have a field {name}")
    # Not isinstance: the bridge refuses true and false for an int32.
    if type(value) is not PYTHON_TYPES[rostype]:
        raise ServiceError(
            f"{type_.name}Request message requires a {rostype} for field {name}, but got a {type(value)}"
        )
    if rostype == "int32" and value not in INT32:
        raise ServiceError(f"field {name} exceeds specified width [int32]")

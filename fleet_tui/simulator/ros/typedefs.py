"""rosapi's description of types, field by field."""

from collections.abc import Mapping

from fleet_tui.simulator.ros.definitions import ACTIONS, SERVICES, Fields, RosField
from fleet_tui.simulator.ros.dialect import Dialect, Message
from fleet_tui.simulator.ros.filling import ZEROS

_CONSTANTS: Mapping[str, Mapping[str, int]] = {
    "actionlib_msgs/GoalStatus": {
        "ABORTED": 4,
        "ACTIVE": 1,
        "LOST": 9,
        "PENDING": 0,
        "PREEMPTED": 2,
        "PREEMPTING": 6,
        "RECALLED": 8,
        "RECALLING": 7,
        "REJECTED": 5,
        "SUCCEEDED": 3,
    },
    "rosgraph_msgs/Log": {"DEBUG": 1, "ERROR": 8, "FATAL": 16, "INFO": 2, "WARN": 4},
    "diagnostic_msgs/DiagnosticStatus": {"ERROR": 2, "OK": 0, "STALE": 3, "WARN": 1},
}
PARTS = "Goal", "Result", "Feedback"
_TIME = {"secs": RosField("int32"), "nsecs": RosField("int32")}


def message_typedefs(dialect: Dialect, type_: str) -> list[Message]:
    """A message type and every type in it; none if the bridge does not know it."""
    return _recursive(dialect, dialect.short(type_), set())


def service_typedefs(dialect: Dialect, type_: str, response: bool) -> list[Message]:
    """The request or the response of a service type and every type in it."""
    for name, both in SERVICES.items():
        full_name = dialect.service_type(name)
        if type_ in (full_name, dialect.short(full_name)):
            part = dialect.part(full_name, "Response" if response else "Request")
            return _with_parts(dialect, part, both[response], set())
    return []


def action_typedefs(dialect: Dialect, type_: str, part: str) -> list[Message]:
    """The `Goal`, `Result` or `Feedback` of an action type and every type in it."""
    name = dialect.short(type_)
    if name not in ACTIONS:
        return []
    return _with_parts(dialect, f"{name}_{part}", ACTIONS[name][PARTS.index(part)], set())


def _recursive(dialect: Dialect, type_: str, seen: set[str]) -> list[Message]:
    fields = _TIME if type_ == "time" else dialect.fields(type_)
    if type_ in seen or fields is None:
        return []
    seen.add(type_)
    return _with_parts(dialect, type_, fields, seen)


def _with_parts(dialect: Dialect, name: str, fields: Fields, seen: set[str]) -> list[Message]:
    found = [_typedef(dialect, name, fields)]
    for field in fields.values():
        found += _recursive(dialect, field.type, seen)
    return found


def _typedef(dialect: Dialect, name: str, fields: Fields) -> Message:
    constants = _CONSTANTS.get(name, {})
    return {
        "type": name,
        "fieldnames": list(fields),
        "fieldtypes": [dialect.primitive(field.type) for field in fields.values()],
        "fieldarraylen": [-1 if field.length is None else field.length for field in fields.values()],
        "examples": [_example(dialect, name, key, field) for key, field in fields.items()],
        "constnames": list(constants),
        "constvalues": [str(value) for value in constants.values()],
    }


def _example(dialect: Dialect, name: str, key: str, field: RosField) -> str:
    if field.length is not None:
        return "[]"
    return str(dialect.defaults.get((name, key), ZEROS.get(field.type, {})))

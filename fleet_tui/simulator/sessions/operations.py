"""Operations of clients, and the fields that each must have to be accepted."""

from collections.abc import Mapping
from typing import Any

Operation = dict[str, Any]

OF_ROS_2 = ("send_action_goal", "cancel_action_goal")

# Field -> type and whether it is required; an operation with another type is ignored.
_FIELDS: Mapping[str, Mapping[str, tuple[type, bool]]] = {
    "subscribe": {
        "topic": (str, True),
        "id": (str, False),
        "type": (str, False),
        "throttle_rate": (int, False),
        "queue_length": (int, False),
        "fragment_size": (int, False),
        "compression": (str, False),
    },
    "unsubscribe": {"topic": (str, True), "id": (str, False)},
    "call_service": {"service": (str, True)},
    "advertise": {"topic": (str, True), "type": (str, True)},
    "unadvertise": {"topic": (str, True)},
    "publish": {"topic": (str, True), "type": (str, False), "msg": (dict, True)},
    "advertise_service": {"service": (str, True), "type": (str, True)},
    "unadvertise_service": {"service": (str, True)},
    "service_response": {"service": (str, True)},
    "send_action_goal": {"action": (str, True), "action_type": (str, True)},
    "cancel_action_goal": {"action": (str, True)},
    "fragment": {"data": (str, True), "num": (int, True), "total": (int, True)},
}


def problem_of(operation: Operation, ros: int) -> str:
    """Return the reason that an operation is invalid on this version of ROS, empty if it is valid."""
    op = operation.get("op")
    fields = _FIELDS.get(str(op))
    if op is None:
        return "Received a message without an op"
    if fields is None or (ros == 1 and op in OF_ROS_2):
        return f"Unknown operation: {op}"
    for name, (type_, needed) in fields.items():
        if operation.get(name) is None:
            if needed:
                return f"Expected a {name} field but none was found"
        elif not isinstance(operation[name], type_):
            return f"Expected field {name} to be one of {type_.__name__}. Invalid value: {operation[name]}"
    return ""

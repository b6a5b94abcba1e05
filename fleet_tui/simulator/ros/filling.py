"""Completes requests and messages from JSON as the bridge does, in its very words."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from fleet_tui.simulator.ros.definitions import Fields, RosField
from fleet_tui.simulator.ros.dialect import Dialect, Message
from fleet_tui.simulator.ros.errors import ServiceError

INTEGERS = {f"{sign}int{bits}": (bits, sign == "") for sign in ("", "u") for bits in (8, 16, 32, 64)}
INTEGERS |= {"byte": (8, True)}
ZEROS: Mapping[str, Any] = {"string": "", "bool": False, "float32": 0.0, "float64": 0.0} | dict.fromkeys(
    INTEGERS, 0
)
TIMES = ("secs", "nsecs"), ("sec", "nanosec")


def fill(dialect: Dialect, name: str, fields: Fields, given: object, now: float) -> Message:
    """A complete message: `given` is an object, a list in the order of the fields, or anything else, which
    counts as nothing. What is missing becomes zero, a header's stamp becomes now (seconds since 1970).
    Raises ServiceError."""
    if isinstance(given, list):
        given = dict(zip(fields, given, strict=False))
    given = given if isinstance(given, dict) else {}
    for key in given:
        if key not in fields:
            raise ServiceError(f"Message type {name} does not have a field {key}")
    filled = {
        key: _value(dialect, name, key, field, given[key], now)
        if key in given
        else _zero(dialect, name, key, field, now)
        for key, field in fields.items()
    }
    if dialect.short(name) == "std_msgs/Header" and "stamp" not in given:
        filled["stamp"] = dialect.time(now)
    return filled


def _zero(dialect: Dialect, message: str, key: str, field: RosField, now: float) -> object:
    if field.length is not None:
        return _fixed(dialect, [0.0], field.length) if field.length else []
    if field.type in ZEROS:
        return dialect.defaults.get((message, key), ZEROS[field.type])
    if _is_time(field):
        return dialect.time(0.0)
    return fill(dialect, field.type, dialect.fields(field.type) or {}, {}, now)


def _value(dialect: Dialect, message: str, key: str, field: RosField, value: object, now: float) -> object:
    if field.length is not None:
        if not isinstance(value, list):
            raise ServiceError(dialect.wrong(message, key, f"{field.type}[]", value))
        one = RosField(field.type)
        items = [_value(dialect, message, key, one, item, now) for item in value]
        return _fixed(dialect, items, field.length) if field.length else items
    if field.type in ZEROS:
        return _primitive(dialect, message, key, field.type, value)
    if not isinstance(value, dict):
        raise ServiceError(dialect.wrong(message, key, field.type, value))
    if _is_time(field):
        seconds, nanoseconds = (
            next((value[names[i]] for names in TIMES if names[i] in value), 0) for i in (0, 1)
        )
        return dict(zip(dialect.time(0.0), (seconds, nanoseconds), strict=True))
    return fill(dialect, field.type, dialect.fields(field.type) or {}, value, now)


def _fixed(dialect: Dialect, items: list[object], length: int) -> object:
    return dialect.fixed(np.resize(np.array(items, dtype=float), length).tolist())


def _primitive(dialect: Dialect, message: str, key: str, rostype: str, value: object) -> object:
    # Not isinstance: the bridge refuses true and false for a number.
    wanted = (int, float) if rostype.startswith("float") else (type(ZEROS[rostype]),)
    if type(value) not in wanted:
        raise ServiceError(dialect.wrong(message, key, rostype, value))
    if isinstance(value, int) and rostype in INTEGERS:
        return dialect.integer(key, value, *INTEGERS[rostype])
    return float(value) if isinstance(value, int) and rostype.startswith("float") else value


def _is_time(field: RosField) -> bool:
    return field.type in ("time", "builtin_interfaces/Time")

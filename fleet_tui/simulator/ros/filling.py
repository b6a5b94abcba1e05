"""Completes requests and messages from JSON as the bridge does, with its exact error texts."""

import base64
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from fleet_tui.simulator.ros.definitions import SERVICES, Fields, RosField
from fleet_tui.simulator.ros.dialect import Dialect, Message
from fleet_tui.simulator.ros.errors import ServiceError

INTEGERS = {f"{sign}int{bits}": (bits, sign == "") for sign in ("", "u") for bits in (8, 16, 32, 64)}
INTEGERS |= {"byte": (8, True)}
ZEROS: Mapping[str, Any] = {"string": "", "bool": False, "float32": 0.0, "float64": 0.0} | dict.fromkeys(
    INTEGERS, 0
)
TIMES = ("secs", "nsecs"), ("sec", "nanosec")


@dataclass(frozen=True)
class ServiceType:
    """A service type with the fields of its request."""

    name: str
    fields: Fields


def service_type(dialect: Dialect, name: str) -> ServiceType:
    """A service type by its ROS 1 name."""
    return ServiceType(dialect.service_type(name), SERVICES[name][0])


def fill_request(dialect: Dialect, type_: ServiceType, given: object, now: float) -> Message:
    """The complete request of a service. Raises ServiceError."""
    return fill(dialect, dialect.part(type_.name, "Request"), type_.fields, given, now)


def fill(dialect: Dialect, name: str, fields: Fields, given: object, now: float) -> Message:
    """A complete message: `given` is an object, a list in the order of the fields, or anything else, which
    counts as nothing. What is missing becomes zero, a header's stamp becomes now (seconds since 1970).
    Raises ServiceError."""
    return _Filling(dialect, name, now).message(name, fields, given, "")


class _Filling:
    """One message being completed; error texts name it and the path of the field."""

    def __init__(self, dialect: Dialect, root: str, now: float) -> None:
        self._dialect = dialect
        self._root = root
        self._now = now

    def message(self, name: str, fields: Fields, given: object, at: str) -> Message:
        if isinstance(given, list):
            given = dict(zip(fields, given, strict=False))
        given = given if isinstance(given, dict) else {}
        for key in given:
            if key not in fields:
                raise ServiceError(f"Message type {self._root} does not have a field {at}{key}")
        filled = {
            key: self._value(field, given[key], f"{at}{key}")
            if key in given
            else self._zero(name, key, field)
            for key, field in fields.items()
        }
        if self._dialect.short(name) == "std_msgs/Header" and "stamp" not in given:
            filled["stamp"] = self._dialect.time(self._now)
        return filled

    def _zero(self, message: str, key: str, field: RosField) -> object:
        if field.length is not None:
            return self._fixed(field, [0]) if field.length else []
        if field.type in ZEROS:
            return self._dialect.defaults.get((message, key), ZEROS[field.type])
        if _is_time(field):
            return self._dialect.time(0.0)
        return self.message(field.type, self._dialect.fields(field.type) or {}, {}, "")

    def _value(self, field: RosField, value: object, at: str) -> object:
        if field.length is not None:
            return self._array(field, value, at)
        if field.type in ZEROS:
            return self._primitive(at, field.type, value)
        if not isinstance(value, dict):
            raise self._wrong(at, field.type, value)
        if _is_time(field):
            parts = [next((value[names[i]] for names in TIMES if names[i] in value), 0) for i in (0, 1)]
            for part in parts:
                if type(part) is not int:
                    raise self._wrong(at, "int32", part)
            return dict(zip(self._dialect.time(0.0), parts, strict=True))
        return self.message(field.type, self._dialect.fields(field.type) or {}, value, f"{at}.")

    def _array(self, field: RosField, value: object, at: str) -> object:
        if isinstance(value, str) and field.type == "uint8":
            try:
                value = list(base64.standard_b64decode(value))
            except ValueError as error:
                raise ServiceError(str(error)) from None
        if not isinstance(value, list):
            raise self._wrong(at, f"{field.type}[]", value)
        items = [self._value(RosField(field.type), item, at) for item in value]
        return self._fixed(field, items) if field.length else items

    def _fixed(self, field: RosField, items: list[Any]) -> object:
        array = np.zeros(field.length or 0, dtype=np.uint8 if field.type == "uint8" else float)
        try:
            array[:] = items  # a single number fills the array
        except ValueError as error:
            raise ServiceError(str(error)) from None
        return array if field.type == "uint8" else self._dialect.fixed(array.tolist())

    def _primitive(self, at: str, rostype: str, value: object) -> object:
        # Not isinstance: the bridge refuses true and false for a number.
        wanted = (int, float) if rostype.startswith("float") else (type(ZEROS[rostype]),)
        if type(value) not in wanted:
            raise self._wrong(at, rostype, value)
        if isinstance(value, int) and rostype in INTEGERS:
            return self._dialect.integer(at, value, *INTEGERS[rostype])
        return float(value) if isinstance(value, int) and rostype.startswith("float") else value

    def _wrong(self, at: str, rostype: str, value: object) -> ServiceError:
        return ServiceError(self._dialect.wrong(self._root, at, rostype, value))


def _is_time(field: RosField) -> bool:
    return field.type in ("time", "builtin_interfaces/Time")

"""ROS 2 behind rosbridge_server 2.7 (Jazzy)."""

import math
from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from fleet_tui.simulator.ros.definitions import ACTIONS, MESSAGES, PACKAGES, SERVICES, Fields, RosField
from fleet_tui.simulator.ros.dialect import COMMON_VERBS, Dialect, Message

ACTION_VERBS = ("action_type", "action_goal_details", "action_result_details", "action_feedback_details")
_RENAMED = {"rosgraph_msgs/Log": "rcl_interfaces/Log", "rosapi": "rosapi_msgs"}
_PRIMITIVES = {"bool": "boolean", "float32": "float", "float64": "double", "byte": "octet"}
_TIME = RosField("builtin_interfaces/Time")


def _named(name: str, kind: str) -> str:
    """A name as ROS 2 allows it: packages in lower case, types in CamelCase."""
    package, _, type_ = _RENAMED.get(name, name).partition("/")
    camel = "".join(part[:1].upper() + part[1:] for part in type_.split("_"))
    return f"{_RENAMED.get(package, package).lower()}/{kind}/{camel}"


def _short(type_: str) -> str:
    return type_.replace("/msg/", "/").replace("/srv/", "/").replace("/action/", "/")


def _translated(field: RosField) -> RosField:
    if field.type == "time":
        return _TIME
    type_ = _short_name(field.type) if "/" in field.type else field.type
    return RosField(type_, field.length)


def _short_name(name: str) -> str:
    return name if name.partition("_Feedback")[0] in ACTIONS else _short(_named(name, "msg"))


def _messages() -> Mapping[str, Fields]:
    found: dict[str, Fields] = {
        _short_name(name): {key: _translated(field) for key, field in fields.items()}
        for name, fields in MESSAGES.items()
        if not name.startswith("rosgraph_msgs/")
    }
    header = {key: field for key, field in found["std_msgs/Header"].items() if key != "seq"}
    time = {"sec": RosField("int32"), "nanosec": RosField("uint32")}
    return found | {"std_msgs/Header": header, _TIME.type: time}


_MESSAGES_BY_SHORT_NAME = _messages()


class Ros2(Dialect):
    """`package/msg/Name`, sec and nanosec in times, no seq."""

    version = 2
    distro = "jazzy"
    rosapi_verbs = (*COMMON_VERBS, *ACTION_VERBS, "get_ros_version", "interfaces")
    call_timeout = 5.0
    max_message_size = 10_000_000
    reads_binary = True
    never_cbor = ("diagnostic_msgs/DiagnosticArray",)
    lingers = 0.4
    fragment_id = "0"
    aligned = True
    keeps_log = True
    joins_wrong_types = True
    fragile = True
    params = MappingProxyType(
        {"/rosbridge_websocket:port": 9090, "/rosbridge_websocket:default_call_service_timeout": 5.0}
    )
    discovers = True
    defaults = MappingProxyType({("geometry_msgs/Quaternion", "w"): 1.0})
    log_levels: Mapping[int, int] = MappingProxyType({1: 10, 2: 20, 4: 30, 8: 40, 16: 50})

    def message_type(self, name: str) -> str:
        """`package/msg/Name`, or `package/action/Name_FeedbackMessage`."""
        action, _, part = name.partition("_Feedback")
        if action in ACTIONS:
            return f"{_named(action, 'action')}_Feedback{part}"
        return _named(name, "msg")

    def action_type(self, name: str) -> str:
        return _named(name, "action")

    def service_type(self, name: str) -> str:
        return _named(name, "srv")

    def short(self, type_: str) -> str:
        return _short(type_)

    def part(self, type_: str, part: str) -> str:
        return f"{_short(type_)}_{part}"

    def rosapi_type(self, name: str) -> str:
        """Its own definition where it differs from ROS 1's."""
        return f"rosapi_msgs/{name}" if f"rosapi_msgs/{name}" in SERVICES else f"rosapi/{name}"

    def importable(self, type_: str) -> bool:
        """Tell whether the package's name is possible, and a known package defines it."""
        package = type_.partition("/")[0]
        known = type_ in _MESSAGES_BY_SHORT_NAME or package not in {name.lower() for name in PACKAGES}
        return known and package == package.lower()

    def fixed(self, items: list[float]) -> object:
        """A numpy array: its NaN and Infinity are bare words in JSON."""
        return np.array(items, dtype=float)

    def got_param(self, value: str | None, request: Message) -> Message:
        node = request["name"].partition(":")[0]
        reason = f"Service {node}/get_parameters is not available" if value is None else ""
        value = value or request["default_value"] or '""'
        return {"value": value, "successful": not reason, "reason": reason}

    def fields(self, type_: str) -> Fields | None:
        return _MESSAGES_BY_SHORT_NAME.get(_short(type_))

    def primitive(self, rostype: str) -> str:
        return _PRIMITIVES.get(rostype, rostype)

    def time(self, seconds: float) -> Message:
        whole = math.floor(seconds)
        return {"sec": whole, "nanosec": int((seconds - whole) * 1e9)}

    def header(self, seq: int, seconds: float, frame_id: str) -> Message:
        return {"stamp": self.time(seconds), "frame_id": frame_id}

    def integer(self, name: str, value: int, bits: int, signed: bool) -> int:
        """Return the value; wrap around one that does not fit."""
        lowest = -(1 << bits - 1) if signed else 0
        return (value - lowest) % (1 << bits) + lowest

    def wrong(self, message: str, name: str, rostype: str, value: object) -> str:
        if value is None:
            return "msg is not a primitive type, but a <class 'NoneType'>"
        return super().wrong(message, name, rostype, value)

    def unknown_package(self, package: str, kind: str) -> str:
        missing = f"No module named '{package}'"
        return f"Unable to import {package}.{kind} from package {package}. Caused by: {missing}"

    def thrown(self, service: str, error: str) -> str | None:
        """The whole node dies."""
        return None

    def died(self) -> str | None:
        """The bridge reports nothing: the call times out."""
        return None

    def log(self, seq: int, seconds: float, level: int, node: str, text: str) -> Message:
        return {
            "stamp": self.time(seconds),
            "level": self.log_levels[level],
            "name": node.strip("/").replace("/", "."),
            "msg": text,
            "file": f"{node.rpartition('/')[2]}.py",
            "function": "log",
            "line": 42,
        }


ROS2 = Ros2()

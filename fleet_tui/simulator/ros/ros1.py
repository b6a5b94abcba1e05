"""ROS 1 behind rosbridge_server 0.11."""

import math
from collections.abc import Collection, Mapping
from types import MappingProxyType

from fleet_tui.simulator.ros.definitions import MESSAGES, PACKAGES, Fields
from fleet_tui.simulator.ros.dialect import Dialect, Message
from fleet_tui.simulator.ros.errors import ServiceError

COMMON_VERBS = (
    "topics",
    "topics_and_raw_types",
    "topics_for_type",
    "topic_type",
    "publishers",
    "subscribers",
    "services",
    "services_for_type",
    "service_type",
    "service_providers",
    "service_node",
    "nodes",
    "node_details",
    "action_servers",
    "get_time",
    "message_details",
    "service_request_details",
    "service_response_details",
    "set_param",
    "get_param",
    "has_param",
    "delete_param",
    "get_param_names",
)


class Ros1:
    """The dialect of ROS 1: `package/Name`, seq in headers, secs and nsecs in times."""

    version, distro = 1, "noetic"
    rosapi_verbs: Collection[str] = (*COMMON_VERBS, "service_host", "search_param")
    call_timeout: float | None = None
    max_message_size: int | None = None
    reads_binary = False
    never_cbor: Collection[str] = ()
    lingers = 0.0
    fragment_id: int | str = 0
    aligned = False
    keeps_log = False
    joins_wrong_types = False
    fragile = False
    params: Mapping[str, object] = MappingProxyType({"/rosdistro": "noetic\n", "/run_id": "simulated"})
    discovers = False
    defaults: Mapping[tuple[str, str], float] = MappingProxyType({})

    def message_type(self, name: str) -> str:
        """`package/Name`."""
        return name

    service_type = action_type = short = primitive = message_type

    def part(self, type_: str, part: str) -> str:
        """`package/NameRequest`."""
        return f"{type_}{part}"

    def rosapi_type(self, name: str) -> str:
        return f"rosapi/{name}"

    def importable(self, type_: str) -> bool:
        """Tell whether a known package defines it."""
        return type_ in MESSAGES or type_.partition("/")[0] not in PACKAGES

    def fixed(self, items: list[float]) -> object:
        return items

    def got_param(self, value: str | None, request: Message) -> Message:
        """The value as JSON, the default for an unknown one."""
        return {"value": value or request["default"] or "null"}

    def fields(self, type_: str) -> Fields | None:
        return MESSAGES.get(type_)

    def time(self, seconds: float) -> Message:
        """Seconds and nanoseconds."""
        whole = math.floor(seconds)
        return {"secs": whole, "nsecs": int((seconds - whole) * 1e9)}

    def header(self, seq: int, seconds: float, frame_id: str) -> Message:
        """A header that counts."""
        return {"seq": seq, "stamp": self.time(seconds), "frame_id": frame_id}

    def integer(self, name: str, value: int, bits: int, signed: bool) -> int:
        """Return the value; refuse one that does not fit."""
        lowest = -(1 << bits - 1) if signed else 0
        if not lowest <= value < lowest + (1 << bits):
            raise ServiceError(f"field {name} exceeds specified width [{'' if signed else 'u'}int{bits}]")
        return value

    def wrong(self, message: str, name: str, rostype: str, value: object) -> str:
        """Message, field and both types."""
        return f"{message} message requires a {rostype} for field {name}, but got a {type(value)}"

    def unknown_package(self, package: str, kind: str) -> str:
        """rospack does not know it."""
        return f"Unable to load the manifest for package {package}. Caused by: {package}"

    def thrown(self, service: str, error: str) -> str | None:
        """The node survives and reports the error."""
        return f"service [{service}] responded with an error: b'error processing request: {error}'"

    def died(self) -> str | None:
        """The connection to the node breaks."""
        return (
            "transport error completing service call: unable to receive data from sender,"
            " check sender's logs for details"
        )

    def log(self, seq: int, seconds: float, level: int, node: str, text: str) -> Message:
        """rosgraph_msgs/Log."""
        file = f"{node.rpartition('/')[2]}.cpp"
        return {
            "header": self.header(seq, seconds, ""),
            "level": level,
            "name": node,
            "msg": text,
            "file": file,
            "function": "spin",
            "line": 42,
            "topics": ["/rosout"],
        }


ROS1: Dialect = Ros1()

"""ROS 1 behind rosbridge_server 0.11."""

import math
from collections.abc import Collection, Mapping
from types import MappingProxyType

from fleet_tui.simulator.ros.definitions import MESSAGES, Fields
from fleet_tui.simulator.ros.dialect import Dialect, Message
from fleet_tui.simulator.ros.errors import ServiceError

COMMON_VERBS = (
    *("topics", "topics_and_raw_types", "topics_for_type", "topic_type", "publishers", "subscribers"),
    *("services", "services_for_type", "service_type", "service_providers", "service_node"),
    *("nodes", "node_details", "action_servers", "get_time"),
    *("message_details", "service_request_details", "service_response_details"),
    *("set_param", "get_param", "has_param", "delete_param", "get_param_names"),
)


class Ros1:
    """What is told as `package/Name`, with seq in headers, secs and nsecs in times."""

    version, distro = 1, "noetic"
    rosapi_verbs: Collection[str] = (*COMMON_VERBS, "service_host", "search_param")
    call_timeout: float | None = None
    max_message_size: int | None = None
    reads_binary = False
    never_cbor: Collection[str] = ()
    logs_complaints = False
    discovers = False
    defaults: Mapping[tuple[str, str], float] = MappingProxyType({})

    def message_type(self, name: str) -> str:
        """`package/Name`."""
        return name

    service_type = short = primitive = message_type

    def request(self, type_: str) -> str:
        """`package/NameRequest`."""
        return f"{type_}Request"

    def fields(self, type_: str) -> Fields | None:
        """The fields of a message type."""
        return MESSAGES.get(type_)

    def time(self, seconds: float) -> Message:
        """Seconds and nanoseconds."""
        whole = math.floor(seconds)
        return {"secs": whole, "nsecs": int((seconds - whole) * 1e9)}

    def header(self, seq: int, seconds: float, frame_id: str) -> Message:
        """A header that counts."""
        return {"seq": seq, "stamp": self.time(seconds), "frame_id": frame_id}

    def integer(self, name: str, value: int, bits: int, signed: bool) -> int:
        """The value, refused where it does not fit."""
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
        """The node lives and tells the error."""
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

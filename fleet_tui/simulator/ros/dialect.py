"""The bridge's dialect of ROS 1 (rosbridge_server 0.11), which that of another version of ROS overrides."""

import math
from collections.abc import Collection, Mapping
from types import MappingProxyType
from typing import Any

from fleet_tui.simulator.ros.definitions import MESSAGES, PACKAGES, Fields
from fleet_tui.simulator.ros.errors import ServiceError

Message = dict[str, Any]

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


class Dialect:
    """One version of ROS: `package/Name`, seq in headers, secs and nsecs in times, unless it is overridden.
    Types are looked up by their ROS 1 name, `package/Name`."""

    version = 1
    distro = "noetic"
    rosapi_verbs: Collection[str] = (*COMMON_VERBS, "service_host", "search_param")
    """The services of rosapi."""
    call_timeout: float | None = None
    """Seconds after which the bridge abandons a call without a limit of its own, None: never."""
    max_message_size: int | None = None
    """Maximum bytes of a message to a client: longer text is fragmented, longer binary never sent. None: no
    limit."""
    reads_binary = False
    """True if a binary frame from a client is read as text."""
    never_cbor: Collection[str] = ()
    """Types that the bridge never sends as CBOR, in the short spelling."""
    lingers = 0.0
    """Seconds for which the bridge keeps a subscription after the last client has unsubscribed."""
    fragment_id: int | str = 0
    """The id of a fragment whose message has none."""
    aligned = False
    """True if ROS's own encoding is CDR, in which values are aligned."""
    keeps_log = False
    """True if a late subscriber of /rosout receives more than each node's last line."""
    joins_wrong_types = False
    """True if a client with the right type is added to an existing subscription of a wrong type, and receives
    nothing either."""
    fragile = False
    """True if rosapi ends with an exception in one of its handlers."""
    params: Mapping[str, object] = MappingProxyType({"/rosdistro": "noetic\n", "/run_id": "simulated"})
    """The parameters that rosapi knows from the start."""
    discovers = False
    """True if publishers are discovered bit by bit, and quality of service is fixed at the first
    subscription."""
    defaults: Mapping[tuple[str, str], float] = MappingProxyType({})
    """Type and field -> the default of an omitted field, if it is not zero."""

    def message_type(self, name: str) -> str:
        """Return the message type in rosapi's spelling."""
        return name

    def service_type(self, name: str) -> str:
        """Return the service type in rosapi's spelling."""
        return name

    def action_type(self, name: str) -> str:
        """Return the action type in rosapi's spelling."""
        return name

    def short(self, type_: str) -> str:
        """Return the type in the spelling of typedefs and error texts; accepts both spellings."""
        return type_

    def part(self, type_: str, part: str) -> str:
        """The name of a service's `Request` or `Response`."""
        return f"{type_}{part}"

    def rosapi_type(self, name: str) -> str:
        """The ROS 1 name under which the definition of one of rosapi's services stands."""
        return f"rosapi/{name}"

    def importable(self, type_: str) -> bool:
        """Tell whether the bridge can load a message type; it has packages of which nothing is known here."""
        return type_ in MESSAGES or type_.partition("/")[0] not in PACKAGES

    def fixed(self, items: list[float]) -> object:
        """An array of fixed length as the bridge holds it."""
        return items

    def got_param(self, value: str | None, request: Message) -> Message:
        """Return rosapi's answer to get_param; value is JSON, or None if the parameter is unknown."""
        return {"value": value or request["default"] or "null"}

    def fields(self, type_: str) -> Fields | None:
        """Return the fields of a message type in either spelling, None if the bridge does not know it."""
        return MESSAGES.get(type_)

    def primitive(self, rostype: str) -> str:
        """A primitive type as typedefs name it."""
        return rostype

    def time(self, seconds: float) -> Message:
        """A time from seconds since 1970."""
        whole = math.floor(seconds)
        return {"secs": whole, "nsecs": int((seconds - whole) * 1e9)}

    def header(self, seq: int, seconds: float, frame_id: str) -> Message:
        """A header; seq counts a topic's messages from 1."""
        return {"seq": seq, "stamp": self.time(seconds), "frame_id": frame_id}

    def integer(self, name: str, value: int, bits: int, signed: bool) -> int:
        """An integer that was sent for a field, as the bridge passes it on. Raises ServiceError."""
        lowest = -(1 << bits - 1) if signed else 0
        if not lowest <= value < lowest + (1 << bits):
            raise ServiceError(f"field {name} exceeds specified width [{'' if signed else 'u'}int{bits}]")
        return value

    def wrong(self, message: str, name: str, rostype: str, value: object) -> str:
        """The text that refuses a value of another type."""
        return f"{message} message requires a {rostype} for field {name}, but got a {type(value)}"

    def unknown_package(self, package: str, kind: str) -> str:
        """The text for a type of a package that the bridge doesn't have; kind is `msg`, `srv` or `action`."""
        return f"Unable to load the manifest for package {package}. Caused by: {package}"

    def thrown(self, service: str, error: str) -> str | None:
        """Return the answer if a service's handler raises an exception, None if the bridge sends none."""
        return f"service [{service}] responded with an error: b'error processing request: {error}'"

    def died(self) -> str | None:
        """Return the answer if the node dies during the call, None if the bridge sends none."""
        return (
            "transport error completing service call: unable to receive data from sender,"
            " check sender's logs for details"
        )

    def log(self, seq: int, seconds: float, level: int, node: str, text: str) -> Message:
        """A line of /rosout, its level as ROS 1 counts."""
        return {
            "header": self.header(seq, seconds, ""),
            "level": level,
            "name": node,
            "msg": text,
            "file": f"{node.rpartition('/')[2]}.cpp",
            "function": "spin",
            "line": 42,
            "topics": ["/rosout"],
        }


ROS1 = Dialect()

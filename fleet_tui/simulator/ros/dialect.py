"""The differences between the bridges of ROS 1 and ROS 2, one protocol for both."""

from collections.abc import Collection, Mapping
from typing import Any, Protocol

from fleet_tui.simulator.ros.definitions import Fields

Message = dict[str, Any]


class Dialect(Protocol):
    """One version of ROS. Types are looked up by their ROS 1 name, `package/Name`."""

    version: int
    distro: str
    rosapi_verbs: Collection[str]
    """The services of rosapi."""
    call_timeout: float | None
    """Seconds after which the bridge abandons a call without a limit of its own, None: never."""
    max_message_size: int | None
    """Maximum bytes of a message to a client: longer text is fragmented, longer binary never sent. None: no
    limit."""
    reads_binary: bool
    """Tell whether a binary frame from a client is read as text."""
    never_cbor: Collection[str]
    """Types that the bridge never sends as CBOR, in the short spelling."""
    lingers: float
    """Seconds for which the bridge keeps a subscription after the last client has unsubscribed."""
    fragment_id: int | str
    """The id of a fragment whose message has none."""
    aligned: bool
    """Tell whether ROS's own encoding is CDR, in which values are aligned."""
    keeps_log: bool
    """Tell whether a late subscriber of /rosout receives more than each node's last line."""
    joins_wrong_types: bool
    """True if a client with the right type is added to an existing subscription of a wrong type, and receives
    nothing either."""
    fragile: bool
    """Tell whether rosapi ends with an exception in one of its handlers."""
    params: Mapping[str, object]
    """The parameters that rosapi knows from the start."""
    discovers: bool
    """Publishers are discovered bit by bit, and quality of service is fixed at the first subscription."""

    defaults: Mapping[tuple[str, str], float]
    """Type and field -> the default of an omitted field, if it is not zero."""

    def message_type(self, name: str) -> str:
        """Return the message type in rosapi's spelling."""

    def service_type(self, name: str) -> str:
        """Return the service type in rosapi's spelling."""

    def action_type(self, name: str) -> str:
        """Return the action type in rosapi's spelling."""

    def short(self, type_: str) -> str:
        """Return the type in the spelling of typedefs and error texts; accepts both spellings."""

    def part(self, type_: str, part: str) -> str:
        """The name of a service's `Request` or `Response`."""

    def rosapi_type(self, name: str) -> str:
        """The ROS 1 name under which the definition of one of rosapi's services stands."""

    def importable(self, type_: str) -> bool:
        """Tell whether the bridge can load a message type; it has packages of which nothing is known here."""

    def fixed(self, items: list[float]) -> object:
        """An array of fixed length as the bridge holds it."""

    def got_param(self, value: str | None, request: Message) -> Message:
        """Return rosapi's answer to get_param; value is None if the parameter is unknown."""

    def fields(self, type_: str) -> Fields | None:
        """Return the fields of a message type in either spelling, None if the bridge does not know it."""

    def primitive(self, rostype: str) -> str:
        """A primitive type as typedefs name it."""

    def time(self, seconds: float) -> Message:
        """A time from seconds since 1970."""

    def header(self, seq: int, seconds: float, frame_id: str) -> Message:
        """A header; seq counts a topic's messages from 1."""

    def integer(self, name: str, value: int, bits: int, signed: bool) -> int:
        """An integer that was sent for a field, as the bridge passes it on. Raises ServiceError."""

    def wrong(self, message: str, name: str, rostype: str, value: object) -> str:
        """The text that refuses a value of another type."""

    def unknown_package(self, package: str, kind: str) -> str:
        """The text for a type of a package that the bridge doesn't have; kind is `msg` or `srv`."""

    def thrown(self, service: str, error: str) -> str | None:
        """Return the answer if a service's handler raises an exception, None if the bridge sends none."""

    def died(self) -> str | None:
        """Return the answer if the node dies during the call, None if the bridge sends none."""

    def log(self, seq: int, seconds: float, level: int, node: str, text: str) -> Message:
        """A line of /rosout, its level as ROS 1 counts."""

"""The adapter protocol: reports and requests of a kind of robots, and their messages."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Literal, NamedTuple, Protocol

from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.events import Event
from fleet_tui.model.kind import CAMERA, FRAMES, PATH, SCAN, Kind
from fleet_tui.model.robot import Robot
from fleet_tui.robots.probes import Probe
from fleet_tui.robots.ros.names import Names
from fleet_tui.text.language import Message

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import StreamValue


STREAM_KEYS = {SCAN: SCAN, PATH: PATH, CAMERA: CAMERA, "plan": PATH, "tf_static": FRAMES}
"""Streams by the keys of their topics."""


class Feed(NamedTuple):
    """One topic to subscribe to. `robots` are all those it reports on, usually one; `key` names the value.

    `rate_ms`: milliseconds between two messages, 0 for every one. `latched`: late subscribers get its last
    message. `wanted_for`: subscribed only while that is needed, a `map` on screen, the `target` of a goal
    that no other topic reports, the `place` of a robot that no localisation tells (all its messages are
    requested, and one in `rate_ms` is read), or a `stream` beside the fleet state. `large`: requested as CBOR
    and decoded off the loop. `fast`: as frequent as poses. `silent`: may rightly send nothing for hours.
    `is_shared`: one topic may report on all robots of a link; its messages name them, but for a map, which is
    of none. `queue_length`: messages that the bridge keeps for this console; with more than one of them each
    counts, not only the newest. `has_pictures`: its maps are pictures, which the reader of frames decodes.
    `action`: it reports all the time on the goal of that action that is driven.
    """

    key: str
    robots: tuple[str, ...]
    floor: str
    address: str
    type: str
    rate_ms: int = 0
    latched: bool = False
    wanted_for: Literal["", "map", "target", "place", "stream"] = ""
    large: bool = False
    fast: bool = False
    silent: bool = False
    is_shared: bool = False
    queue_length: int = 1
    has_pictures: bool = False
    action: str = ""

    @property
    def robot(self) -> str:
        """The first robot it reports on."""
        return self.robots[0]

    @property
    def stream_key(self) -> str:
        """The key of the stream that it feeds, empty for none."""
        return STREAM_KEYS.get(self.key, "")

    @property
    def on_demand(self) -> bool:
        """Tell whether it is subscribed only on demand."""
        return bool(self.wanted_for)


class ServiceCall(NamedTuple):
    """A service call, complete and typed: a bridge would fill gaps with zeros. `server` is the action server
    without which the call is not made, if rosapi lists these."""

    address: str
    type: str
    args: Mapping[str, object]
    server: str = ""


class ActionGoal(NamedTuple):
    """A goal of an action, complete and typed."""

    address: str
    type: str
    args: Mapping[str, object]


class Publication(NamedTuple):
    """A message on a topic, without an answer. `name` is the name under which the robot will list the order
    that it gives, if any. A second delivery has no further effect, unless `is_request`: then it is sent
    once only, and answered by the event RequestAnswered with its name."""

    address: str
    type: str
    message: Mapping[str, object]
    name: str = ""
    is_request: bool = False


Outgoing = ServiceCall | ActionGoal | Publication


class Limit(NamedTuple):
    """Megabytes of the largest message that a link accepts, and the config key of that limit."""

    megabytes: float
    key: str


class Site(NamedTuple):
    """Settings of a configuration that adapters use: milliseconds between messages, seconds of silence after
    which a robot counts as offline, the name of its profile's table, and the frame of each floor. On a
    broker also the role of this console and the key that says so, and by robot its manufacturer and serial
    number; `console`: digits with which the names of this operator's orders end."""

    pose_ms: int = 100
    status_ms: int = 500
    offline_after: float = 5.0
    table: str = "profile"
    frames: Mapping[str, str] = {}
    role: str = "watch"
    role_key: str = "role"
    vehicles: Mapping[str, tuple[str, str]] = {}
    console: str = ""


class Adapter(Protocol):
    """One kind of robots under the names of one profile. Pure and stateless: all state is in the robot's."""

    @property
    def kind(self) -> Kind:
        """Return the capabilities of these robots."""

    @property
    def names(self) -> Names:
        """The names of their topics, services and actions."""

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        """Return the topics to subscribe to, the most urgent first."""

    def read(self, feed: Feed, msg: object, at: float) -> Iterable[Event]:
        """Return the events of a message, still encoded. `at`: monotonic seconds. Raises WireError."""

    def stream(self, feed: Feed, msg: object) -> "StreamValue":
        """Return the value of a stream, a path also in the plan of a goal. Raises WireError."""

    def services(self, robot: str) -> Iterable[tuple[str, str, str]]:
        """Return key, name and type of each service that is called, the most urgent first."""

    def publications(self, robot: str) -> Iterable[tuple[str, str]]:
        """Return name and type of each topic that commands are published on."""

    def probes(self, robot: str) -> Iterable[Probe]:
        """Return the doctor's checks beside topics and services."""

    def outgoing(
        self, command: Command, command_id: int, robot: Robot, unique: str = ""
    ) -> Sequence[Outgoing]:
        """Return the calls and messages of a command, in the order of sending. `unique`: 32 hexadecimal
        digits for a unique name. Raises CommandError for one that must not be sent."""

    def outcome(
        self, command: Command, values: object, result: bool, status: int | None = None
    ) -> tuple[Stage, Message]:
        """Return the stage of a command that an answer leads to, with the robot's own text. `result` is False
        if the bridge did not pass it on; `status` is that of a goal (action_msgs/GoalStatus), None for a
        call: of an ended order it is DONE or FAILED, of a rejected one REFUSED."""

    def learned(
        self, call: ServiceCall, values: object, robot: Robot, sent_at: float, at: float
    ) -> Iterable[Event]:
        """Return the events in the answer to a call that left at `sent_at`, besides the result of the
        command. Both times are monotonic seconds."""

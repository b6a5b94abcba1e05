"""The seam: what a kind of robots reports, what it accepts, and how both are said."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Literal, NamedTuple, Protocol

from fleet_tui.adapters.probes import Probe
from fleet_tui.adapters.ros.names import Names
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.events import Event
from fleet_tui.model.kind import Kind
from fleet_tui.model.robot import Robot


class Feed(NamedTuple):
    """One topic to listen to. `robots` are all those it tells of, usually one; `key` is which of their
    values.

    `rate_ms`: milliseconds between two messages, 0 for every one. `latched`: its last message comes to who
    subscribes late. `wanted_for`: only while that is wanted, a `map` that somebody looks at, or the `target`
    of a goal that nothing else tells. `large`: asked for as CBOR and decoded beside the loop. `fast`: comes
    as often as poses do. `silent`: nothing may come for hours, and all is well. `is_shared`: one topic may
    tell of all robots."""

    key: str
    robots: tuple[str, ...]
    floor: str
    address: str
    type: str
    rate_ms: int = 0
    latched: bool = False
    wanted_for: Literal["", "map", "target"] = ""
    large: bool = False
    fast: bool = False
    silent: bool = False
    is_shared: bool = False

    @property
    def robot(self) -> str:
        """The first robot it tells of."""
        return self.robots[0]

    @property
    def on_demand(self) -> bool:
        """Tell whether it is asked for only now and then."""
        return bool(self.wanted_for)


class ServiceCall(NamedTuple):
    """A service call, complete and typed: a bridge would fill gaps with zeros."""

    address: str
    type: str
    args: Mapping[str, object]


class ActionGoal(NamedTuple):
    """A goal of an action, complete and typed."""

    address: str
    type: str
    args: Mapping[str, object]


class Publication(NamedTuple):
    """A message on a topic. Nothing answers to it. `name` is that under which the robot will list the order
    that it gives, if it gives one. To be taken twice does nothing more than to be taken once."""

    address: str
    type: str
    message: Mapping[str, object]
    name: str = ""


Outgoing = ServiceCall | ActionGoal | Publication


class Limit(NamedTuple):
    """Megabytes of the largest message that a link takes, and the key of the config that says so."""

    megabytes: float
    key: str


class Site(NamedTuple):
    """Settings of a configuration that adapters use: milliseconds between messages, seconds of silence after
    which a robot counts as offline, and the table that its profile stands in."""

    pose_ms: int = 100
    status_ms: int = 500
    offline_after: float = 5.0
    table: str = "profile"


class Adapter(Protocol):
    """One kind of robots under the names of one profile. Pure, and without a memory: what has to be
    remembered is in the state of the robot."""

    @property
    def kind(self) -> Kind:
        """Return what these robots report and accept."""

    @property
    def names(self) -> Names:
        """The names of their topics, services and actions."""

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        """Return what to listen to, the most urgent first."""

    def read(self, feed: Feed, msg: object, at: float) -> Iterable[Event]:
        """Return what a message, still encoded, tells. `at`: monotonic seconds. Raises WireError."""

    def services(self, robot: str) -> Iterable[tuple[str, str, str]]:
        """Return key, name and type of each service that is called, the most urgent first."""

    def publications(self, robot: str) -> Iterable[tuple[str, str]]:
        """Return name and type of each topic that commands are published on."""

    def probes(self, robot: str) -> Iterable[Probe]:
        """Return what a doctor looks at beside topics and services."""

    def outgoing(
        self, command: Command, command_id: int, robot: Robot, unique: str = ""
    ) -> Sequence[Outgoing]:
        """Return what carries a command, in the order in which it must leave. `unique`: 32 hexadecimal digits
        for a name that nothing else has. Raises CommandError for one that must not leave."""

    def outcome(
        self, command: Command, values: object, result: bool, status: int | None = None
    ) -> tuple[Stage, str]:
        """Return what an answer means for a command, with the robot's own words. `result` is False where the
        bridge did not pass it on; `status` is that of a goal (action_msgs/GoalStatus), None for a call: of an
        order that has ended it is DONE or FAILED, of one that was not taken REFUSED."""

    def learned(
        self, call: ServiceCall, values: object, robot: Robot, sent_at: float, at: float
    ) -> Iterable[Event]:
        """Return what the answer to a call that left at `sent_at` tells of its robot, beside how the command
        went. Both times are monotonic seconds."""

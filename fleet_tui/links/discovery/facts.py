"""Facts about one bridge, before any judgement."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from fleet_tui.model.events import Event, GraphReceived, LabelsReceived
from fleet_tui.model.navigation_events import OdometryReported
from fleet_tui.robots.adapter import Adapter, Feed
from fleet_tui.robots.ros.names import is_hidden

if TYPE_CHECKING:  # with numpy
    from fleet_tui.model.set_up.streams import StreamValue

LONG_ENOUGH = 1.5  # seconds of silence that count as evidence


@dataclass(frozen=True, slots=True)
class RosapiFacts:
    """The answers of rosapi: types by topic, types by service (None if not asked), nodes, by topic the nodes
    that publish it, and those that subscribe to it, if asked; by service its node, the names of action
    servers, and the ROS version (0: unknown) and distribution ("": unknown). `problem` is the reason for no
    answer."""

    topics: Mapping[str, str] = field(default_factory=dict)
    services: Mapping[str, str | None] = field(default_factory=dict)
    nodes: tuple[str, ...] = ()
    publishers: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    subscribers: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    owners: Mapping[str, str] = field(default_factory=dict)
    actions: tuple[str, ...] = ()
    ros: int = 0
    distro: str = ""
    problem: str = ""
    is_bridge_mute: bool = False
    """The node of the bridge does not answer either."""

    @property
    def is_absent(self) -> bool:
        """Tell whether the bridge runs without a rosapi."""
        return "does not exist" in self.problem

    @property
    def is_silent(self) -> bool:
        """Tell whether its node exists and does not answer: the wait was long enough, here or at the
        bridge."""
        message = ("no reply from rosapi", "Unable to communicate with service", "Timeout exceeded")
        return any(word in self.problem for word in message)

    def lists_action_of(self, topic: str) -> bool:
        """Tell whether a hidden topic's action server is listed."""
        return is_hidden(topic) and topic.partition("/_action/")[0] in self.actions

    def lacks_action_of(self, topic: str) -> bool:
        """Tell whether a hidden topic's action server is known not to exist."""
        return is_hidden(topic) and bool(self.actions) and not self.lists_action_of(topic)

    def has(self, topic: str) -> bool:
        """Tell whether a topic has a publisher: every open console keeps the names of its own listed. The
        topics of actions are never listed."""
        return is_hidden(topic) or (topic in self.topics and self.publishers.get(topic) != ())


@dataclass(frozen=True, slots=True)
class TopicFacts:
    """Measurements of one topic. Seconds: `waited` for it, `first_after` the subscribe, `age` of the last.

    `event` is the last readable message, `problem` the error of another. `lag`: the least of arrival by our
    clock minus the robot's stamp, `late`: the last of it beyond the least. `retried`: it was subscribed once
    more, with default options; `fragmented`: bytes of a fragmented message; `held_by`: the bridge's node, if
    it still held the topic after we unsubscribed; `complaint`: the message about it in the bridge's log;
    `picture`: the newest one of a camera. `events` and `lags`: the last of each robot that its messages
    name, by `key_of`.
    """

    wanted: Feed
    subscribed: bool = False
    waited: float = 0.0
    count: int = 0
    faults: int = 0
    rate: float | None = None
    first_after: float | None = None
    age: float | None = None
    event: Event | None = None
    problem: str = ""
    lag: float | None = None
    late: float | None = None
    retried: bool = False
    fragmented: int = 0
    held_by: str = ""
    complaint: str = ""
    picture: "StreamValue | None" = None
    events: Mapping[str, Event] = field(default_factory=dict)
    lags: Mapping[str, float] = field(default_factory=dict)

    @property
    def topic(self) -> str:
        """Return its name on the wire."""
        return self.wanted.address

    @property
    def is_silent(self) -> bool:
        """Tell whether nothing arrived in a sufficient time. For a topic published only on change, only if
        the bridge complains."""
        means = not self.wanted.silent or bool(self.complaint)
        return not self.count and self.waited >= LONG_ENOUGH and means


def key_of(event: Event) -> str:
    """Return the key of an event among those of its topic: its robot; for maps without one the floor, for a
    graph and labels both. Of two transforms that of the localisation has its robot alone."""
    if isinstance(event, GraphReceived | LabelsReceived):
        return f"{type(event).__name__} {event.robot} {event.floor}"
    if isinstance(event, OdometryReported) and event.is_transform:
        return f"{type(event).__name__} {event.robot}"
    return getattr(event, "robot", "") or getattr(event, "floor", "")


@dataclass(frozen=True, slots=True)
class BridgeFacts:
    """Everything about one bridge that answers. `round_trips` in seconds, `busy_trips` those while all topics
    were subscribed; `ahead`: seconds by which its clock is ahead of ours, None if not reported; `lost`:
    the reason the link ended meanwhile; `behind`: our own maximum delay in seconds; `adapters` by robot;
    `answers` of the services that probes call, by name."""

    name: str
    rosapi: RosapiFacts
    topics: tuple[TopicFacts, ...] = ()
    round_trips: tuple[float, ...] = ()
    ahead: float | None = None
    lost: str = ""
    busy_trips: tuple[float, ...] = ()
    behind: float = 0.0
    adapters: Mapping[str, Adapter] = field(default_factory=dict)
    answers: Mapping[str, object] = field(default_factory=dict)
    barred: frozenset[str] = frozenset()
    """Services and actions that it does not allow, by its log."""

    def of(self, robot: str) -> list[TopicFacts]:
        return [facts for facts in self.topics if robot in facts.wanted.robots]

    def table(self, robot: str) -> str:
        """Return the config table of a robot's profile."""
        return self.adapters[robot].names.table

    def knows(self, robot: str) -> bool:
        """Tell whether the bridge knows anything of a robot; true if unknown."""
        named = [one.events for one in self.topics if one.wanted.queue_length > 1]  # messages name robots
        if any(robot in events for events in named):
            return True
        own = [one for one in self.of(robot) if not one.wanted.is_shared]
        return bool(self.rosapi.problem) or any(
            one.count or self.rosapi.lists_action_of(one.topic) or self._has(one.topic) for one in own
        )

    def _has(self, topic: str) -> bool:
        return self.rosapi.has(topic) and not is_hidden(topic)

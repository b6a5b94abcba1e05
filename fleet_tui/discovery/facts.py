"""Facts about one bridge, before any judgement."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from fleet_tui.adapters.adapter import Adapter, Feed
from fleet_tui.model.events import Event

LONG_ENOUGH = 1.5  # seconds without a message that mean anything


def is_hidden(topic: str) -> bool:
    """Tell whether it belongs to an action: rosapi does not list these."""
    return "/_action/" in topic


@dataclass(frozen=True, slots=True)
class RosapiFacts:
    """The answers of rosapi: types by topic, types by service (None where it was not asked), nodes, by topic
    the nodes that publish it, by service its node, the names of action servers, and which ROS it is (0: not
    known) in which distribution ("": not known). `problem` is why it tells nothing."""

    topics: Mapping[str, str] = field(default_factory=dict)
    services: Mapping[str, str | None] = field(default_factory=dict)
    nodes: tuple[str, ...] = ()
    publishers: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    owners: Mapping[str, str] = field(default_factory=dict)
    actions: tuple[str, ...] = ()
    ros: int = 0
    distro: str = ""
    problem: str = ""

    @property
    def is_absent(self) -> bool:
        """Tell whether there is none beside the bridge."""
        return "does not exist" in self.problem

    @property
    def is_silent(self) -> bool:
        """Tell whether its node is there and does not answer: we waited long enough, or the bridge did."""
        words = ("no reply from rosapi", "Unable to communicate with service", "Timeout exceeded")
        return any(word in self.problem for word in words)

    def lists_action_of(self, topic: str) -> bool:
        """Tell whether a hidden topic's action server is there."""
        return is_hidden(topic) and topic.partition("/_action/")[0] in self.actions

    def lacks_action_of(self, topic: str) -> bool:
        """Tell whether a hidden topic's action server is known not to be there."""
        return is_hidden(topic) and bool(self.actions) and not self.lists_action_of(topic)

    def has(self, topic: str) -> bool:
        """Tell whether a topic is there to be heard: every open console keeps the names of its own listed.
        The topics of actions never are."""
        return is_hidden(topic) or (topic in self.topics and self.publishers.get(topic) != ())


@dataclass(frozen=True, slots=True)
class TopicFacts:
    """Measurements of one topic. Seconds: `waited` for it, `first_after` the subscribe, `age` of the last.

    `event` is the last message that could be read, `problem` why another could not. `lag`: the least
    of arrival by our clock minus the robot's stamp, `late`: the last of it beyond the least. `again`: it
    was asked for once more, plainly; `fragmented`: bytes of a message that came in pieces; `held_by`: the
    bridge's node, where it held the topic still when we had let go; `complaint`: what its log says of it.
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
    again: bool = False
    fragmented: int = 0
    held_by: str = ""
    complaint: str = ""

    @property
    def topic(self) -> str:
        """Its name on the wire."""
        return self.wanted.address

    @property
    def is_silent(self) -> bool:
        """Tell whether nothing came in a time that means anything. Of what speaks only on change that is so
        where the bridge complains."""
        means = not self.wanted.silent or bool(self.complaint)
        return not self.count and self.waited >= LONG_ENOUGH and means


@dataclass(frozen=True, slots=True)
class BridgeFacts:
    """Everything about one bridge that answers. `round_trips` in seconds, `busy_trips` those while all topics
    came; `ahead`: by how many seconds its clock is ahead of ours, None where it does not say; `lost`: why the
    link ended meanwhile; `behind`: by how many seconds we ourselves were late at most; `adapters` by
    robot; `answers` of the services that probes ask, by name."""

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

    def of(self, robot: str) -> list[TopicFacts]:
        """A robot's topics."""
        return [facts for facts in self.topics if robot in facts.wanted.robots]

    def table(self, robot: str) -> str:
        """Return where a robot's profile stands in the config."""
        return self.adapters[robot].names.table

    def knows(self, robot: str) -> bool:
        """Tell whether the bridge knows anything of a robot; true where it can't be asked."""
        own = [one for one in self.of(robot) if not one.wanted.is_shared]
        return bool(self.rosapi.problem) or any(
            one.count or self.rosapi.lists_action_of(one.topic) or self._has(one.topic) for one in own
        )

    def _has(self, topic: str) -> bool:
        return self.rosapi.has(topic) and not is_hidden(topic)

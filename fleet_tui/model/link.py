"""The state of one bridge, as shown to an operator."""

from collections.abc import Mapping
from enum import Enum

from msgspec import Struct, field

from fleet_tui.text.language import EMPTY, Message


class Phase(Enum):
    """The phase of a connection for telemetry."""

    WAITING = "waiting"
    CONNECTING = "connecting"
    UP = "up"


class CommandPath(Enum):
    """The state of the command path, measured on a separate connection. UNREGISTERED: the bridge answers, but
    earlier services of robots no longer exist."""

    UNTRIED = "untried"
    ALIVE = "alive"
    UNREGISTERED = "unregistered"
    DEAD = "dead"


NO_WAY = frozenset({CommandPath.UNREGISTERED, CommandPath.DEAD})
"""States in which commands don't reach all robots."""

HALF_DEAD = Message("rosbridge is half dead: restart it")
"""Why there is no command path if only the bridge itself answers: no topic, and no node by way of it."""
SERVICES_GLOB = "services_glob"
ACTIONS_GLOB = "actions_glob"
"""Allow-lists of rosbridge, of the services and of the actions that its clients may call."""
NOT_ADMITTED = Message("the bridge does not allow the heartbeat /rosapi/get_time (services_glob)")
NO_REPLY = Message("no reply from the bridge to calls")
UNPROVEN = Message("not tried yet: no node answers")
"""Neither rosapi nor the bridge's own node, as after a restart of the ROS master, or at a site without rosapi
whose bridge has another name: a command shows it."""
UNASKED = Message("not tried yet: rosapi does not answer")
"""No other node may be asked by a console that is read-only."""
OF_BAG = "rosbag://"
"""Prefix of the address of a recorded file, instead of a bridge."""


class LinkState(Struct, frozen=True):
    """A bridge: `since` is the start of the phase, `next_try` the next attempt, both monotonic seconds;
    `reason` is the reason for no link in plain words; `commands_connected`: there is a connection for
    commands, tested or not; `was_up`: it has been up before; `outage`: seconds for which it was down before
    it came up again, else 0; `fault_at` is the time of the last bad frame; `lag` are the seconds after which
    it last answered a question over the connection for telemetry, asked at `asked_at`, `late` those of which
    not this console but the bridge is the cause; `clock` is (our time - time by the clock of its site) at
    its last answer that told it, at `clock_at`, None without one, `drift` the seconds by which that grows
    in each of ours, and `drifted` those by which it has grown so; `unsourced` is the package whose messages
    the bridge lacks, `dropped` are the robots of whose topics it lost its own subscriptions, `not_allowed`
    the topics with their robots that its allow-list lacks, `barred` by service or action the list that lacks
    it; `site` is the one that it belongs to; `topics` are the subscriptions that were requested of a bridge
    with many, of which `waiting_topics` are not handled yet, `subscribed_at` the time of the last handled
    one."""

    name: str
    url: str
    phase: Phase = Phase.CONNECTING
    since: float = 0.0
    reason: Message = EMPTY
    next_try: float | None = None
    last_received: float | None = field(default=None, name="heard")  # as recordings have it
    command_path: CommandPath = CommandPath.UNTRIED
    command_reason: Message = EMPTY
    commands_connected: bool = False
    was_up: bool = False
    outage: float = 0.0
    faults: int = 0
    last_fault: str = ""
    fault_at: float | None = None
    lag: float = 0.0
    asked_at: float = 0.0
    late: float = 0.0
    clock: float | None = None
    clock_at: float = 0.0
    drift: float = 0.0
    drifted: float = 0.0
    unsourced: str = ""
    dropped: tuple[str, ...] = ()
    not_allowed: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    barred: Mapping[str, str] = field(default_factory=dict)
    site: str = ""
    topics: int = 0
    waiting_topics: int = 0
    subscribed_at: float = 0.0

    @property
    def ready_since(self) -> float:
        """Return the time from which its robots may be silent or incomplete only by themselves."""
        return max(self.since, self.subscribed_at)

    @property
    def is_half_dead(self) -> bool:
        """Tell whether nothing of its robots can arrive though it is connected."""
        return self.command_path is CommandPath.DEAD and self.command_reason == HALF_DEAD

    def hides(self, robot: str) -> bool:
        """Tell whether nothing of a robot can arrive though it is connected: its silence is not its own."""
        is_barred = any(robot in robots for robots in self.not_allowed.values())
        return self.is_half_dead or robot in self.dropped or is_barred

    def refusal_of(self, name: str) -> Message:
        """Return that the bridge drops calls of a service, or goals of an action; empty if none is known."""
        return (
            Message("the bridge does not allow it ({barred})", barred=self.barred[name])
            if name in self.barred
            else EMPTY
        )

    @property
    def is_starting(self) -> bool:
        """Tell whether this is the first connection attempt: nothing has failed yet."""
        if self.phase is Phase.UP:
            return not self.commands_connected and self.command_path is CommandPath.UNTRIED
        return self.phase is Phase.CONNECTING and not self.reason

    @property
    def is_bag(self) -> bool:
        """Tell whether the source is a ROS bag instead of a bridge."""
        return self.url.startswith(OF_BAG)

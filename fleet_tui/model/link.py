"""The state of one bridge, as an operator needs to know it."""

from enum import Enum

from msgspec import Struct


class Phase(Enum):
    """The phase of a connection for telemetry."""

    WAITING = "waiting"
    CONNECTING = "connecting"
    UP = "up"


class CommandPath(Enum):
    """The state of the command path, found out on a connection of its own. UNREGISTERED: the bridge
    answers, and services of robots that were there no longer exist."""

    UNTRIED = "untried"
    ALIVE = "alive"
    UNREGISTERED = "unregistered"
    DEAD = "dead"


NO_WAY = frozenset({CommandPath.UNREGISTERED, CommandPath.DEAD})
"""States in which commands don't reach all robots."""

OF_BAG = "rosbag://"
"""How the address begins of what is no bridge, but the file that a recording was made of."""


class LinkState(Struct, frozen=True):
    """A bridge: `since` is when the phase began, `next_try` when it is tried again, both
    monotonic seconds; `reason` says in plain words why there is no link; `commands_connected`: there is
    a connection for commands, tried or not; `fault_at` is when a bad frame came last; `late` are the
    seconds by which the poses that come over it are late, `unsourced` the package whose messages the bridge
    was started without."""

    name: str
    url: str
    phase: Phase = Phase.CONNECTING
    since: float = 0.0
    reason: str = ""
    next_try: float | None = None
    heard: float | None = None
    command_path: CommandPath = CommandPath.UNTRIED
    command_reason: str = ""
    commands_connected: bool = False
    faults: int = 0
    last_fault: str = ""
    fault_at: float | None = None
    late: float = 0.0
    unsourced: str = ""

    @property
    def unsourced_text(self) -> str:
        """Return what to do about messages that the bridge lacks, empty where it has all."""
        if not self.unsourced:
            return ""
        return f"rosbridge lacks package {self.unsourced}: source its workspace and restart rosbridge"

    @property
    def is_starting(self) -> bool:
        """Tell whether it is tried for the first time: nothing speaks against it yet."""
        if self.phase is Phase.UP:
            return not self.commands_connected and self.command_path is CommandPath.UNTRIED
        return self.phase is Phase.CONNECTING and not self.reason

    @property
    def is_bag(self) -> bool:
        """Tell whether there never was a bridge: what is shown was made of a ROS bag."""
        return self.url.startswith(OF_BAG)

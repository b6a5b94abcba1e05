"""A simulated fleet of any kind, as the bridge in front of it sees it."""

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Protocol

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Message, Topic
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.goals import ActionServer, ServedGoal
from fleet_tui.simulator.ros_types import ServiceType

if TYPE_CHECKING:
    from fleet_tui.simulator.faults.wire import Play

Line = tuple[int, str, str]
"""A line of the log: level as ROS 1 counts, node and words."""


class Body(Protocol):
    """A robot of any kind."""

    name: str
    index: int
    silence: float
    """Seconds for which nothing of it is published."""


class Fleet(Protocol):
    """Robots of one kind, and what they say and understand."""

    faults: "Mapping[str, tuple[str, Play]]"
    """The faults of such robots, by name: the text of the help, and how it is played on one."""
    troubles: list[Callable[[float], None]]
    """Called at every step with the seconds that pass."""

    @property
    def robots(self) -> Mapping[str, Body]:
        """The robots by name."""

    @property
    def actions(self) -> Mapping[str, ActionServer]:
        """The action servers by name."""

    def step(self, dt: float) -> None:
        """Let dt seconds pass."""

    def topics(self, loaded_at: float, dialect: Dialect) -> Iterable[Topic]:
        """Every topic; the maps were loaded at this wall time."""

    def heard(self) -> Mapping[str, tuple[str, Callable[[Message], None]]]:
        """The topics that are listened to: name -> type, and what takes a message."""

    def feedback(self, server: ActionServer, goal: ServedGoal, dialect: Dialect) -> Message | None:
        """The feedback of an action on a goal, None where it says nothing."""

    def result(self, server: ActionServer, goal: ServedGoal) -> Message | None:
        """The result of a goal that is over, None while it can't be heard."""

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        """The services by name."""

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        """The answer of a service; `args` complete and of the right types."""

    def news(self, dialect: Dialect) -> Iterable[tuple[str, Payload]]:
        """Topics and messages of what has changed since the last look."""

    def lines(self) -> Iterable[Line]:
        """The lines about everything that happened since the last look."""

    def health(self) -> Iterable[Message]:
        """Entries of /diagnostics about every robot that can be heard."""

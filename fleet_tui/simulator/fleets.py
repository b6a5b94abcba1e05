"""A simulated fleet of any kind, as the bridge in front of it sees it."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Message, Topic
from fleet_tui.simulator.ros.dialect import Dialect
from fleet_tui.simulator.ros.filling import ServiceType
from fleet_tui.simulator.ros.goals import ActionServer, ServedGoal
from fleet_tui.simulator.world import Body

Line = tuple[int, str, str]
"""A line of the log: level in ROS 1's numbers, node and text."""
Subscriptions = Mapping[str, tuple[str, Callable[[Message], None]]]
"""The topics to which robots subscribe: name -> type, and the function that receives a message."""


class Fleet(ABC):
    """Robots of one kind: the topics they publish, and the messages, services and goals they accept."""

    kind: str
    """The name of the kind."""
    robots: Mapping[str, Body]
    """The robots by name."""
    troubles: list[Callable[[float], None]]
    """Called at every step with the seconds that pass."""

    @property
    def actions(self) -> Mapping[str, ActionServer]:
        """The action servers by name."""
        return {}

    @abstractmethod
    def step(self, dt: float) -> None:
        """Advance the time by dt seconds."""

    @abstractmethod
    def topics(self, loaded_at: float, dialect: Dialect) -> Iterable[Topic]:
        """Every topic; the maps were loaded at this wall time."""

    @abstractmethod
    def subscriptions(self) -> Subscriptions:
        """The topics to which robots subscribe."""

    def feedback(self, server: ActionServer, goal: ServedGoal, dialect: Dialect) -> Message | None:
        """Return the feedback on a goal, None if the action sends none."""
        return None

    def result(self, server: ActionServer, goal: ServedGoal) -> Message | None:
        """Return the result of an ended goal, None while the robot is silent."""
        return None

    def services(self, dialect: Dialect) -> Mapping[str, ServiceType]:
        """The services by name."""
        return {}

    def answer(self, service: str, args: Mapping[str, Any]) -> Message:
        """The answer of a service; `args` complete and of the right types."""
        raise KeyError(service)

    @abstractmethod
    def news(self, dialect: Dialect) -> Iterable[tuple[str, Payload]]:
        """Return topics and messages for the changes since the last call."""

    def lines(self) -> Iterable[Line]:
        """Return the log lines for everything that happened since the last call."""
        return ()

    @abstractmethod
    def health(self) -> Iterable[Message]:
        """Return the entries of /diagnostics for every robot that is not silent."""

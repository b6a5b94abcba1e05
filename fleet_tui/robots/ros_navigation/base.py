"""The common part of the adapters of both navigation stacks."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple, assert_never

import msgspec

from fleet_tui.model import commands, events
from fleet_tui.model.order import Stop
from fleet_tui.model.robot import Robot
from fleet_tui.model.set_up.commands import SetUpCommand
from fleet_tui.robots.adapter import Feed, Outgoing, ServiceCall, Site
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.facts import read_map
from fleet_tui.robots.ros.names import Names, Vocabulary
from fleet_tui.robots.ros.set_up.reading import read_mode
from fleet_tui.robots.ros.set_up.requests import SetUpRequests
from fleet_tui.robots.ros_navigation.kinds import READERS
from fleet_tui.robots.ros_navigation.pauses import Pauses, PauseSettings
from fleet_tui.robots.ros_navigation.reading import Read
from fleet_tui.robots.ros_navigation.transforms import read_places

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import StreamValue


class GoalMessages(NamedTuple):
    """Messages of orders and cancellations, in the order of sending. Each raises CommandError for one that
    must not be sent."""

    order: Callable[[Names, Robot, Sequence[Stop], str], Sequence[Outgoing]]
    """The last argument is a unique name for the goal."""
    cancel: Callable[[Names, Robot, str], Sequence[Outgoing]]
    cancel_own: Callable[[Names, Robot], Sequence[Outgoing]]
    """Of the goals of this console."""
    cancel_all: Callable[[Names, Robot], Sequence[Outgoing]]


class NavigationAdapter:
    """Names, pauses and readers of robots that drive one goal at a time."""

    def __init__(
        self,
        kind: str,
        vocabulary: Vocabulary,
        profile: Profile,
        site: Site,
        settings: type[PauseSettings],
        goals: GoalMessages,
    ) -> None:
        """`kind` is the name of the profile's table of `settings`."""
        self._goals = goals
        self.names = Names(vocabulary, profile, site.table)
        self.site = site
        self.pauses = Pauses(self.names, msgspec.convert(profile.settings.get(kind, {}), settings))
        self.readers: Mapping[str, Read] = {key: make(self.names) for key, make in READERS.items()}
        self._read_map = read_map(self.names)
        self._read_mode = read_mode(self.names)
        self._read_places = read_places(self.names)
        self.set_up = SetUpRequests(self.names, site, frames_are_floors=False)

    def read(self, feed: Feed, msg: object, at: float) -> Iterable[events.Event]:
        """Return the events of a message, none of a stream. Raises WireError."""
        if feed.key in ("tf", "tf_static"):
            return self._read_places(feed.robots, msg, at, feed.key == "tf_static")
        if feed.wanted_for == "stream":
            return ()
        if feed.key == "map":
            return (self._read_map(feed.robot, feed.floor, msg, at),)
        if feed.key == "mode":
            return (self._read_mode(feed.robot, "", msg, at),)
        return self.readers[feed.key](feed.robot, msg, at)

    def stream(self, feed: Feed, msg: object) -> "StreamValue":
        """Return the value of a stream. Raises WireError."""
        return self.set_up.stream(feed, msg)

    def services(self, robot: str) -> Iterable[tuple[str, str, str]]:
        """Return key, name and type of each service, pauses first. Those of actions are in no list."""
        return self.pauses.services(robot)

    def publications(self, robot: str) -> Iterable[tuple[str, str]]:
        """Return the topic of a lock, if pauses use one."""
        return self.pauses.publications(robot)

    def outgoing(
        self, command: commands.Command, command_id: int, robot: Robot, unique: str = ""
    ) -> Sequence[Outgoing]:
        """Return the calls and messages of a command, in the order of sending. Raises CommandError for one
        that must not be sent; empty for one that this console carries out itself."""
        match command:
            case commands.PlaceOrder(_, stops):
                return self._goals.order(self.names, robot, stops, unique)
            case commands.CancelOrder(_, order_id):
                return self._goals.cancel(self.names, robot, order_id)
            case commands.ClearOrders():
                return self._goals.cancel_own(self.names, robot)
            case commands.PauseRobot():
                if switch := self.pauses.switch("pause", robot.name):
                    return switch
                # Only for a key: what this console repeats by itself has no id.
                is_due = command_id != 0 and self.pauses.may_lock and robot.moves_on_since_pause
                lock = [self.pauses.lock(robot.name, True)] if is_due else []
                return [*lock, *self._goals.cancel_all(self.names, robot)]
            case commands.ResumeRobot():
                if robot.locked_by_us and self.pauses.may_lock:
                    return [self.pauses.lock(robot.name, False)]
                return self.pauses.switch("resume", robot.name)
            case SetUpCommand():
                return self.set_up.outgoing(command, robot)
            case _:
                assert_never(command)

    def learned(
        self, call: ServiceCall, values: object, robot: Robot, sent_at: float, at: float
    ) -> Iterable[events.Event]:
        """Return nothing: topics report everything."""
        return ()

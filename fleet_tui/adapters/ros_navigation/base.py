"""The part of an adapter that both navigation stacks have in common."""

from collections.abc import Iterable, Mapping

import msgspec

from fleet_tui.adapters.adapter import Feed, ServiceCall, Site
from fleet_tui.adapters.profile import Profile
from fleet_tui.adapters.ros.facts import read_map
from fleet_tui.adapters.ros.names import Names, Vocabulary
from fleet_tui.adapters.ros_navigation.kinds import READERS
from fleet_tui.adapters.ros_navigation.pauses import Pauses, PauseSettings
from fleet_tui.adapters.ros_navigation.reading import Read
from fleet_tui.model import events
from fleet_tui.model.robot import Robot


class NavigationAdapter:
    """Names, pauses and readers of robots that drive one goal at a time."""

    def __init__(
        self, kind: str, vocabulary: Vocabulary, profile: Profile, site: Site, settings: type[PauseSettings]
    ) -> None:
        """`kind` is the name of the profile's table of `settings`."""
        self.names = Names(vocabulary, profile, site.table)
        self.site = site
        self.pauses = Pauses(self.names, msgspec.convert(profile.settings.get(kind, {}), settings))
        self.readers: Mapping[str, Read] = {key: make(self.names) for key, make in READERS.items()}
        self._read_map = read_map(self.names)

    def read(self, feed: Feed, msg: object, at: float) -> Iterable[events.Event]:
        """Return the facts that a message tells. Raises WireError."""
        if feed.key == "map":
            return (self._read_map(feed.robot, feed.floor, msg, at),)
        return self.readers[feed.key](feed.robot, msg, at)

    def services(self, robot: str) -> Iterable[tuple[str, str, str]]:
        """Return key, name and type of each service, pauses first. Those of actions are in no list."""
        return self.pauses.services(robot)

    def publications(self, robot: str) -> Iterable[tuple[str, str]]:
        """Return the topic of a lock, if pauses go over one."""
        return self.pauses.publications(robot)

    def learned(
        self, call: ServiceCall, values: object, robot: Robot, sent_at: float, at: float
    ) -> Iterable[events.Event]:
        """Return nothing: topics tell everything."""
        return ()

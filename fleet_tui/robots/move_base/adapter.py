"""The adapter of robots with move_base."""

from collections.abc import Iterable, Sequence

import msgspec

from fleet_tui.model import commands
from fleet_tui.model.set_up.commands import StoreMap
from fleet_tui.robots.adapter import Feed, Site
from fleet_tui.robots.move_base import reading
from fleet_tui.robots.move_base.goals import cancel, cancel_all, cancel_own, order
from fleet_tui.robots.move_base.probes import probes
from fleet_tui.robots.move_base.settings import MoveBaseSettings
from fleet_tui.robots.move_base.vocabulary import VOCABULARY
from fleet_tui.robots.probes import Probe
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.ros.set_up.saving import judge_saved
from fleet_tui.robots.ros_navigation import feeds
from fleet_tui.robots.ros_navigation.base import GoalMessages, NavigationAdapter
from fleet_tui.robots.ros_navigation.kinds import kind_of_goals
from fleet_tui.robots.service_outcome import judge
from fleet_tui.text.language import Message

GOALS = GoalMessages(order, cancel, cancel_own, cancel_all)


class MoveBase(NavigationAdapter):
    """Robots that drive one goal at a time, which is published; they list the state of each."""

    def __init__(self, profile: Profile, site: Site) -> None:
        super().__init__("move_base", VOCABULARY, profile, site, MoveBaseSettings, GOALS)
        self.readers = {
            **self.readers,
            "status": reading.read_status(self.names),
            "target": reading.read_target(self.names),
            "feedback": reading.read_feedback(self.names),
        }
        kind = kind_of_goals("move_base", self.names, self.pauses, self.set_up, ("map", "queue"), {})
        self.kind = msgspec.structs.replace(kind, gives_stops=True)

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        """Return the topics to subscribe to, the most urgent first."""
        names, site = self.names, self.site
        slow = Feed("", (robot,), "", "", "", site.status_ms)
        yield from feeds.feed(names, robot, slow, "status")
        yield from feeds.feed(names, robot, slow._replace(rate_ms=0, silent=True), "target")
        yield from feeds.places(names, site, robot)
        yield from feeds.feed(names, robot, slow._replace(silent=True, action=reading.ACTION), "feedback")
        yield from feeds.battery(names, site, robot)
        yield from feeds.surroundings(names, robot, floors)
        yield from self.set_up.feeds(robot)

    def publications(self, robot: str) -> Iterable[tuple[str, str]]:
        """Return name and type of the topics of goals, of cancellations and of a lock."""
        for key in ("goal", "cancel"):
            if topic := self.names.topic(key, robot):
                yield topic, self.names.type(key)
        yield from super().publications(robot)

    def probes(self, robot: str) -> Iterable[Probe]:
        """Return the checks of whether such a robot can be driven."""
        yield from probes(self.names, robot)
        yield from self.set_up.probes(robot)

    def outcome(
        self, command: commands.Command, values: object, result: bool, status: int | None = None
    ) -> tuple[commands.Stage, Message]:
        """Return the stage for the answer of a pause or resume service; all other commands have no answer."""
        if isinstance(command, StoreMap) and result and (end := judge_saved(self.names, command, values)):
            return end
        return judge(command, values, result, ())


ADAPTER = MoveBase

"""A kind of robots made up: as those of the simulator, without cargo, obstacles and pauses."""

from collections.abc import Callable, Iterable, Sequence

import msgspec
import pytest

from fleet_tui.config.entries import RobotEntry
from fleet_tui.config.schema import Config
from fleet_tui.model.kind import CANCEL, ORDER, ORDER_TO
from fleet_tui.robots.adapter import Adapter, Feed, Site
from fleet_tui.robots.oh_ressources.adapter import OhRessources
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import KINDS, Registered
from tests.support.watched_store import config_of

PLAIN = "plain"
NEVER = ("cargo", "obstacle", "paused")


class Plain(OhRessources):
    """Drives where it is sent, and can't be paused."""

    def __init__(self, profile: Profile, site: Site) -> None:
        super().__init__(profile, site)
        reports = tuple(value for value in self.kind.reports if value not in NEVER)
        accepts = (ORDER, ORDER_TO, CANCEL)
        self.kind = msgspec.structs.replace(self.kind, name=PLAIN, reports=reports, accepts=accepts)

    def feeds(self, robot: str, floors: Sequence[str]) -> Iterable[Feed]:
        return (feed for feed in super().feeds(robot, floors) if feed.key not in NEVER)


class MadeUp(Registered):
    """The source's kind, but for its adapter."""

    @property
    def adapter(self) -> Callable[[Profile, Site], Adapter]:
        return Plain


def mixed(patch: pytest.MonkeyPatch, url: str, *plain: int, robots: int = 2) -> Config:
    """A config in which the robots of these numbers, from 0, are of that kind."""
    patch.setitem(KINDS, PLAIN, MadeUp("oh_ressources"))
    entries = [RobotEntry(f"robot_{n}", profile=PLAIN if n in plain else "") for n in range(robots)]
    return msgspec.structs.replace(config_of(url, robots), robots=entries)

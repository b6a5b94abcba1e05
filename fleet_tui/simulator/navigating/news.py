"""The topics on which robots that navigate speak only on change."""

import time
from collections.abc import Callable, Iterable, Iterator
from itertools import count
from typing import Generic

from fleet_tui.simulator.frames import Payload
from fleet_tui.simulator.messages import Topic, raw_payload
from fleet_tui.simulator.navigating import messages
from fleet_tui.simulator.navigating.poses import FRAME
from fleet_tui.simulator.navigating.robot import NavigatingRobot
from fleet_tui.simulator.navigating.world import N, NavigatingWorld
from fleet_tui.simulator.ros.dialect import Dialect

AMCL = "geometry_msgs/PoseWithCovarianceStamped"


class News(Generic[N]):
    """Topics on change: places, everything that `of` adds, and the newest messages for late subscribers."""

    def __init__(self, world: NavigatingWorld[N]) -> None:
        self._world = world
        self._newest: dict[str, Payload] = {}
        self._held: dict[str, dict[str, Payload]] = {name: {} for name in world.robots}
        self._said = {name: count(1) for name in world.robots}

    def topics(self, dialect: Dialect) -> Iterator[Topic]:
        """Return the place of each robot."""
        for name in self._world.robots:
            yield self.topic(name, "amcl_pose", dialect.message_type(AMCL))

    def take(self, dialect: Dialect) -> Iterator[tuple[str, Payload]]:
        """Return all changes since the last call; for a silent robot the newest is kept until it is no longer
        silent."""
        now = time.time()
        for name, navigation in self._world.navigation.items():
            news = [
                *self._place(name, navigation.robot, dialect, now),
                *self.of(name, navigation, dialect, now),
            ]
            self._newest.update(news)
            if navigation.robot.silence:
                self._held[name].update(news)
            else:
                yield from self._held[name].items()
                self._held[name].clear()
                yield from news

    def of(self, name: str, navigation: N, dialect: Dialect, now: float) -> Iterable[tuple[str, Payload]]:
        """Return the other changes of one robot."""
        return ()

    def topic(
        self, robot: str, name: str, type_: str, latched: bool = True, alive: Callable[[], bool] | None = None
    ) -> Topic:
        """A topic of one robot; a latched value exists while its publisher is `alive`."""
        name = f"/{robot}/{name}"

        def newest() -> Iterable[Payload]:
            payload, gone = self._newest.get(name), alive is not None and not alive()
            return () if payload is None or gone or self._world.robots[robot].silence else (payload,)

        return Topic(name, type_, lambda _now: Payload({}), latched=latched, history=newest)

    def _place(
        self, name: str, robot: NavigatingRobot, dialect: Dialect, now: float
    ) -> Iterator[tuple[str, Payload]]:
        amcl = f"/{name}/amcl_pose"
        if robot.localise() or (amcl not in self._newest and not robot.is_lost_at_start):
            header = dialect.header(next(self._said[name]), now, FRAME)
            value = messages.localisation(robot.estimate, robot.variance, dialect, header)
            yield amcl, raw_payload(dialect, AMCL, now, value)

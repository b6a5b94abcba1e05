"""Robots whose topics are due to be subscribed again, because they have been silent for long."""

import random
from collections.abc import Collection, Mapping, Set

# A bridge behind which roscore was restarted stays silent until subscribed again. A robot that is only
# switched off is subscribed again repeatedly, at doubling intervals. Seconds; a real bridge takes
# 20 ms for each topic, and has not finished before that.
FIRST_RENEWAL = 8.0
PER_TOPIC = 0.03
LONGEST_INTERVAL = 64.0
# The bridge subscribes in ROS again only when no client holds the topic. Consoles notice a silence at about
# the same time, and unsubscribe for a quarter of the time they waited, up to this many seconds: together.
LONGEST_RELEASE = 8.0


class Renewals:
    """When each of some robots with a number of topics is subscribed again. Times are monotonic seconds."""

    def __init__(self, robots: Collection[str], topics: int) -> None:
        self._robots = robots
        self._first = FIRST_RENEWAL + PER_TOPIC * topics
        self._subscribed_at: dict[str, float] = {}
        self._patience: dict[str, float] = {}

    def start(self, now: float) -> None:
        """Begin to wait: all robots are being subscribed."""
        self._patience.clear()
        self._subscribed_at = dict.fromkeys(self._robots, now)

    def due(self, now: float, last_message: Mapping[str, float]) -> tuple[Set[str], float]:
        """Return the robots to subscribe again, and for how many seconds to unsubscribe them before;
        `last_message` is by robot."""
        silent = {
            robot for robot in self._robots if self._is_silent(robot, now, last_message.get(robot, 0.0))
        }
        if not silent:
            return silent, 0.0
        release_time = min(LONGEST_RELEASE, max(map(self._interval, silent)) / 4)
        for robot in silent:
            self._subscribed_at[robot] = now
            # A random delay brings consoles together that did not start to wait together.
            self._patience[robot] = min(LONGEST_INTERVAL, self._interval(robot) * random.uniform(1.8, 2.2))
        return silent, release_time

    def _interval(self, robot: str) -> float:
        return self._patience.get(robot, self._first)

    def _is_silent(self, robot: str, now: float, last_message: float) -> bool:
        subscribed_at = self._subscribed_at[robot]
        if last_message > subscribed_at:
            self._patience.pop(robot, None)
        return now - max(last_message, subscribed_at) > self._interval(robot)

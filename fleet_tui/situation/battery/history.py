"""The battery levels that this console saw, by robot: at most a day of them, with gaps where it saw none."""

import math
from collections import deque
from collections.abc import Sequence
from itertools import pairwise

from msgspec import Struct

from fleet_tui.model.fleet import FleetState

EVERY = 60.0
"""Seconds after which an unchanged level is kept again."""
STEP = 1.0
"""Per cent of a change that is kept at once."""
KEPT_FOR = 24 * 3600.0
KEPT = 4000
"""Most samples of a robot: one a minute for a day, and the changes."""
LOOK_EVERY = 1.0
UNSEEN = 90.0
"""Seconds without a look, of a console that was suspended or a recording that jumped, that are a gap."""


class BatterySample(Struct, frozen=True, gc=False):
    """A level in per cent at a monotonic second. `follows`: the levels since the sample before were seen."""

    at: float
    percent: float
    follows: bool


class BatteryHistory:
    """The samples of one robot, oldest first."""

    def __init__(self) -> None:
        self.samples: deque[BatterySample] = deque(maxlen=KEPT)
        self._seen_at = -math.inf
        self._level = 0.0

    def look(self, at: float, percent: float | None) -> None:
        """Take the level at a monotonic second, None while it is unknown. A recording may go back in time:
        what was later is dropped."""
        while self.samples and self.samples[-1].at > at:
            self._seen_at = self.samples.pop().at
        if self._seen_at > at:
            self._seen_at = self.samples[-1].at if self.samples else -math.inf
        while self.samples and self.samples[0].at < at - KEPT_FOR:
            self.samples.popleft()
        follows = percent is not None and bool(self.samples) and at - self._seen_at <= UNSEEN
        if not follows:
            self.samples.extend(self.levels[len(self.samples) :])  # the run goes on to what was last seen
        if percent is None:
            self._seen_at = -math.inf
            return
        self._seen_at = at
        self._level = percent
        if not follows or self._is_news(at, percent):
            self.samples.append(BatterySample(at, percent, follows))

    @property
    def levels(self) -> Sequence[BatterySample]:
        """Return the samples, and the newest level if it is younger."""
        at, percent = self._seen_at, self._level
        is_younger = bool(self.samples) and at > self.samples[-1].at
        return (*self.samples, *([BatterySample(at, percent, True)] if is_younger else []))

    def _is_news(self, at: float, percent: float) -> bool:
        last = self.samples[-1]
        return at - last.at >= EVERY or abs(percent - last.percent) >= STEP


class BatteryHistories:
    """The histories of all robots, from the states that this console shows."""

    def __init__(self) -> None:
        self._by_robot: dict[str, BatteryHistory] = {}
        self._looked_at = -math.inf

    def look(self, state: FleetState) -> None:
        """Take the fresh levels of a state, once a second."""
        if 0.0 <= state.now - self._looked_at < LOOK_EVERY:
            return
        self._looked_at = state.now
        for robot in state.robots.values():
            if robot.battery is not None:
                level = robot.battery.value if state.is_fresh(robot, "battery") else None
                self._by_robot.setdefault(robot.name, BatteryHistory()).look(state.now, level)

    def of(self, robot: str) -> Sequence[BatterySample]:
        """Return the samples of a robot, oldest first."""
        history = self._by_robot.get(robot)
        return history.levels if history is not None else ()


def runs_of(samples: Sequence[BatterySample]) -> list[list[BatterySample]]:
    """Return the samples in runs without a gap."""
    runs = [list(samples[:1])] if samples else []
    for _, sample in pairwise(samples):
        if sample.follows:
            runs[-1].append(sample)
        else:
            runs.append([sample])
    return runs

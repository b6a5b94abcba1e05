"""The line above a picture of a camera, and the text in the place of a missing one."""

import math
from typing import NamedTuple

from fleet_tui.text.language import EMPTY, Message, tr, translate
from fleet_tui.text.sanitize import cell_width, fit, sanitize
from fleet_tui.text.units import age

OLD = 2.0
GONE = 10.0
"""Seconds after which a picture is marked as old, and is not shown any more."""


EVERY = 0.5
SLOWEST = 8.0
"""Seconds between two pictures, and at the most."""
EARLY = 0.2
"""Part of that time by which a picture may come sooner: networks jitter."""


class CameraFacts(NamedTuple):
    """The facts of a camera. `size` in pixels, (0, 0) before the first picture; `seconds` since it was
    taken, None before the first; `problem`: the reason that there is none; `rate` in words."""

    robot: str
    size: tuple[int, int] = (0, 0)
    seconds: float | None = None
    rate: str = ""
    problem: Message = EMPTY


def caption(facts: CameraFacts, width: int) -> tuple[str, bool]:
    """Return robot, age, rate and size, as many of them as fit into `width` cells, and whether that is a
    warning."""
    parts = [fit(tr("Camera {robot}", robot=sanitize(facts.robot)), width).rstrip()]
    is_old = facts.seconds is not None and facts.seconds > OLD
    if facts.seconds is not None:
        parts += [tr("old: {age}", age=age(facts.seconds)) if is_old else age(facts.seconds), facts.rate]
    if facts.size != (0, 0):
        parts.append(f"{facts.size[0]}x{facts.size[1]}")
    while len(parts) > 1 and cell_width("  ".join(parts)) > width:
        parts.pop()
    return "  ".join(parts), is_old or bool(facts.problem)


def note(facts: CameraFacts) -> str:
    """Return the text in the place of the picture, empty if it is shown."""
    if facts.problem:
        return (
            facts.problem
            if facts.problem.startswith("no ")
            else tr("no picture: {problem}", problem=translate(facts.problem))
        )
    if facts.seconds is None:
        return tr("waiting for the first picture")
    return tr("no picture for {age}", age=age(facts.seconds)) if facts.seconds > GONE else ""


class PictureRate:
    """Times are monotonic seconds, sizes bytes."""

    def __init__(self, limit: float) -> None:
        """`limit`: bytes a second."""
        self._limit = limit
        self.restart()

    def restart(self) -> None:
        """Forget earlier pictures, and their costs."""
        self.every = EVERY
        self._at = -math.inf
        self._sent = 0

    @property
    def text(self) -> str:
        """Return the rate in words, with the limit that halved it."""
        halved = tr(" (limit {limit} kB/s)", limit=f"{self._limit / 1000:g}") if self.every > EVERY else ""
        return tr("{rate} fps{halved}", rate=f"{1 / self.every:g}", halved=halved)

    def is_due(self, at: float) -> bool:
        """Tell whether another picture may be shown."""
        return at - self._at >= self.every * (1 - EARLY)

    def take(self, at: float, sent: int) -> None:
        """Take the time at which a picture is shown, and the bytes ever sent to the terminal by then: those
        since the last picture are its cost."""
        if self._at > -math.inf:
            cost = (sent - self._sent) / max(at - self._at, 0.001)
            if cost > self._limit:
                self.every = min(2 * self.every, SLOWEST)
            elif self.every > EVERY and 2 * cost < 0.8 * self._limit:
                self.every /= 2
        self._at = at
        self._sent = sent

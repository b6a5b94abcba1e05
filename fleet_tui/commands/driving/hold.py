"""The hand on the keys. Terminals tell no release, only repeats: a key counts as released when they cease."""

import math
from collections.abc import Mapping

from msgspec import Struct
from msgspec.structs import replace

from fleet_tui.model.set_up.driving import Axis

TAP = 0.3
"""Seconds for which one press drives."""
HELD_WITHIN = 0.8
PRESSES = 3
"""The number of presses within a number of seconds that tells a held key."""
RELEASED_AFTER = 0.25
"""Seconds after its last repeat until a held key counts as released."""
BURST = 0.005
"""Seconds between two presses below which they come from a terminal that stalled."""

DIRECTIONS: Mapping[str, tuple[Axis, int]] = {
    "w": (Axis.AHEAD, 1),
    "s": (Axis.AHEAD, -1),
    "a": (Axis.TURNING, 1),
    "d": (Axis.TURNING, -1),
    "q": (Axis.SIDEWAYS, 1),
    "e": (Axis.SIDEWAYS, -1),
}
"""Axis and sign of each direction: ahead, left and counter-clockwise are positive."""


class Hold(Struct, frozen=True):
    """A direction that drives until the monotonic second `until`; `presses` are the times of its latest
    presses."""

    key: str
    until: float
    presses: tuple[float, ...]

    @property
    def is_held(self) -> bool:
        """Tell whether the key is held, not tapped."""
        return len(self.presses) == PRESSES and self.presses[-1] - self.presses[0] <= HELD_WITHIN


class Hand(Struct, frozen=True):
    """The directions that are held, one on each axis; `seen` is the time of the latest press."""

    holds: Mapping[Axis, Hold] = {}
    seen: float = -math.inf

    def pressed(self, key: str, at: float) -> "Hand":
        """Take a press of one of DIRECTIONS at a monotonic second."""
        axis, _ = DIRECTIONS[key]
        before = self.holds.get(axis)
        if at - self.seen < BURST:
            hold = _in_burst(before, key, at, self.until)
        elif before is None or before.key != key:
            hold = Hold(key, at + TAP, (at,))
        else:
            hold = Hold(key, 0.0, (*before.presses, at)[-PRESSES:])
            hold = replace(hold, until=at + (RELEASED_AFTER if hold.is_held else TAP))
        return Hand({**self.holds, axis: hold}, max(at, self.seen))

    def released(self, key: str) -> "Hand":
        """Take the release of a direction, where the terminal tells it."""
        return Hand({axis: hold for axis, hold in self.holds.items() if hold.key != key}, self.seen)

    def signs(self, at: float) -> Mapping[Axis, int]:
        """Return the direction on each axis that drives at a monotonic second."""
        return {axis: DIRECTIONS[hold.key][1] for axis, hold in self.holds.items() if at < hold.until}

    @property
    def until(self) -> float:
        """Return the monotonic second from which no key drives."""
        return max((hold.until for hold in self.holds.values()), default=0.0)


def _in_burst(before: Hold | None, key: str, at: float, until: float) -> Hold:
    """Return the hold after a press right behind another one. It prolongs nothing: two keys may be pressed at
    once, repeats of a held key may arrive together, and all else is what a terminal kept while it stalled."""
    if before is None:
        return Hold(key, min(at + TAP, until), (at,))
    if before.key == key and before.is_held:
        return before
    return Hold(key, at, ())

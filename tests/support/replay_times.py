"""Times of a replay."""

import time

from tests.support.fleets import WALL


def clock(second: float) -> str:
    """The wall clock of a recorded second, as everywhere on the screen."""
    return time.strftime("%H:%M:%S", time.localtime(WALL + second))


def at(second: float) -> str:
    return f"REPLAY {time.strftime('%Y-%m-%d', time.localtime(WALL + second))} {clock(second)}"

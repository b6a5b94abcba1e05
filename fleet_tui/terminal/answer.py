"""The answer to a key: its picture comes before the messages and the tick that nobody waits for."""

import math
import time
from collections.abc import Callable
from functools import partial

from textual.app import App

from fleet_tui.transports.loop import end_turn, give_turn

WITHIN = 0.03
"""Seconds after a key in which a picture is its answer; some keys have none."""


class KeyAnswer:
    """Puts off what would delay the next picture after a key."""

    def __init__(self) -> None:
        self._until = -math.inf

    def asked(self) -> None:
        """Have everything else wait: a key has come."""
        self._until = time.monotonic() + WITHIN
        give_turn()

    def shown(self) -> None:
        """Note that a picture is sent."""
        self._until = -math.inf

    def then(self, app: App[None], tick: Callable[[], None]) -> None:
        """Call a tick now, or once after the answer that is still to come."""
        if time.monotonic() < self._until:
            app.set_timer(WITHIN, partial(_alone, tick))
        else:
            _alone(tick)


def _alone(tick: Callable[[], None]) -> None:
    """Call a tick while messages wait: a key that comes now waits for both."""
    give_turn()
    try:
        tick()
    finally:
        end_turn()

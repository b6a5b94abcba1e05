"""The one writer: applies the network loop's events to the store, and a clock tick ten times a second."""

import asyncio
import logging
import sys
import time
from collections.abc import Callable

from fleet_tui.links import memory
from fleet_tui.links.tap import Tap
from fleet_tui.links.transports.loop import network_loop
from fleet_tui.model.events import Event, TimePassed
from fleet_tui.state.store import Store

LOG = logging.getLogger(__name__)

TICK = 0.1
TIDY_EVERY = 60.0
STALL = 1.0
CATCHES_UP = 3.0
"""Seconds without a tick from which the process was stopped, suspended or starved, and for which it then
catches up at most."""
# Python lets a busy thread run 5 ms before another gets its turn: too long for a command to wait
# while the screen is drawn.
SWITCH_INTERVAL = 0.0005


class Writer:
    """Owns the thread in which the state changes. It also exists without a link."""

    def __init__(self, store: Store, tap: Tap | None = None) -> None:
        self.store = store
        self.tap = tap
        self.loop = network_loop()
        self.before_tick: list[Callable[[float], None]] = []
        self.backlogs: list[Callable[[float], float]] = []
        """Functions that return the seconds for which the oldest message of a connection has waited to be
        read."""
        self._ticker: asyncio.Future[None] | None = None
        self._tidied = time.monotonic()
        self._tidy = memory.freeze
        self._stall = 0.0
        self._stalled_until = 0.0

    def start(self) -> None:
        """Start the clock ticks."""
        memory.tune_malloc()
        sys.setswitchinterval(SWITCH_INTERVAL)
        self.loop.call_soon_threadsafe(self._start)

    def _start(self) -> None:
        self._ticker = asyncio.ensure_future(self._tick())

    async def _tick(self) -> None:
        due = time.monotonic()
        while True:
            now = time.monotonic()
            late = now - due
            due = now + TICK  # not after the work of this tick: the process may be stopped in it
            try:
                for look in self.before_tick:
                    look(now)
                behind = max([self._stalled(now, late), *(age(now) for age in self.backlogs)])
                self.apply(TimePassed(now, time.time(), behind if behind > TICK else 0.0))
                if now - self._tidied > TIDY_EVERY:
                    self._tidied = now
                    self._tidy()
                    self._tidy = memory.collect
            except Exception:
                # Without ticks nothing would age: one that fails must not be the last.
                LOG.exception("tick")
            await asyncio.sleep(TICK)

    def _stalled(self, now: float, late: float) -> float:
        """Return the seconds for which the loop did not run, also for a while after: what arrived meanwhile
        is read first, and nothing of it counts as missing."""
        if late >= STALL:
            self._stall = late
            self._stalled_until = now + min(late, CATCHES_UP)
        return max(late, self._stall) if now < self._stalled_until else late

    def apply(self, event: Event) -> None:
        """Apply an event without a frame. On the loop."""
        if self.tap is not None:
            self.tap.on_event(event)
        self.store.apply(event)

    def post(self, event: Event) -> None:
        """Apply an event without a frame. From any thread."""
        self.loop.call_soon_threadsafe(self.apply, event)

    def stop(self) -> None:
        """Stop the clock ticks."""
        if self._ticker is not None:
            self.loop.call_soon_threadsafe(self._ticker.cancel)

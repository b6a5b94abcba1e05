"""The one writer: the network loop tells the store, and ten times a second that time passed."""

import asyncio
import logging
import sys
import time
from collections.abc import Callable

from fleet_tui.link.transport import network_loop
from fleet_tui.model.events import Event, TimePassed
from fleet_tui.store import Store

LOG = logging.getLogger(__name__)

TICK = 0.1
# Python lets a busy thread run 5 ms before another gets its turn: too long for a command to wait
# while the screen is drawn.
SWITCH_INTERVAL = 0.0005


class Writer:
    """Owns the thread in which the state changes. It exists without a link, too."""

    def __init__(self, store: Store) -> None:
        self.store = store
        self.loop = network_loop()
        self.before_tick: list[Callable[[float], None]] = []
        self._ticker: asyncio.Future[None] | None = None

    def start(self) -> None:
        """Begin to tell the time."""
        sys.setswitchinterval(SWITCH_INTERVAL)
        self.loop.call_soon_threadsafe(self._start)

    def _start(self) -> None:
        self._ticker = asyncio.ensure_future(self._tick())

    async def _tick(self) -> None:
        while True:
            try:
                now = time.monotonic()
                for look in self.before_tick:
                    look(now)
                self.store.tell(TimePassed(now, time.time()))
            except Exception:
                # Without the time nothing would age: one bad tick must not be the last.
                LOG.exception("tick")
            await asyncio.sleep(TICK)

    def tell(self, event: Event) -> None:
        """Tell the store, from any thread."""
        self.loop.call_soon_threadsafe(self.store.tell, event)

    def stop(self) -> None:
        """Stop telling the time."""
        if self._ticker is not None:
            self.loop.call_soon_threadsafe(self._ticker.cancel)

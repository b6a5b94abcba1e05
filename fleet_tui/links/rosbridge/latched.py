"""Latched topics behind a bridge of ROS 2: the QoS that delivers each of them, found topic by topic.

Such a bridge fixes the QoS of a topic when its first client subscribes. A subscription before the publisher
is discovered makes it volatile for all clients, and the latched value never arrives: so `qos` is requested. A
volatile publisher never delivers to a subscription with `qos`, and then to no client: so it is dropped if
nothing arrives. A topic that is sent only on a change then stays without: both kinds of publishers deliver
what they send from now on.
"""

import asyncio
from collections.abc import Callable, Iterable

from fleet_tui.links.rosbridge.calls import Calls
from fleet_tui.links.rosbridge.rosapi import publishers
from fleet_tui.robots.adapter import Feed
from fleet_tui.robots.ros.reading import FrameReader

FIRST_PATIENCE = 2.0
LONGEST_PATIENCE = 64.0
"""Seconds without a value after which the other QoS is tried; doubled each time."""
LET_GO = 0.5
"""Seconds without any subscriber after which the bridge chooses the QoS of a topic again."""


class Latched:
    """Runs on the network loop. `wanted` returns the latched topics that are currently requested."""

    def __init__(
        self,
        calls: Calls,
        reading: FrameReader,
        wanted: Callable[[], Iterable[Feed]],
        subscribe: Callable[[Feed], None],
        unsubscribe: Callable[[Feed], None],
    ) -> None:
        self._calls = calls
        self._reading = reading
        self._wanted = wanted
        self._subscribe = subscribe
        self._unsubscribe = unsubscribe
        self._volatile: dict[str, Feed] = {}
        """Those that are subscribed without `qos`."""
        self._counts: dict[str, int] = {}
        """By topic: the number of messages received before it was subscribed last."""
        self._task: asyncio.Task[None] | None = None

    def wants_qos(self, topic: str) -> bool:
        """Tell whether to subscribe to a topic as transient local and reliable."""
        return topic not in self._volatile

    def begin(self) -> None:
        """A new connection: what is repeated came without `qos`, and will; the last value of what is sent
        only on a change comes with it alone."""
        self._volatile = {topic: one for topic, one in self._volatile.items() if not one.silent}

    def note(self, one: Feed) -> None:
        """Note that a topic is being subscribed: what comes from now on counts."""
        self._counts[one.address] = self._count(one)

    def start(self, handled_in: float) -> None:
        """Watch all topics, which the bridge has subscribed in so many seconds. A latched value arrives once,
        so topics that have one are left alone."""
        self.stop()
        self._task = asyncio.ensure_future(self._look(FIRST_PATIENCE + handled_in))

    def stop(self) -> None:
        if self._task is not None:
            self._task.cancel()

    async def _look(self, patience: float) -> None:
        while True:
            await asyncio.sleep(patience)
            unheard = [one for one in self._wanted() if self._count(one) == self._counts.get(one.address, 0)]
            if not unheard:
                return
            silent = [one for one in unheard if not one.silent or await self._is_volatile(one)]
            for one in silent:
                self._unsubscribe(one)
            try:
                await asyncio.sleep(LET_GO)
            finally:  # also if a map is opened meanwhile, which starts the watch of all of them again
                for one in silent:
                    if self._volatile.pop(one.address, None) is None:
                        self._volatile[one.address] = one
                    self._subscribe(one)
            patience = min(2 * patience, LONGEST_PATIENCE)

    async def _is_volatile(self, one: Feed) -> bool:
        """Tell whether the QoS may be why nothing comes of a topic that may as well have nothing to say."""
        return one.address not in self._volatile and await publishers(self._calls, one.address) > 0

    def _count(self, one: Feed) -> int:
        return self._reading.counter.topics[one.address].count

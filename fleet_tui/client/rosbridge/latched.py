"""Latched topics behind a bridge of ROS 2: the QoS that delivers each of them, found topic by topic.

Such a bridge fixes the QoS of a topic when its first client subscribes. A subscription before the publisher
is discovered makes it volatile for all clients, and the latched value never arrives: so `qos` is requested. A
volatile publisher never delivers to a subscription with `qos`, and then to no client: so it is dropped if
nothing arrives.
"""

import asyncio
from collections.abc import Callable, Collection, Iterable

from fleet_tui.adapters.adapter import Feed
from fleet_tui.adapters.ros.reading import FrameReader

FIRST_PATIENCE, LONGEST_PATIENCE = 2.0, 64.0
"""Seconds without a value after which the other QoS is tried; doubled each time."""
LET_GO = 0.5
"""Seconds without any subscriber after which the bridge chooses the QoS of a topic again."""


class Latched:
    """Runs on the network loop. `wanted` returns the latched topics that are currently requested."""

    def __init__(
        self,
        reading: FrameReader,
        wanted: Callable[[], Iterable[Feed]],
        subscribe: Callable[[Feed], None],
        unsubscribe: Callable[[Feed], None],
    ) -> None:
        self._reading, self._wanted = reading, wanted
        self._subscribe, self._unsubscribe = subscribe, unsubscribe
        self._volatile: set[str] = set()
        """Topics that are subscribed without `qos`, also on later connections."""
        self._counts: dict[str, int] = {}
        """By topic: the number of messages received before it was subscribed on this connection."""
        self._task: asyncio.Task[None] | None = None

    def wants_qos(self, topic: str) -> bool:
        """Tell whether to subscribe to a topic as transient local and reliable."""
        return topic not in self._volatile

    def start(self, asked: Collection[Feed], per_topic: float) -> None:
        """Watch the topics just `asked` for, besides the earlier ones. A latched value arrives once, so
        topics that have one are left alone. A bridge takes `per_topic` seconds for each subscription."""
        self.stop()
        self._counts |= {_topic(one): self._count(one) for one in asked}
        self._task = asyncio.ensure_future(self._look(FIRST_PATIENCE + per_topic * len(asked)))

    def stop(self) -> None:
        """Stop watching."""
        if self._task is not None:
            self._task.cancel()

    async def _look(self, patience: float) -> None:
        while True:
            await asyncio.sleep(patience)
            silent = [one for one in self._wanted() if self._count(one) == self._counts.get(_topic(one), 0)]
            if not silent:
                return
            for one in silent:
                self._unsubscribe(one)
            try:
                await asyncio.sleep(LET_GO)
            finally:  # also if a map is opened meanwhile, which starts the watch of all of them again
                self._volatile ^= {_topic(one) for one in silent}
                for one in silent:
                    self._subscribe(one)
            patience = min(2 * patience, LONGEST_PATIENCE)

    def _count(self, one: Feed) -> int:
        return self._reading.counter.topics[_topic(one)].count


def _topic(wanted: Feed) -> str:
    return wanted.address

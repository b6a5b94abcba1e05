"""Latched topics behind a bridge of ROS 2: which QoS delivers them, found out topic by topic.

Such a bridge fixes the QoS of a topic when its first client takes it. Whoever comes before the publisher
was discovered makes it volatile for everybody, and the latched value never comes: so `qos` is asked for.
A volatile publisher never delivers to that, and then to no client: so without it where nothing comes.
"""

import asyncio
from collections.abc import Callable, Collection, Iterable

from fleet_tui.adapters.adapter import Feed
from fleet_tui.adapters.ros.reading import FrameReader

FIRST_PATIENCE, LONGEST_PATIENCE = 2.0, 64.0
"""Seconds without a value after which the other way is tried; each time it is twice as long."""
LET_GO = 0.5
"""Seconds for which nobody must hold a topic for the bridge to choose its QoS again."""


class Latched:
    """Runs on the network loop. `wanted` gives the latched topics that are asked for now."""

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
        """Topics that are asked for without `qos`. What worked stays, on later connections too."""
        self._counts: dict[str, int] = {}
        """By topic: how many messages had come when it was asked for on this connection."""
        self._task: asyncio.Task[None] | None = None

    def wants_qos(self, topic: str) -> bool:
        """Tell whether a topic is to be asked for as transient local and reliable."""
        return topic not in self._volatile

    def start(self, asked: Collection[Feed], per_topic: float) -> None:
        """Look after what was just `asked` for, beside what was before: a latched value comes once, so what
        has come is left alone. A bridge takes `per_topic` seconds for each subscription."""
        self.stop()
        self._counts |= {_topic(one): self._count(one) for one in asked}
        self._task = asyncio.ensure_future(self._look(FIRST_PATIENCE + per_topic * len(asked)))

    def stop(self) -> None:
        """Look no more."""
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
            finally:  # also where a map is shown meanwhile, which looks after all of them anew
                self._volatile ^= {_topic(one) for one in silent}
                for one in silent:
                    self._subscribe(one)
            patience = min(2 * patience, LONGEST_PATIENCE)

    def _count(self, one: Feed) -> int:
        return self._reading.counter.topics[_topic(one)].count


def _topic(wanted: Feed) -> str:
    return wanted.address

"""Looks for messages that the bridge was started without, some seconds after it was asked for topics."""

import asyncio
import logging
from collections.abc import Callable, Iterable

from fleet_tui.errors import LinkError
from fleet_tui.link.calls import Calls
from fleet_tui.link.reading import Reading
from fleet_tui.link.subscriptions import Wanted
from fleet_tui.model.events import MessagesUnsourced
from fleet_tui.model.sourcing import ALWAYS_THERE, Listening, unsourced_package

LOG = logging.getLogger(__name__)

LOOK_AFTER = 8.0
"""Seconds after which a topic that somebody publishes should have come."""
AGAIN = 2.0
"""Seconds between looks whether a package that is lacking, as it seems, has been heard of after all."""
ROSAPI_TIMEOUT = 2.0
MOST_ASKED = 20
"""Topics whose publishers are asked for: the package is the same for all."""


class Sourcing:
    """Runs on the network loop."""

    def __init__(
        self,
        link: str,
        calls: Calls,
        wanted: Iterable[Wanted],
        reading: Reading,
        tell: Callable[[MessagesUnsourced], None],
    ) -> None:
        self._link, self._calls, self._reading, self._tell = link, calls, reading, tell
        self._wanted = [one for one in wanted if not one.kind.heavy]
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Look once on this connection: what a bridge lacks it lacks until it is restarted. A package that
        was only slow is heard of later."""
        self.stop()
        self._task = asyncio.ensure_future(self._look())

    def stop(self) -> None:
        """Look no more."""
        if self._task is not None:
            self._task.cancel()

    async def _look(self) -> None:
        before = {one.subscription.topic: self._count(one) for one in self._wanted}
        await asyncio.sleep(LOOK_AFTER)
        silent = [one for one in self._wanted if self._count(one) == before[one.subscription.topic]]
        suspects = [one for one in silent if _package(one) not in ALWAYS_THERE]
        publishers = {one.subscription.topic: await self._publishers(one) for one in suspects[:MOST_ASKED]}
        listening = [
            Listening(
                one.robot,
                one.subscription.type,
                0 if one in suspects[MOST_ASKED:] else publishers.get(one.subscription.topic),
                one not in silent,
            )
            for one in self._wanted
        ]
        package = unsourced_package(listening) or ""
        self._tell(MessagesUnsourced(self._link, package))
        lacking = [one for one in silent if _package(one) == package]
        while lacking:
            await asyncio.sleep(AGAIN)
            if any(self._count(one) != before[one.subscription.topic] for one in lacking):
                self._tell(MessagesUnsourced(self._link, ""))
                return

    def _count(self, one: Wanted) -> int:
        return self._reading.counter.topics[one.subscription.topic].count

    async def _publishers(self, one: Wanted) -> int:
        """How many nodes publish a topic, 0 where nobody tells."""
        args = {"topic": one.subscription.topic}
        try:
            response = await self._calls.call("/rosapi/publishers", args, ROSAPI_TIMEOUT)
        except LinkError as problem:
            LOG.info("publishers are not looked up: %s", problem)
            return 0
        nodes = response.values.get("publishers") if isinstance(response.values, dict) else None
        return len(nodes) if response.result and isinstance(nodes, list) else 0


def _package(wanted: Wanted) -> str:
    return wanted.subscription.type.partition("/")[0]

"""Detects message packages missing from the bridge's environment, some seconds after subscribing."""

import asyncio
from collections.abc import Callable, Iterable, Mapping

from fleet_tui.links.rosbridge.calls import Calls
from fleet_tui.links.rosbridge.rosapi import publishers
from fleet_tui.model.events import MessagesUnsourced
from fleet_tui.robots.adapter import Feed
from fleet_tui.robots.ros.reading import FrameReader
from fleet_tui.situation.missing_packages import ALWAYS_THERE, Listening, unsourced_package

LOOK_AFTER = 4.0
FOR_EACH_TOPIC = 0.03
"""Seconds after which a published topic should have delivered: a bridge subscribes one by one."""
RETRY_AFTER = 2.0
"""Seconds between checks whether a package that seemed missing delivers after all."""
MOST_ASKED = 20
"""Number of topics whose publishers are queried: the package is the same for all."""


class Sourcing:
    """Runs on the network loop."""

    def __init__(
        self,
        link: str,
        calls: Calls,
        wanted: Iterable[Feed],
        reading: FrameReader,
        types: Callable[[], Mapping[str, str]],
        report: Callable[[MessagesUnsourced], None],
    ) -> None:
        """`types` returns the type of each topic as the bridge spells it."""
        self._link = link
        self._calls = calls
        self._reading = reading
        self._report = report
        self._types = types
        # On a topic published only on change, silence proves nothing.
        self._wanted = [one for one in wanted if not (one.large or one.silent)]
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Check once on this connection: a missing package stays missing until the bridge restarts. A package
        that was only slow delivers later."""
        self.stop()
        self._task = asyncio.ensure_future(self._look())

    def stop(self) -> None:
        if self._task is not None:
            self._task.cancel()

    async def _look(self) -> None:
        before = {one.address: self._count(one) for one in self._wanted}
        await asyncio.sleep(LOOK_AFTER + FOR_EACH_TOPIC * len(before))
        silent = [one for one in self._wanted if self._count(one) == before[one.address]]
        suspects = [one for one in silent if self._type(one).partition("/")[0] not in ALWAYS_THERE]
        numbers = {one.address: await publishers(self._calls, one.address) for one in suspects[:MOST_ASKED]}
        listening = [
            Listening(
                one.robot,
                self._type(one),
                0 if one in suspects[MOST_ASKED:] else numbers.get(one.address),
                one not in silent,
            )
            for one in self._wanted
        ]
        package = unsourced_package(listening) or ""
        self._report(MessagesUnsourced(self._link, package))
        lacking = [one for one in silent if self._type(one).partition("/")[0] == package]
        while lacking:
            await asyncio.sleep(RETRY_AFTER)
            if any(self._count(one) != before[one.address] for one in lacking):
                self._report(MessagesUnsourced(self._link, ""))
                return

    def _type(self, one: Feed) -> str:
        return self._types().get(one.address, one.type)

    def _count(self, one: Feed) -> int:
        return self._reading.counter.topics[one.address].count

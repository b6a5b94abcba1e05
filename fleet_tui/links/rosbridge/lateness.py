"""How late a bridge is: questions that wait in the same queues as the messages of its robots."""

import asyncio
from collections.abc import Callable
from time import monotonic

import msgspec

from fleet_tui.links.rosbridge.calls import OWN_WORD, TIME, Calls, NoAnswerError
from fleet_tui.links.rosbridge.probes import Pulse
from fleet_tui.model.events import BridgeAnswered
from fleet_tui.robots.ros.messages import TimeAnswer
from fleet_tui.robots.ros.operations import ServiceResponse
from fleet_tui.text.errors import LinkError

EVERY = 1.0
AGAIN = 0.2
"""Seconds from an answer to the next question; from a late one, to see at once that the bridge is in time.
Behind a bridge whose robots have nothing to say, its answers are all that shows that commands get through
(`command_channel.LONGEST_SILENCE`)."""
PATIENT = 2.0
QUICK = 0.5
LONGEST = 60.0
"""Seconds for rosapi to tell the clock of the site, first and later, and for the bridge's own answer."""


class Soundings:
    """Asks over one connection, and reports each answer. Runs on the network loop."""

    def __init__(
        self,
        link: str,
        pulse: Pulse,
        calls: Calls,
        is_ready: Callable[[], bool],
        report: Callable[[BridgeAnswered], None],
    ) -> None:
        """`is_ready` tells whether the bridge has handled our own subscriptions, which delay its answers."""
        self._link = link
        self._pulse = pulse
        self._calls = calls
        self._is_ready = is_ready
        self._report = report
        self._task: asyncio.Task[None] | None = None
        self._has_time = True
        """rosapi may be frozen: then only the bridge itself is asked."""

    def start(self) -> None:
        """Start asking: the connection is open."""
        self._has_time = True
        self._pulse.restart()
        self._task = asyncio.ensure_future(self._run())

    def stop(self) -> None:
        if self._task is not None:
            self._task.cancel()

    async def _run(self) -> None:
        try:
            took = await self._measure(PATIENT)  # first of all: what arrives next has an age
            while True:
                await asyncio.sleep(AGAIN if took > QUICK else EVERY)
                if self._is_ready():
                    took = await self._measure(QUICK)
        except LinkError:
            return  # it starts again with the next connection

    async def _measure(self, patience: float) -> float:
        """Ask once, and return the seconds until the answer. Raises LinkError without a connection."""
        if self._has_time:
            try:
                took, response = await self._ask(TIME, patience)
            except NoAnswerError:
                pass  # rosapi or the bridge: only the bridge itself tells
            else:
                stamp = _stamp(response) if took <= QUICK else None  # of a late answer it is old
                self._report(BridgeAnswered(self._link, monotonic(), took, stamp))
                return took
        found = await self._pulse.of_ros(QUICK, skip=TIME)
        try:
            took, _ = found or await self._ask(OWN_WORD, LONGEST)
        except NoAnswerError:
            took = 0.0  # it answers no calls at all, which is no lateness
        self._has_time = self._has_time and took > QUICK
        self._report(BridgeAnswered(self._link, monotonic(), took))
        return took

    async def _ask(self, service: str, within: float) -> tuple[float, ServiceResponse]:
        # The bridge gets more time: its word that it gave a call up would come sooner than a late answer.
        return await self._calls.timed(service, {}, within, kept=LONGEST)


def _stamp(response: ServiceResponse) -> float | None:
    """Return the clock of a site in seconds, None if rosapi does not tell it."""
    try:
        return msgspec.convert(response.values, TimeAnswer).time.seconds
    except msgspec.ValidationError:
        return None

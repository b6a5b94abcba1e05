"""Signs of life of a bridge's command path: a heartbeat, and every answer to a command."""

import asyncio
import time
from collections.abc import Callable, Collection

from fleet_tui.links.rosbridge.calls import OWN_WORD, Calls, NoAnswerError
from fleet_tui.links.rosbridge.probes import Pulse, is_unknown
from fleet_tui.links.rosbridge.services import Services
from fleet_tui.model.counters import RoundTrips
from fleet_tui.model.events import CommandPathChanged
from fleet_tui.model.link import HALF_DEAD, NO_REPLY, NOT_ADMITTED, UNASKED, UNPROVEN, CommandPath
from fleet_tui.robots.ros.operations import ServiceResponse
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import EMPTY, Message
from fleet_tui.text.limits import some

EVERY = 2.0
AGAIN = 0.5
"""Seconds between two beats, and after one that a node left unanswered."""
QUICK = 0.7
TIMEOUT = 5.0
"""Seconds for a node to answer, and for the bridge itself."""
LOOK_EVERY = 8
"""Beats between two checks of the services: a quick restart of the master goes unnoticed otherwise."""
HALF_DEAD_AFTER = 1.5
"""Seconds without a message on any topic after which a bridge of which no node answers is half dead."""
NO_NODE = Message(
    "ROS knows no node, not even the bridge: start rosapi, or restart the bridge and the robots' nodes"
)
"""As after a restart of the ROS master: what was connected before goes on."""


class Heartbeat:
    """Monitors whether commands would get through, and reports each change. Runs on the network loop."""

    def __init__(
        self,
        link: str,
        calls: Calls,
        services: Services,
        round_trips: RoundTrips,
        silence: Callable[[], float],
        report: Callable[[CommandPathChanged], None],
        barred: Callable[[], Collection[str]],
        asks_node: bool = True,
    ) -> None:
        """`silence` are the seconds since the last message on any topic, `barred` the services that the
        bridge is known not to allow; `asks_node` as for Pulse."""
        self._barred = barred
        self._link = link
        self._calls = calls
        self._services = services
        self._report = report
        self._pulse = Pulse(calls, asks_node)
        self._silence = silence
        self._round_trips = round_trips
        self._connected = False
        self._reported: CommandPathChanged | None = None
        self._answered_at = 0.0
        self._task: asyncio.Task[None] | None = None
        self.path = CommandPath.UNTRIED
        self.reason = EMPTY
        services.changed = self._refresh

    def _set(self, path: CommandPath, reason: Message = EMPTY) -> None:
        self.path = path
        self.reason = reason
        change = CommandPathChanged(self._link, path, reason, self._connected)
        if change != self._reported:
            self._reported = change
            self._report(change)

    def start(self) -> None:
        """Start beating: the connection is open. A pause need not wait for the first answer."""
        self._connected = True
        self._pulse.restart()
        self._set(self.path, self.reason)
        self._task = asyncio.ensure_future(self._beat())

    def stop(self, reason: Message) -> None:
        """Stop: the connection is lost."""
        self.close()
        self._connected = False
        self._set(CommandPath.DEAD, reason)

    def close(self) -> None:
        """Stop permanently."""
        if self._task is not None:
            self._task.cancel()

    def take(self, response: ServiceResponse) -> None:
        """Take an answer to any call: any answer shows that the bridge is alive, if not half dead."""
        self._answered_at = time.monotonic()
        if self.reason == HALF_DEAD and not response.result:
            return
        if self.path is CommandPath.UNTRIED and is_unknown(response.values):
            return  # another node may answer, which the beat asks at once
        message = response.values if isinstance(response.values, str) else ""
        if "unable to communicate with master" in message.lower():
            self._services.on_master_lost()
            self._set(CommandPath.DEAD, Message("no ROS master"))
            return
        was_dead, self.path = self.path is CommandPath.DEAD, CommandPath.ALIVE
        self._refresh()
        if was_dead or self.path is CommandPath.UNREGISTERED:
            self._services.query()

    def _refresh(self) -> None:
        """Report whether the robots' services exist, if the bridge answers at all."""
        if self.path not in (CommandPath.ALIVE, CommandPath.UNREGISTERED):
            return
        gone, absent = self._services.unregistered, self._services.without_any
        if self._services.is_total:
            self._set(CommandPath.UNREGISTERED, Message("robot nodes not registered: restart them"))
        elif gone:
            self._set(
                CommandPath.UNREGISTERED,
                Message("nodes of {some} not registered: restart them", some=some(gone)),
            )
        elif absent:
            wrong = Message(
                "no services of {some}: restart its node, or correct [profile.services]", some=some(absent)
            )
            self._set(CommandPath.UNREGISTERED, wrong)
        elif self._pulse.knows_no_node and self._services.are_unseen:
            if self._services.is_unknown_to_bridge:
                self._set(CommandPath.UNREGISTERED, NO_NODE)
            else:
                self._set(CommandPath.ALIVE, UNPROVEN if self._pulse.asks_node else UNASKED)
        else:
            self._set(CommandPath.ALIVE)

    async def _beat(self) -> None:
        beats = 0
        while True:
            began = time.monotonic()
            is_answered = False
            try:
                is_answered = await self._ask()
            except NoAnswerError:
                self._round_trips.unanswered += 1
                # An answer to another call, meanwhile, is a sign of life, too.
                if self._answered_at < began:
                    self._set(CommandPath.DEAD, NOT_ADMITTED if OWN_WORD in self._barred() else NO_REPLY)
            except LinkError:
                return
            beats += 1
            if beats % LOOK_EVERY == 0:
                self._services.query()
                if self._pulse.knows_no_node:
                    self._pulse.restart()
            await asyncio.sleep(AGAIN if not is_answered and self._pulse.is_mute else EVERY)

    async def _ask(self) -> bool:
        """Ask once; tell whether a node answered. Raises NoAnswerError if not even the bridge did, LinkError
        without a connection."""
        answer = await self._pulse.of_ros(QUICK)
        took, _ = answer or await self._calls.timed(OWN_WORD, {}, TIMEOUT)
        self._round_trips.take(took, time.monotonic())
        # Upstream issue 1144: its ROS thread has ended, the rest of it goes on.
        if answer is None and self._pulse.is_mute and self._silence() > HALF_DEAD_AFTER:
            self._set(CommandPath.DEAD, HALF_DEAD)
        elif self.path is CommandPath.UNTRIED:
            self.path = CommandPath.ALIVE
            self._refresh()
        return answer is not None

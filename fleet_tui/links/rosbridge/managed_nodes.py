"""Whether the servers that drive robots are active: asked, or read by a console that asks no node."""

import asyncio
import logging
from collections.abc import Callable, Mapping
from time import monotonic

from fleet_tui.config.schema import Config, Link
from fleet_tui.links.rosbridge.answers import decoded
from fleet_tui.links.rosbridge.calls import GRACE, Calls, NoAnswerError
from fleet_tui.links.rosbridge.services import Services
from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.links.writer import Writer
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.events import Event
from fleet_tui.model.navigation import MUTE, Servers
from fleet_tui.model.navigation_events import ServersReported
from fleet_tui.robots.adapter import Adapter
from fleet_tui.robots.probes import LifecycleProbe, lifecycle_label
from fleet_tui.robots.ros import operations
from fleet_tui.situation.causes import DIAGNOSED_WITHIN
from fleet_tui.text.errors import LinkError

LOG = logging.getLogger(__name__)

EVERY = 5.0
WITHIN = 2.0
"""Seconds between two rounds, and for an answer."""
LOOK_EVERY = 0.1
FIRST_LOOKS = 20
"""Seconds between looks on a new connection, and their number until it has the list of services and what the
managers publish once a second."""
LIST_EVERY = 30.0
"""Seconds after which a node may be gone from the list while its manager calls itself active."""


def lifecycle_probes(config: Config, adapters: Mapping[str, Adapter], link: str) -> dict[str, LifecycleProbe]:
    """Return the probes of a link by robot."""
    return {
        robot.name: one
        for robot in config.robots
        if robot.link == link
        for one in adapters[robot.name].probes(robot.name)
        if isinstance(one, LifecycleProbe)
    }


class ReadLifecycle:
    """Reads the list of services, in which a node that is down is missing, and what the managers publish:
    they go on to call themselves active while they wait for such a node. Runs on the network loop."""

    def __init__(
        self,
        probes: Mapping[str, LifecycleProbe],
        services: Services,
        counter: LinkCounter,
        apply: Callable[[Event], None],
    ) -> None:
        """`probes` by robot."""
        self._probes = probes
        self._services = services
        self._counter = counter
        self._apply = apply
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Begin on a new connection, if there is a robot to look at."""
        if self._probes:
            self._task = asyncio.ensure_future(self._run())

    async def _run(self) -> None:
        for _ in range(FIRST_LOOKS):
            await asyncio.sleep(LOOK_EVERY)
            if None not in map(self._servers, self._probes.values()):
                break
        listed_at = monotonic()
        while True:
            # A bridge that just started lists only some, and the list of a large site is large.
            if any(map(self._down, self._probes.values())) or monotonic() - listed_at > LIST_EVERY:
                await self._services.list_again()
                listed_at = monotonic()
            for robot, probe in self._probes.items():
                self._apply(ServersReported(robot, monotonic(), self._servers(probe)))
            await asyncio.sleep(EVERY)

    def _down(self, probe: LifecycleProbe) -> dict[str, str]:
        """Return the needed nodes that are not there, of a robot whose manager is."""
        listed = self._services.listed
        return probe.unlisted(listed) if probe.service in listed else {}

    def _servers(self, probe: LifecycleProbe) -> Servers | None:
        if down := self._down(probe):
            return probe.judge(MUTE, down)
        diagnosis = probe.diagnosis(self._counter.health, self._services.listed)
        if diagnosis is None or monotonic() - diagnosis.at > DIAGNOSED_WITHIN:
            return None
        return probe.judge(diagnosis, {})

    def stop(self) -> None:
        if self._task is not None:
            self._task.cancel()


class Lifecycle:
    """Asks one robot after the other, on a connection of its own: a manager that waits for one of its nodes
    does not answer, and a bridge of Humble handles nothing else on a connection until it does. Runs on the
    network loop."""

    def __init__(
        self,
        link: str,
        bridge: Link,
        probes: Mapping[str, LifecycleProbe],
        services: Services,
        writer: Writer,
        places: asyncio.Semaphore,
    ) -> None:
        """`probes` by robot; `services` as rosapi lists them: what is not there is not called, which would be
        an error in the log of the site; `places` as for Calls."""
        self._link = link
        self._probes = probes
        self._services = services
        self._writer = writer
        self._connection = Connection(bridge, self)
        self._calls = Calls(self._connection, places)
        self._task: asyncio.Task[None] | None = None

    def open(self) -> None:
        """Connect, if there is a robot to ask about."""
        if self._probes:
            self._connection.connect()

    def on_connecting(self) -> None:
        """Do nothing: a connection attempt has begun."""

    def on_open(self) -> None:
        """Start asking."""
        self._task = asyncio.ensure_future(self._run())

    def on_lost(self, reason: str, next_try_in: float) -> None:
        """Stop asking: it starts again with the next connection."""
        self._stop()
        self._calls.on_lost()

    def on_frame(self, payload: bytes, is_binary: bool) -> None:
        """Take an answer."""
        operation = decoded(self._writer.tap, self._link, payload, is_binary)
        if isinstance(operation, operations.ServiceResponse):
            self._calls.on_response(operation)

    def on_sent(self, payload: bytes) -> None:
        """Report a sent question to the tap."""
        if self._writer.tap is not None:
            self._writer.tap.on_sent(self._link, "commands", payload)

    def on_too_large(self, head: bytes, is_binary: bool, size: int) -> None:
        """Ignore it: no answer is that large."""
        LOG.warning("a reply of %d bytes was dropped", size)

    async def _run(self) -> None:
        for _ in range(FIRST_LOOKS):
            if self._services.listed:
                break
            await asyncio.sleep(LOOK_EVERY)
        while True:
            for robot, probe in self._probes.items():
                try:
                    await self._look(robot, probe)
                except NoAnswerError:
                    continue  # of rosapi
                except LinkError:
                    break  # of the topics' connection, perhaps: this one is not lost
            await asyncio.sleep(EVERY)

    async def _look(self, robot: str, probe: LifecycleProbe) -> None:
        """Ask about one robot. Raises LinkError."""
        is_there = probe.service in self._services.listed
        if not is_there or not await self._services.is_of_type(probe.service, probe.type):
            self._writer.apply(ServersReported(robot, monotonic(), None))
            return
        answer, states = await self._ask(probe.service), dict[str, str]()
        if not probe.is_active(answer):
            await self._services.list_again()
            states = probe.unlisted(self._services.listed) or await self._states(probe)
            if answer == MUTE and not states:
                return  # nothing but a manager that does not answer
        self._writer.apply(ServersReported(robot, monotonic(), probe.judge(answer, states)))

    async def _states(self, probe: LifecycleProbe) -> dict[str, str]:
        """Return the states of the nodes, as far as the first that does not answer. Raises LinkError."""
        states = dict[str, str]()
        for node, service in probe.nodes.items():
            is_there = service in self._services.listed
            if not is_there or not await self._services.is_of_type(service, probe.node_type):
                continue
            answer = await self._ask(service)
            states[node] = lifecycle_label(answer)
            if answer == MUTE:
                break
        return states

    async def _ask(self, service: str) -> object:
        """Return an answer, MUTE without one. Raises LinkError."""
        try:
            response = await self._calls.call(service, {}, WITHIN)
        except NoAnswerError:
            await asyncio.sleep(GRACE)  # until the bridge has given it up, too
            return MUTE
        return response.values if response.result else MUTE

    def _stop(self) -> None:
        if self._task is not None:
            self._task.cancel()

    def close(self) -> None:
        self._stop()
        self._calls.on_lost()
        self._connection.shut()

"""The robots' services as rosapi lists them: names and types."""

import asyncio
import logging
import time
from collections.abc import Callable, Collection, Iterable, Mapping, Set
from contextlib import suppress

from fleet_tui.config.fleet import Service
from fleet_tui.links.rosbridge.calls import Calls, NoAnswerError
from fleet_tui.links.rosbridge.probes import is_unknown
from fleet_tui.robots.ros.operations import ServiceResponse
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.errors import LinkError
from fleet_tui.text.language import Message
from fleet_tui.text.limits import truncate

LOG = logging.getLogger(__name__)

SETTLE_TIME = 3.0
"""Seconds on a new connection for which commands wait for the types of services: a real rosapi needs more
than one for those of a fleet, and `{}` on another type may be a command."""
ROSAPI_TIMEOUT = 5.0
RETRY_AFTER = 5.0
"""Seconds after which rosapi is asked again if it did not answer: it may have been busy."""


class Services:
    """Known services of one bridge's robots. Runs on the network loop.

    A bridge passes a call on to any service of that name: `{}` is a command to some servers. So a call of
    another type must not be sent; an unknown type is no reason to hold it back.
    """

    def __init__(self, calls: Calls, wanted: Mapping[str, Service], has_actions: bool = False) -> None:
        """`wanted` are the services by name; `has_actions`: action servers are asked for, too."""
        self._calls = calls
        self._wanted = wanted
        self._has_actions = has_actions
        self._servers: Set[str] | None = None
        self.listed: frozenset[str] = frozenset()
        """All services that rosapi listed last."""
        self._types: dict[str, str] = {}
        self._confirmed: set[str] = set()
        """Services whose types rosapi has confirmed on this connection."""
        self._seen: set[str] = set()
        self._missing: set[str] = set()
        self._missed_once: set[str] = set()
        self._absent: set[str] = set()
        """Robots without a service listed by rosapi, although they may send messages."""
        self._active: set[str] = set()
        self._unknown: set[str] = set()
        """Services that were called and did not exist."""
        self._rosapi_answered = False
        self._master_was_lost = False
        self._begun = -SETTLE_TIME
        self._listed = asyncio.Event()
        self._task: asyncio.Task[None] | None = None
        self.changed: Callable[[], None] = lambda: None
        """Called when services disappear or reappear."""

    @property
    def unregistered(self) -> list[str]:
        """The robots whose services existed and no longer do, by name."""
        return sorted({self._wanted[name].robot for name in self._missing})

    @property
    def is_total(self) -> bool:
        """Tell whether that holds for every robot whose services were ever seen."""
        return bool(self._missing) and self._missing == self._seen

    @property
    def are_unseen(self) -> bool:
        """Tell whether the robots need services, and none of them was ever seen."""
        return bool(self._wanted) and not self._seen

    @property
    def is_unknown_to_bridge(self) -> bool:
        """Tell whether the bridge said of a robot's service that was called that it does not exist."""
        return bool(self._unknown)

    @property
    def without_any(self) -> list[str]:
        """The robots that send messages but never had a service, by name."""
        return sorted(self._absent & self._active)

    def note_active(self, robots: Collection[str]) -> None:
        """Record the robots that send messages."""
        if not self._absent <= self._active and self._absent & set(robots) - self._active:
            self._active |= set(robots)
            self.changed()

    def query(self) -> None:
        """Query rosapi, unless a query is open."""
        if self._task is None or self._task.done():
            self._task = asyncio.ensure_future(self._query())

    def recheck_types(self) -> None:
        """Query the types again: a new connection may lead to other nodes. The earlier types hold until the
        answer: no call is sent in between."""
        self._confirmed.clear()
        self.stop()
        self._begun = time.monotonic()
        self._listed.clear()
        self.query()

    @property
    def is_new(self) -> bool:
        """Tell whether this connection has no list yet, and is too new to go without."""
        is_young = self._task is None or time.monotonic() - self._begun < SETTLE_TIME
        return is_young and not self._listed.is_set()

    async def settle(self) -> None:
        """Wait for the first query, up to its time limit."""
        with suppress(TimeoutError):
            await asyncio.wait_for(self._listed.wait(), SETTLE_TIME)

    async def learn(self, names: Iterable[str], calls: Calls, within: float) -> None:
        """Ask over `calls`, for at most `within` seconds, for the types of services that this connection has
        not told yet."""
        with suppress(TimeoutError, LinkError):
            async with asyncio.timeout(within):
                await self._ask_types(self._wanted.keys() & {*names} - self._confirmed, calls)

    def stop(self) -> None:
        if self._task is not None:
            self._task.cancel()
            self._task = None

    def on_master_lost(self) -> None:
        """Note that the ROS master was lost: a new one knows none of the earlier nodes."""
        self._master_was_lost = True

    def on_answer(self, service: str, values: object, result: bool) -> None:
        """Take an answer to a call of a robot's service as evidence of its existence."""
        if service not in self._wanted:
            return
        if not result and is_unknown(values):
            self._unknown.add(service)
            self._set_missing(self._missing | ({service} & self._seen))
            self.changed()
            self.query()
        elif result:
            robot = self._wanted[service].robot
            self._seen.add(service)
            self._unknown.discard(service)
            self._absent.discard(robot)
            self._set_missing({name for name in self._missing if self._wanted[name].robot != robot})

    def _set_missing(self, missing: set[str]) -> None:
        if missing != self._missing:
            self._missing = missing
            self.changed()

    def mismatch(self, service: str) -> str:
        """Return the reason not to call a service; empty if there is no known one."""
        found = self._types.get(service, "")
        if not found:
            return ""
        expected = self._wanted[service].type
        if same_type(found, expected):
            return ""
        # Another node may offer it by now: the next call uses the current type.
        self.query()
        return Message(
            "{service} has type {actual}, not {expected}", service=service, actual=found, expected=expected
        )

    def lacks_server(self, action: str) -> bool:
        """Tell whether rosapi lists the action servers, and this one is not among them."""
        return self._servers is not None and action not in self._servers

    async def list_again(self) -> None:
        """Wait for a new list, if rosapi gives one in time."""
        self.query()
        if self._task is not None:
            await asyncio.wait((self._task,), timeout=ROSAPI_TIMEOUT)

    async def is_of_type(self, service: str, type_: str) -> bool:
        """Tell whether rosapi says that a service is of a type. Raises LinkError."""
        if service not in self._types:
            await self._ask_type(service, self._calls)
        return same_type(self._types.get(service, ""), type_)

    async def _query(self) -> None:
        while True:
            try:
                await self._take_services(await self._ask("services", {}))
                if self._has_actions:
                    self._take_servers(await self._ask("action_servers", {}))
            except NoAnswerError as problem:
                LOG.info("services not looked up yet: %s", problem)
            except LinkError:
                return
            else:
                self._listed.set()
                return
            await asyncio.sleep(RETRY_AFTER)

    async def _take_services(self, response: ServiceResponse) -> None:
        if not response.result or not isinstance(response.values, dict):
            if self._rosapi_answered and self._master_was_lost and is_unknown(response.values):
                # rosapi is a node like the robots': the new master knows none of them.
                self._set_missing(set(self._seen))
            return
        listed = response.values.get("services")
        if not isinstance(listed, list):
            return
        self.listed = frozenset(name for name in listed if isinstance(name, str))
        there = self._wanted.keys() & self.listed
        self._rosapi_answered = True
        self._master_was_lost = False
        self._seen |= there
        ever = {self._wanted[name].robot for name in self._seen}
        absent, self._absent = self._absent, {one.robot for one in self._wanted.values()} - ever
        self._confirmed &= there
        self._miss(self._seen - there)
        if absent != self._absent:
            self.changed()
        await self._ask_types([name for name in self._wanted if name in there - self._confirmed], self._calls)

    def _take_servers(self, response: ServiceResponse) -> None:
        listed = response.values.get("action_servers") if isinstance(response.values, dict) else None
        is_list = response.result and isinstance(listed, list)
        self._servers = {str(name) for name in listed or ()} if is_list else None

    def _miss(self, missing: set[str]) -> None:
        """Drop services that two queries in a row missed: a bridge that just started lists only some."""
        first, self._missed_once = missing - self._missed_once - self._missing, missing
        self._set_missing(missing - first)
        if first:
            asyncio.get_running_loop().call_later(RETRY_AFTER, self.query)

    async def _ask_types(self, names: Iterable[str], calls: Calls) -> None:
        for name in names:
            found = await self._ask_type(name, calls)
            if found and same_type(found, self._wanted[name].type):
                self._confirmed.add(name)

    async def _ask_type(self, name: str, calls: Calls) -> str:
        response = await calls.call("/rosapi/service_type", {"service": name}, ROSAPI_TIMEOUT)
        found = response.values.get("type") if isinstance(response.values, dict) else None
        if not (response.result and isinstance(found, str) and found):
            return ""
        self._types[name] = truncate(found)
        return found

    async def _ask(self, question: str, args: Mapping[str, object]) -> ServiceResponse:
        """Query rosapi. Raises LinkError."""
        return await self._calls.call(f"/rosapi/{question}", args, ROSAPI_TIMEOUT)

"""The robots' logs and diagnostics: subscribed while they are on screen or may tell a cause."""

import asyncio
from collections.abc import Awaitable, Callable, Mapping

from fleet_tui.links.transports.rosbridge.connection import Connection
from fleet_tui.robots.ros import operations
from fleet_tui.robots.ros.logs import HEALTH_TYPES, LOG_TYPES
from fleet_tui.robots.ros.reading import DIAGNOSTICS, ROSOUT
from fleet_tui.text.errors import LinkError

# The types in ROS 1 and in ROS 2.
TYPES = {ROSOUT: LOG_TYPES, DIAGNOSTICS: HEALTH_TYPES}
# Seconds for which the log of a bridge of ROS 2 is read after a request for topics: only there it reports
# the topics to which it could not subscribe.
COMPLAINTS_FOR = 10.0
# Queue length at the bridge: robots log several lines at once.
QUEUE = 100


class LogSubscription:
    """Runs on the network loop. `ask_types` returns type by topic, as rosapi reports. `reads_health`:
    diagnostics that rosapi lists are read all the time."""

    def __init__(
        self,
        connection: Connection,
        ask_types: Callable[[], Awaitable[Mapping[str, str]]],
        reads_health: bool = False,
    ) -> None:
        self._connection = connection
        self._ask_types = ask_types
        self._always = {DIAGNOSTICS} if reads_health else set[str]()
        self._wanted = False
        # A task without a reference may be garbage-collected while it runs.
        self._task: asyncio.Task[None] | None = None

    def listen(self, wanted: bool) -> None:
        """Subscribe now and on each further connection, or unsubscribe."""
        if wanted == self._wanted:
            return
        self._wanted = wanted
        if not self._connection.is_connected:
            return
        if wanted:
            self._task = asyncio.ensure_future(self._find_out())
        else:
            for topic in TYPES:
                if topic not in self._always:
                    self._send(operations.unsubscribe(topic))

    async def _find_out(self) -> None:
        self.subscribe(await self._ask_types())

    def subscribe(self, types: Mapping[str, str]) -> None:
        """Subscribe if requested, also to topics without a publisher so far."""
        is_ros2 = any("/msg/" in type_ for type_ in types.values())
        for topic, (ros1, ros2) in TYPES.items():
            is_always = topic in self._always and topic in types
            if self._wanted or is_always or (is_ros2 and topic == ROSOUT):
                type_ = types.get(topic) or (ros2 if is_ros2 else ros1)
                self._send(operations.subscribe(operations.Subscription(topic, type_, queue_length=QUEUE)))
        if is_ros2 and not self._wanted:
            asyncio.get_running_loop().call_later(COMPLAINTS_FOR, self._let_go)

    def _let_go(self) -> None:
        if not self._wanted:
            self._send(operations.unsubscribe(ROSOUT))

    def _send(self, frame: bytes) -> None:
        try:
            self._connection.send(frame)
        except LinkError:
            return

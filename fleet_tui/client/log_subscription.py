"""The robots' log and health, which change nothing in the picture: asked for only while somebody looks."""

import asyncio
from collections.abc import Awaitable, Callable, Mapping

from fleet_tui.adapters.ros import operations
from fleet_tui.adapters.ros.reading import DIAGNOSTICS, ROSOUT
from fleet_tui.adapters.ros.robot_words import HEALTH_TYPES, LOG_TYPES
from fleet_tui.errors import LinkError
from fleet_tui.transports.rosbridge.connection import Connection

# The types in ROS 1 and in ROS 2.
TYPES = {ROSOUT: LOG_TYPES, DIAGNOSTICS: HEALTH_TYPES}
# Seconds for which the log of a bridge of ROS 2 is heard after it was asked for topics: only there it says
# which of them it could not subscribe.
COMPLAINTS_FOR = 10.0
# Messages that the bridge keeps for us: robots say several lines at once.
QUEUE = 100


class LogSubscription:
    """Runs on the network loop. `ask_types` gives type by topic, as rosapi tells."""

    def __init__(self, connection: Connection, ask_types: Callable[[], Awaitable[Mapping[str, str]]]) -> None:
        self._connection, self._ask_types = connection, ask_types
        self._wanted = False
        # A task that nobody holds may be collected in the middle.
        self._task: asyncio.Task[None] | None = None

    def listen(self, wanted: bool) -> None:
        """Ask for them now and on each further connection, or no longer."""
        if wanted == self._wanted:
            return
        self._wanted = wanted
        if not self._connection.is_connected:
            return
        if wanted:
            self._task = asyncio.ensure_future(self._find_out())
        else:
            for topic in TYPES:
                self._send(operations.unsubscribe(topic))

    async def _find_out(self) -> None:
        self.subscribe(await self._ask_types())

    def subscribe(self, types: Mapping[str, str]) -> None:
        """Ask for them, if they are wanted; what nobody publishes yet may still come."""
        is_ros2 = any("/msg/" in type_ for type_ in types.values())
        for topic, (ros1, ros2) in TYPES.items():
            if self._wanted or (is_ros2 and topic == ROSOUT):
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

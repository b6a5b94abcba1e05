"""Questions that show whether a bridge lives. As long as its ROS thread does, none of them is an error in the
log of its site: an unknown service is one each time."""

from collections.abc import Mapping

from fleet_tui.links.rosbridge.calls import OWN_WORD, TIME, Calls, NoAnswerError
from fleet_tui.robots.ros.operations import ServiceResponse

OF_NODE: Mapping[str, Mapping[str, object]] = {
    "/rosbridge_websocket/get_parameters": {"names": []},
    "/rosbridge_websocket/get_loggers": {},
}
"""Services that every node has, of ROS 2 and ROS 1, asked of the bridge's own: for bridges without rosapi."""
EVERY_QUESTION = (TIME, *OF_NODE, OWN_WORD)


class Pulse:
    """Asks over one connection. Runs on the network loop."""

    def __init__(self, calls: Calls, asks_node: bool = True) -> None:
        """`asks_node`: else only rosapi is asked, as by a console that may only read."""
        self._calls = calls
        self.asks_node = asks_node
        self._questions: dict[str, Mapping[str, object]] = {TIME: {}, **(OF_NODE if asks_node else {})}
        self._absent: set[str] = set()
        """Services that this bridge does not know: asked once on each connection."""

    def restart(self) -> None:
        """A new connection may lead to another bridge."""
        self._absent.clear()

    async def of_ros(self, patience: float, skip: str = "") -> tuple[float, ServiceResponse] | None:
        """Return the first answer of a node, with the seconds that it took, None if no node answers. Raises
        LinkError without a connection."""
        for service, args in self._questions.items():
            if service in self._absent or service == skip:
                continue
            try:
                took, response = await self._calls.timed(service, args, patience)
            except NoAnswerError:
                continue
            if response.result:
                return took, response
            if is_unknown(response.values):
                self._absent.add(service)
        return None

    @property
    def is_mute(self) -> bool:
        """Tell whether the bridge's own node is there and does not answer, as far as known; or rosapi, where
        only that may be asked."""
        asked = self._questions.keys() & OF_NODE.keys() or {TIME}
        return not asked <= self._absent

    @property
    def knows_no_node(self) -> bool:
        """Tell whether no node is there of those that may be asked: rosapi, and the bridge's own."""
        return self._questions.keys() <= self._absent


def is_unknown(values: object) -> bool:
    """Tell whether an answer is the bridge's word that there is no such service."""
    return isinstance(values, str) and values.endswith("does not exist")

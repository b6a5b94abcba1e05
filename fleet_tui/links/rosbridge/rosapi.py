"""What rosapi tells about topics."""

import logging

from fleet_tui.links.rosbridge.calls import Calls
from fleet_tui.links.rosbridge.set_up.listeners import ask, is_bridge
from fleet_tui.text.errors import LinkError

LOG = logging.getLogger(__name__)

ROSAPI_TIMEOUT = 2.0


async def topic_types(calls: Calls) -> dict[str, str]:
    """Return type by topic, as rosapi lists them; empty if it does not answer."""
    try:
        response = await calls.call("/rosapi/topics", {}, ROSAPI_TIMEOUT)
    except LinkError as problem:
        LOG.info("types not checked: %s", problem)
        return {}
    values = response.values
    if not response.result or not isinstance(values, dict):
        LOG.info("types not checked: %s", values)
        return {}
    topics, types = values.get("topics"), values.get("types")
    if not isinstance(topics, list) or not isinstance(types, list):
        return {}
    return {str(topic): str(type_) for topic, type_ in zip(topics, types, strict=False)}


async def lacks_bridge(calls: Calls, topic: str) -> bool:
    """Tell whether a node publishes a topic, and no bridge is subscribed to it, as far as rosapi tells."""
    if not await publishers(calls, topic):
        return False
    nodes = await ask(calls, "subscribers", {"topic": topic}, "subscribers", ROSAPI_TIMEOUT)
    return isinstance(nodes, list) and not any(map(is_bridge, nodes))


async def publishers(calls: Calls, topic: str) -> int:
    """Return the number of nodes that publish a topic, 0 if rosapi does not tell."""
    try:
        response = await calls.call("/rosapi/publishers", {"topic": topic}, ROSAPI_TIMEOUT)
    except LinkError as problem:
        LOG.info("publishers not looked up: %s", problem)
        return 0
    nodes = response.values.get("publishers") if isinstance(response.values, dict) else None
    return len(nodes) if response.result and isinstance(nodes, list) else 0

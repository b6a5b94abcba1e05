"""The other end of a set-up command, as rosapi knows it: whatever is published with a wrong type, or to no
listener, is lost without a word."""

from collections.abc import Sequence

from fleet_tui.adapters.adapter import Outgoing, Publication, ServiceCall
from fleet_tui.adapters.ros.type_names import same_type
from fleet_tui.client.calls import Calls
from fleet_tui.errors import CommandError, LinkError

WITHIN = 0.4
"""Seconds for each answer of rosapi; a command goes out without them."""
BRIDGE = "rosbridge"
"""Part of the names of bridges, which listen for their clients."""


Args = dict[str, object]


async def check_listeners(calls: Calls, outgoing: Sequence[Outgoing]) -> None:
    """Raise CommandError for a message that no node would take."""
    for one in outgoing:
        if isinstance(one, Publication):
            await _check(calls, one, "topic_type", {"topic": one.address})
            nodes = await _ask(calls, "subscribers", {"topic": one.address}, "subscribers")
            if isinstance(nodes, list) and all(BRIDGE in str(node) for node in nodes):
                raise CommandError(f"nobody listens on {one.address}")
        elif isinstance(one, ServiceCall):
            await _check(calls, one, "service_type", {"service": one.address})


async def _check(calls: Calls, one: Publication | ServiceCall, question: str, args: Args) -> None:
    found = await _ask(calls, question, args, "type")
    if isinstance(found, str) and found and not same_type(found, one.type):
        raise CommandError(f"{one.address} has type {found[:100]}, not {one.type}")


async def _ask(calls: Calls, question: str, args: Args, field: str) -> object:
    """Return a field of rosapi's answer, None without one."""
    try:
        answer = await calls.call(f"/rosapi/{question}", args, WITHIN)
    except LinkError:
        return None
    return answer.values.get(field) if answer.result and isinstance(answer.values, dict) else None

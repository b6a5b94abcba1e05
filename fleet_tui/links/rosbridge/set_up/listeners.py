"""The other end of a set-up command, as rosapi knows it: whatever is published with a wrong type, or to no
listener, is lost without a word."""

import asyncio
from collections.abc import Sequence

from fleet_tui.links.rosbridge.calls import Calls
from fleet_tui.robots.adapter import Outgoing, Publication, ServiceCall
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.errors import CommandError, LinkError
from fleet_tui.text.language import Message

WITHIN = 0.3
"""Seconds for all answers of rosapi, so that no command gets too old; it goes out without them."""
BRIDGE = "rosbridge"
"""Part of the names of bridges, which listen for their clients."""


Args = dict[str, object]


async def check_listeners(calls: Calls, outgoing: Sequence[Outgoing]) -> None:
    """Raise CommandError for a message that no node would take."""
    for one in outgoing:
        if isinstance(one, Publication):
            named: Args = {"topic": one.address}
            type_, nodes = await asyncio.gather(
                ask(calls, "topic_type", named, "type"), ask(calls, "subscribers", named, "subscribers")
            )
            _check_type(one, type_)
            if isinstance(nodes, list) and all(map(is_bridge, nodes)):
                raise CommandError(Message("nobody listens on {address}", address=one.address))
        elif isinstance(one, ServiceCall):
            _check_type(one, await ask(calls, "service_type", {"service": one.address}, "type"))


def is_bridge(node: object) -> bool:
    """Tell whether a node is a bridge, which listens for its own clients."""
    return BRIDGE in str(node)


def _check_type(one: Publication | ServiceCall, found: object) -> None:
    if isinstance(found, str) and found and not same_type(found, one.type):
        raise CommandError(
            Message(
                "{address} has type {actual}, not {type}",
                address=one.address,
                actual=found[:100],
                type=one.type,
            )
        )


async def ask(calls: Calls, question: str, args: Args, field: str, within: float = WITHIN) -> object:
    """Return a field of rosapi's answer, None without one within some seconds."""
    try:
        answer = await calls.call(f"/rosapi/{question}", args, within)
    except LinkError:
        return None
    return answer.values.get(field) if answer.result and isinstance(answer.values, dict) else None

"""The topic that a drive publishes on, as rosapi knows it: its type, and whether a robot listens."""

import asyncio

from fleet_tui.adapters.ros.set_up.names import STAMPED_TWIST, TWIST
from fleet_tui.adapters.ros.set_up.twists import is_stamped
from fleet_tui.client.rosbridge.calls import Calls
from fleet_tui.client.rosbridge.set_up.listeners import ask, is_bridge
from fleet_tui.errors import CommandError
from fleet_tui.text.limits import truncate

WITHIN = 1.0
"""Seconds for the answers of rosapi. Without them no drive begins."""


async def twist_type(calls: Calls, topic: str) -> str:
    """Return the type of a topic on which a robot takes twists. Raises CommandError."""
    type_, nodes = await asyncio.gather(
        ask(calls, "topic_type", {"topic": topic}, "type", WITHIN),
        ask(calls, "subscribers", {"topic": topic}, "subscribers", WITHIN),
    )
    if not isinstance(type_, str) or not isinstance(nodes, list):
        raise CommandError(f"rosapi does not tell who listens on {topic}")
    if all(is_bridge(node) for node in nodes):
        raise CommandError(f"nobody listens on {topic}")
    if is_stamped(type_) is None:
        raise CommandError(f"{topic} has type {truncate(type_)}, not {TWIST} or {STAMPED_TWIST}")
    return type_

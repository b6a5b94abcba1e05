"""Lag: whether this console or a bridge is late, by the answers of the bridges."""

from collections.abc import Mapping

from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState
from fleet_tui.situation.links import LATE_FROM

STEP = 0.1
"""Seconds by which a lag must differ to be updated."""


def with_lags(state: FleetState, unread: float) -> FleetState:
    """Update the lag of the console and the links. `unread`: seconds that the oldest unread message has
    waited.

    If it waits long, all lateness is this console's own: the answers of bridges wait unread, too. An answer
    to a question from before the end of that says nothing about its bridge.
    """
    if unread >= LATE_FROM:
        own = max([unread, *(link.lag for link in state.links.values())])
        state = replace(state, behind=own, behind_at=state.now)
        return replace(state, links=_late(state.links, dict.fromkeys(state.links, 0.0)))
    lags = {
        name: max(0.0, link.lag - unread) if link.asked_at > state.behind_at else 0.0
        for name, link in state.links.items()
    }
    return replace(state, behind=unread, links=_late(state.links, lags))


def _late(links: Mapping[str, LinkState], lags: Mapping[str, float]) -> Mapping[str, LinkState]:
    if all(abs(link.late - lags[name]) < STEP for name, link in links.items()):
        return links
    return {name: replace(link, late=lags[name]) for name, link in links.items()}

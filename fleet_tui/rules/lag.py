"""Lag: the delay of the shown values, and its cause."""

import statistics
from collections.abc import Mapping

from msgspec.structs import replace

from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState, Phase

FRESH = 2.0
"""Maximum age in seconds of a pose whose stamp is used for the lag."""
BEHIND = 1.0
"""Seconds from which this console, or a bridge, counts as behind."""
STEP = 0.1
"""Seconds by which a lag must differ to be updated."""


def stamp_lag(state: FleetState, link: str, now: float) -> float:
    """Return the seconds by which the current poses of a link are late, by their stamps: the median."""
    lags = [
        robot.clock.at - robot.pose.at
        for robot in state.robots.values()
        if robot.link == link and robot.clock and robot.pose and now - robot.clock.at < FRESH
    ]
    return statistics.median(lags) if lags else 0.0


def is_overloaded(link: LinkState) -> bool:
    """Tell whether messages of a bridge are late: that explains old robots and lost replies."""
    return link.phase is Phase.UP and link.late >= BEHIND


def with_lags(state: FleetState, now: float, unread: float) -> FleetState:
    """Update the lag of the console and the links. `unread`: seconds that the oldest unread message has
    waited.

    If it waits long, all lateness is this console's own: messages of the links are late because they are
    unread.
    """
    lags = {name: stamp_lag(state, name, now) for name in state.links}
    if unread < BEHIND:
        return replace(state, behind=unread, links=_late(state.links, lags))
    own = max([unread, *lags.values()])
    return replace(state, behind=own, links=_late(state.links, dict.fromkeys(lags, 0.0)))


def _late(links: Mapping[str, LinkState], lags: Mapping[str, float]) -> Mapping[str, LinkState]:
    if all(abs(link.late - lags[name]) < STEP for name, link in links.items()):
        return links
    return {name: replace(link, late=lags[name]) for name, link in links.items()}

"""The queries of rosapi by which robots are recognised: few, and never many at once."""

import time
from collections.abc import Callable
from dataclasses import replace

from fleet_tui.links.discovery.facts import RosapiFacts
from fleet_tui.links.discovery.rosapi import ask_publishers, ask_service_types
from fleet_tui.links.discovery.sampling import alike, next_questions, silent, telling_services, telling_topics
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.robots.discovery import Listed
from fleet_tui.text.language import Message

MOST_TOPICS = 300
MOST_SERVICES = 100
"""Maximum number of queries: 8 s of a real bridge. The rest is taken as listed."""

Watch = Callable[[int, int, Message], object]
"""Progress callback: number done, number known, current step."""


async def listed_by(
    wire: BridgeConnection, rosapi: RosapiFacts, until: float, watch: Watch
) -> tuple[Listed, RosapiFacts]:
    """Return the published topics and offered services, as far as can be queried until the monotonic
    `until`."""
    rosapi = await _with_publishers(wire, rosapi, until, watch)
    groups = alike(telling_topics(rosapi.topics))
    unheard = {name for spaces in groups for name in silent(spaces, rosapi.publishers)}
    published = {name: type_ for name, type_ in rosapi.topics.items() if name not in unheard}
    services = await _service_types(wire, rosapi, until, watch)
    heard = {name: type_ for name, type_ in rosapi.topics.items() if name in unheard}
    return Listed(published, services, rosapi.actions, heard), replace(rosapi, topics=published)


async def _with_publishers(
    wire: BridgeConnection, rosapi: RosapiFacts, until: float, watch: Watch
) -> RosapiFacts:
    groups, done = alike(telling_topics(rosapi.topics)), 0
    while done < MOST_TOPICS and time.monotonic() < until:
        names = [name for spaces in groups for name in next_questions(spaces, rosapi.publishers)]
        names = names[: MOST_TOPICS - done]
        known = len(rosapi.publishers)
        count = _Count(done, done + len(names), watch, Message("looking up publishers"))
        rosapi = await ask_publishers(wire, rosapi, names, until, count)
        done += len(names)
        if len(rosapi.publishers) == known:  # all queries are done, or none is answered
            break
    return rosapi


async def _service_types(
    wire: BridgeConnection, rosapi: RosapiFacts, until: float, watch: Watch
) -> dict[str, str]:
    """Return the types of services by name, "" if unknown: each robot's as those of a similar one."""
    groups = alike(telling_services(rosapi.services))
    names = [name for spaces in groups for name in spaces[0].values()][:MOST_SERVICES]
    count = _Count(0, len(names), watch, Message("looking up service types"))
    known = (await ask_service_types(wire, rosapi, names, until, count)).services
    return {
        name: known[spaces[0][rest]] or ""
        for spaces in groups
        for space in spaces
        for rest, name in space.items()
    }


class _Count:
    """Counts the answers for the progress callback."""

    def __init__(self, done: int, total: int, watch: Watch, doing: Message) -> None:
        self._done = done
        self._total = total
        self._watch = watch
        self._doing = doing

    def __call__(self) -> None:
        self._done += 1
        self._watch(self._done, self._total, self._doing)

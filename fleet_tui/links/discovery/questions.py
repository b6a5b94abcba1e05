"""The queries of rosapi by which robots are recognised: few, and never many at once."""

import time
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace

from fleet_tui.links.discovery.facts import RosapiFacts
from fleet_tui.links.discovery.rosapi import ask_publishers, ask_service_types
from fleet_tui.links.discovery.wire import BridgeConnection
from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.registry import KINDS
from fleet_tui.robots.ros.set_up import names as set_up
from fleet_tui.robots.ros.type_names import same_type
from fleet_tui.text.language import Message

EXAMPLES = 2
"""Number of similar robots that are queried completely."""

OF_EVERY_NODE = (
    "describe_parameters",
    "get_parameter_types",
    "get_parameters",
    "list_parameters",
    "set_parameters",
    "set_parameters_atomically",
    "get_type_description",
    "get_loggers",
    "set_logger_level",
    "change_state",
    "get_state",
    "get_available_states",
    "get_available_transitions",
    "get_transition_graph",
)
"""Services without information on a robot, the last parts of their names."""

Publishers = Mapping[str, tuple[str, ...]]
Space = Mapping[str, str]
"""The names in one namespace, by their relative name."""
Alike = Sequence[Space]
"""Namespaces that hold the same names with the same types."""


def telling_topics(topics: Mapping[str, str]) -> dict[str, str]:
    """Return the topics of types that some kind of robots has: the others carry no information, nor do those
    that only set-up uses."""
    types = {
        type_
        for kind in KINDS.values()
        for key, (_, type_) in kind.vocabulary.topics.items()
        if key not in set_up.TOPICS
    }
    known = {other: any(same_type(other, type_) for type_ in types) for other in set(topics.values())}
    return {name: type_ for name, type_ in topics.items() if known[type_]}


def telling_services(services: Collection[str]) -> dict[str, str]:
    """Return the services that may be a robot's own, with empty types."""
    return {
        name: ""
        for name in services
        if not name.startswith(("/rosapi/", "/rosbridge_")) and name.rpartition("/")[2] not in OF_EVERY_NODE
    }


def alike(names: Mapping[str, str]) -> list[Alike]:
    """Group similar namespaces of robots, those first that have more than plain values. `names` with their
    types."""
    depth = _depth(names)
    spaces = dict[str, dict[str, str]]()
    for name in sorted(names):
        parts = name.strip("/").split("/")
        space = "/".join(parts[:depth]) if len(parts) > depth else ""
        spaces.setdefault(space, {})[name.removeprefix(f"/{space}/")] = name
    found = dict[frozenset[tuple[str, str]], list[Space]]()
    for held in spaces.values():
        found.setdefault(frozenset((rest, names[name]) for rest, name in held.items()), []).append(held)
    return [found[held] for held in sorted(found, key=_is_plain)]


def _is_plain(held: Collection[tuple[str, str]]) -> bool:
    return all(type_.startswith("std_msgs/") for _, type_ in held)


def _depth(names: Mapping[str, str]) -> int:
    """Return the number of parts in the names of robots: two if all share the first part."""
    first = {name.strip("/").split("/")[0] for name in names if name.count("/") > 1}
    return 2 if len(first) == 1 else 1


def next_questions(spaces: Alike, publishers: Publishers) -> list[str]:
    """Return the topics to query next: everything of the first robots until some of them exist, then one
    topic of each other robot, to see whether it exists."""
    there = _examples(spaces, publishers)
    if len(there) < EXAMPLES:
        unknown = [space for space in spaces if not _is_known(space, publishers)]
        names = [name for space in unknown[: EXAMPLES - len(there)] for name in space.values()]
    else:
        sign = _sign(there[0], publishers)
        names = [space[sign] for space in spaces]
    return [name for name in names if name not in publishers]


def silent(spaces: Alike, publishers: Publishers) -> Iterator[str]:
    """Yield the topics that are listed and not published: a console that subscribes to one keeps it
    listed."""
    there = _examples(spaces, publishers)
    for space in spaces:
        is_gone = bool(there) and publishers.get(space[_sign(there[0], publishers)]) == ()
        for rest, name in space.items():
            unlike = len(there) == EXAMPLES and not any(publishers[one[rest]] for one in there)
            if not publishers[name] if name in publishers else is_gone or unlike:
                yield name


def _examples(spaces: Alike, publishers: Publishers) -> list[Space]:
    known = (space for space in spaces if _is_known(space, publishers))
    return [space for space in known if any(publishers[name] for name in space.values())][:EXAMPLES]


def _is_known(space: Space, publishers: Publishers) -> bool:
    return all(name in publishers for name in space.values())


def _sign(example: Space, publishers: Publishers) -> str:
    """Return the first topic that a robot publishes."""
    return next(rest for rest, name in example.items() if publishers[name])


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
